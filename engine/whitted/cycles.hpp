// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the clock cycles of the one state machine (source 004, Fig. 8, 12;
/// docs/engine/whitted.md, "Cycles"). Nothing overlaps, so a frame takes their sum.
#pragma once

#include <cstdint>

namespace raymarch::engine::whitted::cycles
{

using Cycles = std::uint32_t;

inline constexpr Cycles ray = 14; ///< set up and normalised: 1 sum, 7 root, 6 division

// A sphere of the search for the nearest hit.
inline constexpr Cycles eye_inside = 2;
inline constexpr Cycles behind = 3;
inline constexpr Cycles missed = 4;
inline constexpr Cycles hit = 11;
inline constexpr Cycles sphere_chosen = 1; ///< once, behind the last sphere

// A plane of it.
inline constexpr Cycles plane_away = 1;
inline constexpr Cycles plane_met = 8;

// A hit. The way to the light is normalised as a ray is.
inline constexpr Cycles normal = 1;
inline constexpr Cycles cosine = 1;
inline constexpr Cycles lambert = 1; ///< spheres only
inline constexpr Cycles accumulate = 1;
inline constexpr Cycles reflect = 2; ///< and `ray`

// A sphere of the search for a shadow.
inline constexpr Cycles too_far = 1;
inline constexpr Cycles too_far_at_the_end = 1; ///< more, where it is the last one
inline constexpr Cycles blocked_within = 3;     ///< by its own sphere, or by one around the point
inline constexpr Cycles blocked = 4;

inline constexpr Cycles end_of_sample = 1;
inline constexpr Cycles end_of_frame = 1;

} // namespace raymarch::engine::whitted::cycles
