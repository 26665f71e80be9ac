// SPDX-License-Identifier: MIT
/// @file
/// The marcher's words in the pipeline's own numbers; they are latched once a frame.
#pragma once

#include "engine/marcher/formats.hpp"
#include "engine/marcher/scene_query.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace raymarch::engine::marcher
{

/// The state of one frame.
struct Frame
{
    RawVector forward; ///< Q1.17, from the target to the eye
    RawVector right;   ///< Q1.17
    RawVector up;      ///< Q1.17
    Point eye;         ///< zoom * forward
    Point light;
    std::array<std::uint16_t, 3> colour; ///< Q0.10: red, green, blue
    Scene scene;
};

/// Unpacks the eight words. A zoom above 16 counts as 16: no frame can set one, and it keeps every
/// position of every ray inside the numbers (docs/engine.md, "Ranges").
[[nodiscard]] Frame latch(std::span<const std::uint32_t> words) noexcept;

} // namespace raymarch::engine::marcher
