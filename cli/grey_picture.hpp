// SPDX-License-Identifier: MIT
/// @file
/// Converts between a picture in memory and the 16 levels of grey of an export.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"
#include "protocol/picture_frames.hpp"

namespace raymarch::cli
{

/// Level g is 17 * g in each channel. Errors: BadData, which names the first wrong pixel.
[[nodiscard]] Result<protocol::GreyPicture> grey_of(const engine::Image& image);

[[nodiscard]] engine::Image image_of(const protocol::GreyPicture& picture);

} // namespace raymarch::cli
