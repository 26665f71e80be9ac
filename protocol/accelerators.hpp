// SPDX-License-Identifier: MIT
/// @file
/// The registry of descriptions. It has one line for each accelerator. The registries of models and
/// of movements have the same accelerators in the same order, or do not compile.
#pragma once

#include "protocol/accelerators/fractal.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/accelerators/sphere.hpp"
#include "protocol/accelerators/whitted.hpp"
#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace raymarch::protocol
{

inline constexpr std::array accelerators = {
    &marcher::description,    //
    &fractal::description,    //
    &sphere::description,     //
    &mandelbulb::description, //
    &whitted::description,
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
/// the undefined sanitizer of g++ a comparison of addresses is no constant expression. A
/// description that is not in the registry ends the program, or does not compile.
[[nodiscard]] constexpr std::size_t position_of(const Accelerator& description) noexcept
{
    for (std::size_t i = 0; i < accelerators.size(); ++i)
        if (accelerators[i]->kind == description.kind)
            return i;
    std::abort();
}

/// Whether the rows of another registry, which have a member `description`, are those of the
/// accelerators, in the same order.
template <typename Row, std::size_t count>
[[nodiscard]] consteval bool has_all_accelerators(const std::array<Row, count>& rows)
{
    if (count != accelerators.size())
        return false;
    for (std::size_t i = 0; i < count; ++i)
        if (position_of(*rows[i].description) != i)
            return false;
    return true;
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
