// SPDX-License-Identifier: MIT
/// @file
/// The square root unit and the divider: the two that take more than one clock cycle, and what is
/// made of them.
#pragma once

#include "engine/whitted/formats.hpp"

#include <cstdint>

namespace raymarch::engine::whitted
{

/// floor(sqrt(v)) in units of 1/4096; `bits` is an unsigned word, below 2^24. The result is below
/// 2^18.
[[nodiscard]] Word square_root(std::uint32_t bits) noexcept;

/// The root of a squared length: of its bits 35 to 12, so of less than 4096.
[[nodiscard]] Word root_of(Wide squared) noexcept;

/// |v|, right below 64.
[[nodiscard]] Word length(const Vector& v) noexcept;

/// numerator / denominator with a remainder that is never negative: floored for a positive
/// denominator, rounded up for a negative one. 0 for a denominator of 0.
[[nodiscard]] Word divide(Word numerator, Word denominator) noexcept;

/// v / |v|, right for |v| below 64; the zero vector stays zero.
[[nodiscard]] Vector normalise(const Vector& v) noexcept;

} // namespace raymarch::engine::whitted
