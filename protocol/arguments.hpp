// SPDX-License-Identifier: MIT
/// @file
/// The words of the commands that compute: VIEW, HUE and RANDOM, and what they do to a state.
///
/// Angles and hues have no exact codes, so these are computed in double and rounded to the nearest
/// code, ties to even. Ranges are still judged on the exact decimals.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"
#include "protocol/text.hpp"

#include <optional>
#include <random>
#include <string_view>
#include <tl/expected.hpp>

namespace raymarch::protocol
{

/// A number of a command that is no parameter; bounds are decimal text, inclusive.
struct ArgumentRange
{
    std::string_view name;
    std::string_view min;
    std::string_view max;
    std::string_view allowed; ///< the sentence of the reply when it is not met
};

/// What is wrong with a command's words, at their column; `allowed` is the sentence of the reply.
[[nodiscard]] Fault argument_fault(Text at, std::string_view allowed) noexcept;

inline constexpr ArgumentRange yaw_range = {"yaw", "-1000000", "1000000",
                                            "yaw is -1000000 to 1000000 degrees"};
inline constexpr ArgumentRange pitch_range = {"pitch", "-89.9", "89.9",
                                              "pitch is -89.9 to 89.9 degrees"};
inline constexpr ArgumentRange hue_range = {"hue", "0", "1", "hue is 0 to 1"};

/// `VIEW yaw,pitch,zoom`: F = (cos p sin a, sin p, cos p cos a), R = normalise((0,1,0) x F),
/// U = F x R, zoom as its parameter. All or nothing. Errors: Argument.
[[nodiscard]] std::optional<Fault> apply_view(const Accelerator& accelerator, Text words,
                                              State& state) noexcept;

/// The word and the whole number behind it, as WALK, TURN and ANIMATE take them.
struct WordAndCount
{
    Text word;
    unsigned count = 0;
};
/// `WORD [COUNT]`, COUNT from 1 to `most` and `otherwise` where there is none. Errors: Argument.
[[nodiscard]] tl::expected<WordAndCount, Fault>
read_word_and_count(Text words, unsigned otherwise, unsigned most,
                    std::string_view allowed) noexcept;

/// The basis of the orbit camera, to the nearest codes: yaw 0 looks from +z, 90 from +x; pitch
/// rises. The accelerator has such a camera.
void set_orbit(const Accelerator& accelerator, double yaw_degrees, double pitch_degrees,
               State& state) noexcept;

/// `HUE h`: HSV to RGB at full saturation and value. Errors: Argument.
[[nodiscard]] std::optional<Fault> apply_hue(const Accelerator& accelerator, Text words,
                                             State& state) noexcept;

/// Draws the parameters of `group` (all when empty) inside their ranges. The camera is a real one:
/// a random orbit; colours are random hues.
void randomise(const Accelerator& accelerator, std::string_view group, std::mt19937_64& random,
               State& state) noexcept;

/// Defaults for the parameters of `group` (all when empty).
void reset(const Accelerator& accelerator, std::string_view group, State& state) noexcept;

/// The table's own spelling of a group, or nothing.
[[nodiscard]] std::optional<std::string_view> find_group(const Accelerator& accelerator,
                                                         std::string_view name) noexcept;

} // namespace raymarch::protocol
