// SPDX-License-Identifier: MIT
/// @file
/// Movement around a Mandelbulb (source 003, §V.C). A step is a fraction of the distance to the
/// surface, so it looks equally large on the screen at any depth.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/model.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <optional>

namespace raymarch::motion::mandelbulb
{

/// The camera, and the arithmetic that measures its distance. A step reads and changes them.
struct World
{
    engine::mandelbulb::Frame frame{};
    bool operator==(const World&) const = default;
};

[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes the camera and the frame scale into `state`, and nothing else.
void leave(const World& world, protocol::State& state) noexcept;

/// Makes one step. Forward and Back move by a quarter of the distance along the axis, and so do
/// strafing, Up and Down; turning and rolling are by 1 degree. No step leaves the sphere of radius
/// 4 in which the estimate is a lower bound, and only Back can enter the set. Animate dives and
/// rolls slowly until the arithmetic has no more detail.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// The height that defines a zoom level: neighbouring rays at distance D are D / 720 apart.
inline constexpr int zoom_height = 720;

/// The zoom levels that a view may have.
inline constexpr int min_zoom = 8;
inline constexpr int max_zoom = 58;

/// The view at zoom level z = log2(720 / D) of the point that pixel (x, y) of `view` shows. The
/// camera looks along the pixel's ray from the distance D in front of the surface. The result is
/// empty if the ray misses the surface.
[[nodiscard]] std::optional<engine::mandelbulb::Frame>
approach(const engine::mandelbulb::Frame& view, engine::PictureSize size, std::uint16_t x,
         std::uint16_t y, int zoom) noexcept;

/// The state of what approach() gives, at the accelerator's own size; the rest is that of `state`.
[[nodiscard]] std::optional<protocol::State>
state_near(const protocol::State& state, std::uint16_t x, std::uint16_t y, int zoom) noexcept;

/// The frame scale of a view at zoom level z. It is 0 as long as the coordinates resolve a
/// distance.
[[nodiscard]] int scale_at(engine::mandelbulb::Form form, int zoom) noexcept;

} // namespace raymarch::motion::mandelbulb
