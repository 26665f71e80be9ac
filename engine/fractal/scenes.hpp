// SPDX-License-Identifier: MIT
/// @file
/// The scene query stage (source 001, section V.C): the signed distance of a point from a scene.
#pragma once

#include "engine/fractal/formats.hpp"

#include <cstdint>

namespace raymarch::engine::fractal
{

/// The codes of SCENE.
enum class Scene : std::uint8_t { Menger, Cubes, Cube, Maze };

/// A signed distance by the maximum norm; negative inside matter.
using Distance = Number (*)(const Point& p) noexcept;

[[nodiscard]] Number menger(const Point& p) noexcept; ///< four generations, period 2
[[nodiscard]] Number cubes(const Point& p) noexcept;  ///< of side 1/2 at all integers
[[nodiscard]] Number cube(const Point& p) noexcept;   ///< of side 1 at the origin
[[nodiscard]] Number maze(const Point& p) noexcept;   ///< bars of side 1/8, hashed a cell

struct SceneRow
{
    Scene scene;
    Distance distance;
    std::uint8_t latency; ///< clock cycles of one query, without the one that hands it over
};

/// The row of a scene; all four codes of two bits have one.
[[nodiscard]] const SceneRow& scene_row(Scene scene) noexcept;

} // namespace raymarch::engine::fractal
