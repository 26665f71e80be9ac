// SPDX-License-Identifier: MIT
/// @file
/// Presets, scenes, and the colour as three bits, for buttons and LEDs, which have no text lines.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace raymarch::protocol
{

/// Makes the state of a preset of this accelerator.
[[nodiscard]] State preset_state(const Accelerator& accelerator, const Preset& preset) noexcept;

/// Makes the state with the next scene; the first follows the last. An accelerator without a choice
/// of scenes goes through its presets. `shown` is the index of the preset that was applied last,
/// and is advanced.
[[nodiscard]] State next_scene(const Accelerator& accelerator, const State& state,
                               std::optional<std::size_t>& shown) noexcept;

/// Whether red, green and blue are in the upper half of their ranges. All are false if the
/// accelerator has no colour.
[[nodiscard]] std::array<bool, 3> colour_bits(const Accelerator& accelerator,
                                              const State& state) noexcept;

} // namespace raymarch::protocol
