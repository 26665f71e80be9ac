// SPDX-License-Identifier: MIT
/// @file
/// The registry of descriptions: one line an accelerator.
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

/// What is active where neither the hardware nor the user says otherwise.
inline constexpr const Accelerator& default_accelerator = *accelerators[0];

/// The description of that name (any case), or nullptr.
[[nodiscard]] constexpr const Accelerator* find_accelerator(std::string_view name) noexcept
{
    for (const Accelerator* accelerator : accelerators)
        if (equal_ignoring_case(accelerator->name, name))
            return accelerator;
    return nullptr;
}

/// Where a description stands in the registry.
/// It compares kinds, as g++'s undefined sanitizer takes no comparison of addresses for a constant.
[[nodiscard]] constexpr std::size_t position_of(const Accelerator& description) noexcept
{
    std::size_t position = 0;
    while (position + 1 < accelerators.size() && accelerators[position]->kind != description.kind)
        ++position;
    return position;
}

/// The description of CAPABILITY's kind, or nullptr.
[[nodiscard]] constexpr const Accelerator* find_accelerator(std::uint8_t kind) noexcept
{
    for (const Accelerator* accelerator : accelerators)
        if (accelerator->kind == kind)
            return accelerator;
    return nullptr;
}

} // namespace raymarch::protocol
