// SPDX-License-Identifier: MIT
/// @file
/// Moving before a Mandelbulb (source 003, §V.C): every way is measured in distances to its
/// surface, so that a step is as large on the screen at any depth.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/model.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <optional>

namespace raymarch::motion::mandelbulb
{

/// What a step needs and remembers: the camera, and the arithmetic that measures its distance.
struct World
{
    engine::mandelbulb::Frame frame{};
    bool operator==(const World&) const = default;
};

[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes camera and frame scale into `state`; the rest stays.
void leave(const World& world, protocol::State& state) noexcept;

/// Forward and Back by a quarter of the distance along the axis, strafing, Up and Down likewise;
/// turning and rolling by 1 degree. No step leaves the sphere of radius 4 in which the estimate is
/// a lower bound, and none but Back enters the set. Animate dives and rolls slowly, until the
/// arithmetic shows nothing new.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// The height that a zoom level counts by: neighbouring rays at distance D are D / 720 apart.
inline constexpr int zoom_height = 720;

/// Zoom levels that a view may be asked at.
inline constexpr int min_zoom = 8;
inline constexpr int max_zoom = 58;

/// The view of what pixel (x, y) of `view` shows, at zoom level z = log2(720 / D): the camera looks
/// along the pixel's ray from the distance D before the surface. nullopt where the ray misses it.
[[nodiscard]] std::optional<engine::mandelbulb::Frame>
approach(const engine::mandelbulb::Frame& view, engine::PictureSize size, std::uint16_t x,
         std::uint16_t y, int zoom) noexcept;

/// The state of what approach() gives, at the accelerator's own size; the rest is that of `state`.
[[nodiscard]] std::optional<protocol::State>
state_near(const protocol::State& state, std::uint16_t x, std::uint16_t y, int zoom) noexcept;

/// The frame scale of a view at zoom level z: 0 as long as the coordinates resolve a distance.
[[nodiscard]] int scale_at(engine::mandelbulb::Form form, int zoom) noexcept;

} // namespace raymarch::motion::mandelbulb
