// SPDX-License-Identifier: MIT
/// @file
/// The inverse square root stage (source 000, §4.2.3, Fig. 22): leading zeros, a table of 4096
/// entries, here with linear interpolation between entries, and the shift back.
#pragma once

#include "engine/marcher/formats.hpp"

#include <cstdint>

namespace raymarch::engine::marcher
{

/// 1 / sqrt(S) of a 64-bit integer S > 0, as mantissa * 2^-(24 + shift): so `(v * mantissa) >>
/// shift` is v / sqrt(S) in Q8.24.
struct InverseSqrt
{
    std::uint32_t mantissa; ///< Q2.30, above 0.7071 and at most 1.4143
    int shift;              ///< 6 to 38
};

/// Relative error below 2^-25 (the source's: 1.2e-4). Precondition: squared > 0.
[[nodiscard]] InverseSqrt inverse_sqrt(std::uint64_t squared) noexcept;

/// x*x + y*y + z*z, exact: at most 3 * 2^62.
[[nodiscard]] std::uint64_t squared_length(const RawVector& v) noexcept;

/// v / |v| in Q8.24, each component floored; the zero vector stays zero.
[[nodiscard]] Point normalise(const RawVector& v) noexcept;

/// |p| in Q8.24, floored; |p| is below 128, so that it fits.
[[nodiscard]] Coordinate length(const Point& p) noexcept;

} // namespace raymarch::engine::marcher
