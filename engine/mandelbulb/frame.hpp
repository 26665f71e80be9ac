// SPDX-License-Identifier: MIT
/// @file
/// The Mandelbulb's words in the pipeline's own numbers; they are latched once a frame.
#pragma once

#include "engine/mandelbulb/iteration.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace raymarch::engine::mandelbulb
{

enum class Form : std::uint8_t { Q8_57, Q8_64 };
enum class ColourMode : std::uint8_t { Steps, Index };
enum class Aspect : std::uint8_t {
    Natural, ///< a pixel is as wide as it is high
    Square   ///< the picture shows a square, however wide it is (the source's smaller board)
};

/// Q8.64, whatever the form.
using Position = Vec3<Int128>;
inline constexpr int position_bits = 64;

/// The state of one frame.
struct Frame
{
    Form form = Form::Q8_57;
    Arithmetic arithmetic{};
    int epsilon_shift = 12;    ///< b: a ray ends at the 2^-b-th part of its first distance, 4 to 16
    int max_evaluations = 200; ///< of a ray, 1 to 200
    ColourMode colour = ColourMode::Steps;
    Aspect aspect = Aspect::Natural;
    Position position{};
    Direction forward{};
    Direction right{};
    Direction up{};
    bool operator==(const Frame&) const = default;
};

/// Unpacks the words. A number outside its range counts as the nearest that is inside.
[[nodiscard]] Frame latch(std::span<const std::uint32_t> words) noexcept;

inline constexpr int min_kept_bits = 8;

/// k where the frame leaves it open: enough for N steps, and what one DSP slice multiplies.
[[nodiscard]] constexpr int automatic_kept_bits(int steps) noexcept
{
    return std::min(std::max(17, steps + 4), all_bits);
}

/// The position as a coordinate of the form, floored.
template <typename Format>
[[nodiscard]] constexpr Point<Format> position_in(const Position& position) noexcept
{
    return map(position, [](Int128 component) {
        return static_cast<typename Format::Coordinate>(component >>
                                                        (position_bits - Format::fraction_bits));
    });
}

} // namespace raymarch::engine::mandelbulb
