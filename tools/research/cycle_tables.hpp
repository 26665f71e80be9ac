// SPDX-License-Identifier: MIT
/// @file
/// Compares the speeds that the sources print with those of the models, as Markdown for
/// docs/cycles.md.
#pragma once

#include "protocol/accelerators.hpp"

#include <array>
#include <string>

namespace raymarch::tools
{

// Each function draws the views of its table; 0 threads means one for each processor.
[[nodiscard]] std::string marcher_tables(unsigned threads);
[[nodiscard]] std::string fractal_tables(unsigned threads);
[[nodiscard]] std::string sphere_tables(unsigned threads);
[[nodiscard]] std::string mandelbulb_tables(unsigned threads);
[[nodiscard]] std::string whitted_tables(unsigned threads);

struct CycleTables
{
    const protocol::Accelerator* accelerator;
    std::string (*make)(unsigned threads);
};

/// Each accelerator has one row.
inline constexpr std::array cycle_tables = {
    CycleTables{&protocol::marcher::description, marcher_tables},
    CycleTables{&protocol::fractal::description, fractal_tables},
    CycleTables{&protocol::sphere::description, sphere_tables},
    CycleTables{&protocol::mandelbulb::description, mandelbulb_tables},
    CycleTables{&protocol::whitted::description, whitted_tables},
};

} // namespace raymarch::tools
