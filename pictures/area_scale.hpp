// SPDX-License-Identifier: MIT
/// @file
/// A picture in another size, in integers, so that it is the same everywhere.
#pragma once

#include "engine/image.hpp"

namespace raymarch::pictures
{

/// Each pixel is the mean of what it covers of the picture, by area, rounded to nearest (halves
/// up). A whole factor up repeats the pixels. Both sizes are at least 1x1 (asserted).
[[nodiscard]] engine::Image area_scaled(const engine::Image& image, engine::PictureSize size);

} // namespace raymarch::pictures
