// SPDX-License-Identifier: MIT
/// @file
/// The fractal's words in the pipeline's own numbers; they are latched once a frame.
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/fractal/scenes.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::fractal
{

/// The state of one frame.
struct Frame
{
    Point position{};
    Point forward{}; ///< of any length; a positive y looks down
    Scene scene = Scene::Menger;
    bool dither = false;
    bool texture = false;
    bool checker = false; ///< every other pixel a frame
    bool colour = false;
    std::uint8_t hue = 0;
};

/// Unpacks the parameter words; every word is a frame.
[[nodiscard]] Frame latch(std::span<const std::uint32_t> words) noexcept;

} // namespace raymarch::engine::fractal
