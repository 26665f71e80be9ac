// SPDX-License-Identifier: MIT
/// @file
/// Between a picture in memory and the sixteen levels of grey that are exported.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"
#include "protocol/picture_frames.hpp"

namespace raymarch::cli
{

/// Level g stands as 17 * g in each channel. Errors: BadData, which names what can be exported and
/// the first pixel that cannot.
[[nodiscard]] Result<protocol::GreyPicture> grey_of(const engine::Image& image);

[[nodiscard]] engine::Image image_of(const protocol::GreyPicture& picture);

} // namespace raymarch::cli
