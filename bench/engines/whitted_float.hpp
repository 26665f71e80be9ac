// SPDX-License-Identifier: MIT
/// @file
/// What the ray tracer of source 004 is in scalar floating point: the same scenes, the same rays,
/// one after the other.
#pragma once

#include "engine/model.hpp"

#include <cstdint>

namespace raymarch::bench
{

/// Draws the picture with all samples of each pixel; returns how many rays that took, counted as
/// the model counts them.
std::uint64_t draw_whitted_float(engine::WordSpan words, engine::PictureSize size,
                                 const engine::Canvas& canvas);

} // namespace raymarch::bench
