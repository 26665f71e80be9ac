// SPDX-License-Identifier: MIT
/// @file
/// What a hit adds to its ray: Lambert's law over a floor of half the colour, and the sum with its
/// weights.
#pragma once

#include "engine/whitted/formats.hpp"

namespace raymarch::engine::whitted
{

enum class Highlight : bool { Held, Wraps };

/// normal . light as a weight: bits 23 to 12 of a product that is not negative. From 1.0 on it is
/// held at the largest weight, or wraps (R4).
[[nodiscard]] Weight cosine_weight(Wide cosine, Highlight highlight) noexcept;

/// Half the colour, which is also that of every shadow.
[[nodiscard]] Colour ambient(const Colour& colour) noexcept;

/// A lit sphere: up to one and a half times its colour.
[[nodiscard]] Colour lambert(const Colour& colour, Weight cosine) noexcept;

/// sum + colour * weight, held at the brightest.
[[nodiscard]] Colour accumulate(const Colour& sum, const Colour& colour, Weight weight) noexcept;

/// Returns what a reflection leaves of a weight.
[[nodiscard]] Weight reflected_weight(Weight weight, Weight reflect) noexcept;

} // namespace raymarch::engine::whitted
