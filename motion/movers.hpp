// SPDX-License-Identifier: MIT
/// @file
/// The registry of movements: one line an accelerator, beside protocol/accelerators.hpp.
#pragma once

#include "motion/marcher.hpp"
#include "motion/mover.hpp"
#include "protocol/accelerators.hpp"

#include <array>

namespace raymarch::motion
{

inline constexpr std::array movers = {
    MoverRow{&protocol::marcher::description,
             make_mover<marcher::enter, marcher::step, marcher::leave>},
};

/// A mover for that accelerator; nullptr where nothing moves.
[[nodiscard]] inline std::unique_ptr<Mover> mover_of(const protocol::Accelerator& description)
{
    for (const MoverRow& row : movers)
        if (row.description == &description)
            return row.make();
    return nullptr;
}

} // namespace raymarch::motion
