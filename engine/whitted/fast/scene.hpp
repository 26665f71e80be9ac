// SPDX-License-Identifier: MIT
/// @file
/// A frame as the kernels read it: columns of numbers in place of rows, and the bounds inside of
/// which no word wraps (docs/engine/whitted.md, "Fast kernel").
#pragma once

#include "engine/whitted/frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::whitted::fast
{

/// Rows of a table that is looked up by an index in a vector: a power of two.
inline constexpr std::size_t table_rows = 16;
static_assert(max_spheres <= table_rows && plane_count <= table_rows);

using Column = std::array<std::int32_t, table_rows>;
using Estimates = std::array<float, table_rows>;

/// What is known of points and directions wherever the kernels compute; a sample that leaves these
/// bounds is left to the reference.
namespace bounds
{
inline constexpr std::int32_t word_end = 1 << 23;
/// |direction|, raw. A normalised vector of at least `least_length` is no longer: see the page.
inline constexpr std::int32_t direction = 4240;
inline constexpr std::int32_t least_length = 256;
/// |component| of a sphere's normal, raw.
inline constexpr std::int32_t normal_component = 5000;
/// |normal| of a plane, raw.
inline constexpr std::int32_t plane_normal = 4300;
/// |centre| + |point|, raw: its square is a Wide.
inline constexpr std::int32_t reach = 11'600'000;
/// A way along a unit direction is below it: times bounds::direction / 4096 it is still a word.
inline constexpr std::int32_t reach_along = 8'000'000;
/// A way to a light that is not normalised as it should be is below it, in unit vectors.
inline constexpr std::int32_t wrapped_direction = 16;
/// `along`, raw, is at most this: 2^18 more is still a word.
inline constexpr std::int32_t along = word_end - (1 << 18);
/// A sphere's radius in units is at most this: the square of the half chord is below 2^43.
inline constexpr std::int32_t radius = 480;
} // namespace bounds

/// The spheres, the light among them as the last.
struct alignas(64) SphereColumns
{
    Column x, y, z;            ///< centres
    Estimates x_, y_, z_;      ///< the same
    Estimates gap;             ///< radius^2 - |centre|^2
    Estimates squared_radius_; ///< raw
    Estimates radius_;         ///< raw, as a Wide
    Column squared_radius;     ///< raw, its low 32 bits
    Column radius;             ///< raw, as a Wide, its low 32 bits
    Column inverse_radius;
    Column offset_limit; ///< of |point - centre| per axis, so that the normal keeps its bound
    Column red, green, blue, reflect;
};

struct alignas(64) PlaneColumns
{
    Column x, y, z; ///< normals
    Estimates x_, y_, z_;
    Column offset;
    Column red, green, blue, reflect, checker;
};

/// How much an estimate of a ray and a sphere may be wrong: see the page.
struct Margins
{
    float along;         ///< of the way along a ray, raw: along + along_squared * |origin|^2
    float along_squared; ///< per squared length
    float chord;         ///< of the squared half chord: chord + chord_squared * |origin|^2
    float chord_squared;
};

struct Scene
{
    enum class Kind : std::uint8_t {
        Tame,  ///< nothing wraps while points stay within the bounds
        Black, ///< the eye is inside a sphere: every sample is black
        Wild,  ///< for the reference alone
    };

    Frame frame;
    Kind kind = Kind::Wild;
    std::int32_t coordinate_bound = 0; ///< of every point that a ray starts from
    float squared_bound = 0;           ///< of its squared length
    float squared_near = 0;            ///< points that are nearer keep both
    bool light_is_near = false; ///< whatever is within 1024 of it lies within 2^23 / 1.035 of all
    Margins margins{};
    SphereColumns spheres{};
    PlaneColumns planes{};
};

[[nodiscard]] Scene make_scene(const Frame& frame) noexcept;

} // namespace raymarch::engine::whitted::fast
