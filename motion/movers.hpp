// SPDX-License-Identifier: MIT
/// @file
/// The registry of movements. It has one line for each accelerator, as protocol/accelerators.hpp
/// has.
#pragma once

#include "motion/fractal.hpp"
#include "motion/mandelbulb.hpp"
#include "motion/marcher.hpp"
#include "motion/mover.hpp"
#include "motion/sphere.hpp"
#include "motion/whitted.hpp"
#include "protocol/accelerators.hpp"

#include <array>

namespace raymarch::motion
{

inline constexpr std::array movers = {
    MoverRow{&protocol::marcher::description,
             make_mover<marcher::enter, marcher::step, marcher::leave>},
    MoverRow{&protocol::fractal::description,
             make_mover<fractal::enter, fractal::step, fractal::leave>},
    MoverRow{&protocol::sphere::description,
             make_mover<sphere::enter, sphere::step, sphere::leave>},
    MoverRow{&protocol::mandelbulb::description,
             make_mover<mandelbulb::enter, mandelbulb::step, mandelbulb::leave>},
    MoverRow{&protocol::whitted::description,
             make_mover<whitted::enter, whitted::step, whitted::leave>},
};

static_assert(protocol::has_all_accelerators(movers), "one line for each accelerator");

/// Makes a mover for an accelerator. One that is in no registry ends the program, as position_of()
/// says.
[[nodiscard]] inline std::unique_ptr<Mover> mover_of(const protocol::Accelerator& description)
{
    return movers[protocol::position_of(description)].make();
}

} // namespace raymarch::motion
