// SPDX-License-Identifier: MIT
/// @file
/// What a description offers to look at, for whoever has buttons and LEDs and no lines: presets,
/// scenes, and a colour as three bits.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace raymarch::protocol
{

/// The defaults, changed by the preset, which is one of the accelerator's.
[[nodiscard]] State preset_state(const Accelerator& accelerator, const Preset& preset) noexcept;

/// What is seen after `state`: its next scene, the last before the first again. An accelerator
/// without a choice of scenes goes through its presets: `shown` is the position of the one applied
/// last, and is moved on.
[[nodiscard]] State next_scene(const Accelerator& accelerator, const State& state,
                               std::optional<std::size_t>& shown) noexcept;

/// Red, green and blue, each whether it is in the upper half of its range; all false where the
/// accelerator has no colour.
[[nodiscard]] std::array<bool, 3> colour_bits(const Accelerator& accelerator,
                                              const State& state) noexcept;

} // namespace raymarch::protocol
