// SPDX-License-Identifier: MIT
/// @file
/// The registry of descriptions. It has one line for each accelerator.
#pragma once

#include "protocol/accelerators/fractal.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/accelerators/sphere.hpp"
#include "protocol/accelerators/whitted.hpp"
#include "protocol/parameters.hpp"

namespace raymarch::protocol
{

inline constexpr std::array accelerators = {
    &marcher::description,    &fractal::description, &sphere::description,
    &mandelbulb::description, &whitted::description,
};

/// The accelerator that is active if neither the hardware nor the user names another.
inline constexpr const Accelerator& default_accelerator = *accelerators[0];

/// Finds the description with this name, in any case of letters; nullptr if there is none.
[[nodiscard]] constexpr const Accelerator* find_accelerator(std::string_view name) noexcept
{
    for (const Accelerator* accelerator : accelerators)
        if (equal_ignoring_case(accelerator->name, name))
            return accelerator;
    return nullptr;
}

/// The index of a description in the registry. It compares kinds and not addresses, because with
/// the undefined sanitizer of g++ a comparison of addresses is no constant expression.
[[nodiscard]] constexpr std::size_t position_of(const Accelerator& description) noexcept
{
    std::size_t position = 0;
    while (position + 1 < accelerators.size() && accelerators[position]->kind != description.kind)
        ++position;
    return position;
}

/// Finds the description whose kind is that of CAPABILITY; nullptr if there is none.
[[nodiscard]] constexpr const Accelerator* find_accelerator(std::uint8_t kind) noexcept
{
    for (const Accelerator* accelerator : accelerators)
        if (accelerator->kind == kind)
            return accelerator;
    return nullptr;
}

} // namespace raymarch::protocol
