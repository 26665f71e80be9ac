// SPDX-License-Identifier: MIT
/// @file
/// The words' meaning in the sphere tracer's own numbers; they are latched once a frame.
#pragma once

#include "engine/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace raymarch::engine::sphere
{

/// Scene units; x to the right and y down as the pixels count, z into the picture.
using Point = Vec3<std::int32_t>;

/// Whose arithmetic, and what a picture shows of the state that outlives a pixel.
enum class Design : std::uint8_t {
    Rtl,       ///< the hardware core, each pixel by itself
    RtlTop,    ///< as written to the frame buffer: one pixel late
    RtlTimed,  ///< and with the shading divider, which is not always in time
    Prototype, ///< the C program
};

/// How many of the sources' faults are in the picture (docs/engine/sphere.md, "Faults").
enum class Faults : std::uint8_t {
    Kept,      ///< the source's bits
    Repaired,  ///< without the two slips of the hardware's ray-sphere unit
    Corrected, ///< the rules of a product
};

/// The hardware's screen is yellow.
enum class Tint : std::uint8_t { Yellow, Grey };

struct Ball
{
    Point centre;
    std::int32_t radius = 0;
};

struct Light
{
    Point position;
    std::int32_t strength = 0;
};

inline constexpr std::size_t max_balls = 3; ///< as many as the prototype has colours
inline constexpr std::size_t max_lights = 8;

/// The state of one frame; initially what the hardware holds at power-up. Coordinates, radii and
/// the screen distance are below 2^17 in magnitude (the numbers' widths follow from that).
struct Frame
{
    Design design = Design::Rtl;
    Faults faults = Faults::Kept;
    Tint tint = Tint::Yellow;
    Point eye{320, 240, 0};
    std::int32_t screen = 1000; ///< z of the screen plane
    std::int32_t calibration = 200;
    std::int32_t derounder = 75;
    std::int32_t shadow = 2; ///< what a pixel without light shows: of 15, prototype of 255
    std::size_t ball_count = 1;
    std::size_t light_count = 1;
    std::array<Ball, max_balls> balls{{{{320, 240, 1100}, 100}}};
    std::array<Light, max_lights> lights{{{{50, 50, 1000}, 4095}}};
};

/// Unpacks the words. A FAULTS of 3, which no choice names, is corrected, and an M above 8 is 8.
[[nodiscard]] Frame latch(std::span<const std::uint32_t> words) noexcept;

/// The frame as the design's registers hold it. The hardware's have 16 bits for coordinates,
/// radius, strength and screen distance, 10 for the calibration, 4 for the shadow: the upper bits
/// of a value are lost. Corrected, and in the prototype, nothing is.
[[nodiscard]] Frame held(Frame frame) noexcept;

} // namespace raymarch::engine::sphere
