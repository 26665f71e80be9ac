// SPDX-License-Identifier: MIT
/// @file
/// Reads the arguments of VIEW, HUE and RANDOM, and of other commands, and applies them to a state.
///
/// Angles and hues have no exact codes. So they are computed in double and rounded to the nearest
/// code, ties to even. Ranges are still checked against the exact decimals.
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

/// A number in a command that is not a parameter. Its bounds are decimal text, and are included.
struct ArgumentRange
{
    std::string_view name;
    std::string_view min;
    std::string_view max;
    std::string_view allowed; ///< the sentence of the reply to a number outside the bounds
};

/// Makes the fault for a wrong argument at its column. `allowed` is the sentence of the reply.
[[nodiscard]] Fault argument_fault(Text at, std::string_view allowed) noexcept;

inline constexpr ArgumentRange yaw_range = {"yaw", "-1000000", "1000000",
                                            "yaw is -1000000 to 1000000 degrees"};
inline constexpr ArgumentRange pitch_range = {"pitch", "-89.9", "89.9",
                                              "pitch is -89.9 to 89.9 degrees"};
inline constexpr ArgumentRange hue_range = {"hue", "0", "1", "hue is 0 to 1"};

/// `VIEW yaw,pitch,zoom`: F = (cos p sin a, sin p, cos p cos a), R = normalise((0,1,0) x F),
/// U = F x R. The zoom is read as its parameter. On an error the state stays. Errors: Argument.
[[nodiscard]] std::optional<Fault> apply_view(const Accelerator& accelerator, Text words,
                                              State& state) noexcept;

/// A word followed by a whole number: the arguments of WALK, TURN and ANIMATE.
struct WordAndCount
{
    Text word;
    unsigned count = 0;
};
/// Reads `WORD [COUNT]`. COUNT is 1 to `most`; the default is `otherwise`. Errors: Argument.
[[nodiscard]] tl::expected<WordAndCount, Fault>
read_word_and_count(Text words, unsigned otherwise, unsigned most,
                    std::string_view allowed) noexcept;

/// Sets the basis of the orbit camera to the nearest codes. At yaw 0 the camera is at +z, at yaw 90
/// it is at +x; a positive pitch raises it. Precondition: the accelerator has such a camera.
void set_orbit(const Accelerator& accelerator, double yaw_degrees, double pitch_degrees,
               State& state) noexcept;

/// `HUE h`: converts HSV to RGB at full saturation and value. Errors: Argument.
[[nodiscard]] std::optional<Fault> apply_hue(const Accelerator& accelerator, Text words,
                                             State& state) noexcept;

/// Sets the parameters of `group` (all if empty) to random values inside their ranges. The camera
/// gets a random orbit, so that its vectors are a basis, and a colour gets a random hue.
void randomise(const Accelerator& accelerator, std::string_view group, std::mt19937_64& random,
               State& state) noexcept;

/// Sets the parameters of `group` (all if empty) to their defaults.
void reset(const Accelerator& accelerator, std::string_view group, State& state) noexcept;

/// Finds a group in any case of letters, and returns it as the table spells it.
[[nodiscard]] std::optional<std::string_view> find_group(const Accelerator& accelerator,
                                                         std::string_view name) noexcept;

} // namespace raymarch::protocol
