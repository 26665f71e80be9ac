// SPDX-License-Identifier: MIT
/// @file
/// The ray-sphere unit: where the line through two points meets a sphere, in integers. One
/// computation for both designs; where they differ, and where a product should, stands in Rules.
#pragma once

#include "engine/sphere/frame.hpp"
#include "engine/sphere/wide.hpp"

#include <cstdint>

namespace raymarch::engine::sphere
{

/// A line by two points; t = 0 at `from`, t = 1 at `to`.
struct Line
{
    Point from;
    Point to;
};

/// Says which part of the line counts.
enum class Reach : std::uint8_t {
    Ray,     ///< T from 0 on
    Segment, ///< T from 10 on, and up to the other end: is the way to a light free?
};

inline constexpr std::int64_t segment_threshold = 10;

/// How the unit ended; the hardware's count at which it does so stands beside the name.
enum class End : std::uint8_t {
    Misses,   ///< the line misses the sphere (1000)
    Rejected, ///< both roots lie outside the reach (2500)
    Hits,     ///< (3500)
};

struct Strike
{
    End end = End::Misses;
    /// 2 a t of the root used, a that of the line: roots of one line compare by it.
    std::int64_t root = 0;
    Point point;
};

/// A point's coordinates, computed with 64 bits, as they leave the unit.
enum class Narrowing : std::uint8_t {
    Low16,    ///< the low 16 bits, unsigned
    Low32,    ///< the low 32 bits, signed
    Saturate, ///< held at -2^17 and 2^17 - 1
};

/// The designs differ in these rules. Section numbers are those of docs/engine/sphere.md.
struct Rules
{
    /// A line that touches the sphere misses it.
    bool strict;
    std::uint64_t (*root)(Wide) noexcept;
    /// The unit cuts a, b and c to 32 bits.
    bool narrow_coefficients;
    /// "T below the threshold" is an unsigned comparison: a negative T is a huge one.
    bool unsigned_threshold;
    /// The far root stands in the first product of the near point's x.
    bool far_root_in_x;
    /// The smallest root within the reach is used, else the near one if either is within.
    bool root_by_root;
    Narrowing narrowing;
};

/// The rules of a design with its faults kept, repaired or corrected.
[[nodiscard]] const Rules& rules_of(Design design, Faults faults) noexcept;

/// `derounder` moves both roots towards `from` by 1 / (2 derounder) of the segment; 0: not at all.
[[nodiscard]] Strike intersect(const Rules& rules, const Line& line, const Ball& ball, Reach reach,
                               std::int32_t derounder) noexcept;

} // namespace raymarch::engine::sphere
