// SPDX-License-Identifier: MIT
/// @file
/// The square roots of the two designs: the hardware's exact one, and the prototype's, which goes
/// through a floating-point number of 53 bits.
#pragma once

#include "engine/sphere/wide.hpp"

#include <cstdint>

namespace raymarch::engine::sphere
{

/// floor(sqrt(v)). Precondition: 0 <= v < 2^126.
[[nodiscard]] std::uint64_t floor_root(Wide v) noexcept;

/// v to the nearest number of 53 significant bits (a tie to the even one), its root to the nearest
/// such number, and of that the floor. Equals floor_root below 2^52. Precondition: 0 <= v < 2^100.
[[nodiscard]] std::uint64_t rounded_root(Wide v) noexcept;

} // namespace raymarch::engine::sphere
