// SPDX-License-Identifier: MIT
/// @file
/// The scene query stage (source 000, §4.1.3): the signed distance of a point from a scene.
#pragma once

#include "engine/marcher/formats.hpp"

#include <cstdint>

namespace raymarch::engine::marcher
{

/// The codes of OBJ.
enum class Scene : std::uint8_t { Sphere, Cube, InfiniteCube, Tunnel };

/// A signed distance function: at most the Euclidean distance of `p` from the surface, in units.
using Distance = Coordinate (*)(const Point& p) noexcept;

[[nodiscard]] Coordinate sphere(const Point& p) noexcept;        ///< radius 1
[[nodiscard]] Coordinate cube(const Point& p) noexcept;          ///< half width 1/2
[[nodiscard]] Coordinate infinite_cube(const Point& p) noexcept; ///< half width 1/4, period 1
[[nodiscard]] Coordinate
tunnel(const Point& p) noexcept; ///< infinite Menger sponge (001, Fig. 7, 9)

struct SceneRow
{
    Scene scene;
    Distance distance;
    std::uint8_t clock_cycles; ///< one query takes them in hardware (source 000, Table 7)
};

/// The row of a scene; all four codes of two bits have one.
[[nodiscard]] const SceneRow& scene_row(Scene scene) noexcept;

} // namespace raymarch::engine::marcher
