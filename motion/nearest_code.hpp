// SPDX-License-Identifier: MIT
/// @file
/// Rounds computed values to codes. Angles and hues have no exact codes, so they are computed as
/// double and rounded at the end.
#pragma once

#include "protocol/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace raymarch::motion
{

using Triple = std::array<double, 3>;

/// Rounds to the nearest code, ties to even, and clamps it to the format. Precondition: the
/// parameter has no tail.
[[nodiscard]] inline std::int64_t nearest_code(const protocol::Parameter& parameter,
                                               double value) noexcept
{
    const double code = std::nearbyint(std::ldexp(value, parameter.format.fraction_bits));
    return std::clamp(static_cast<std::int64_t>(code), parameter.format.min_code(),
                      parameter.format.max_code());
}

/// Sets three parameters to the nearest codes.
inline void set_triple(const protocol::Accelerator& accelerator,
                       const std::array<protocol::ParameterIndex, 3>& where, const Triple& values,
                       protocol::State& state) noexcept
{
    for (std::size_t i = 0; i < 3; ++i)
        state.codes[where[i]] = nearest_code(accelerator.parameters[where[i]], values[i]);
}

} // namespace raymarch::motion
