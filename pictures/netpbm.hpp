// SPDX-License-Identifier: MIT
/// @file
/// The bytes of a PGM (P5) or PPM (P6) file to a picture in memory: what `render` and most tools
/// can write, read without loss.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <string_view>

namespace raymarch::pictures
{

/// One binary picture with a maximum of 255, or of 15, which is stretched to 255 exactly (times
/// 17); grey becomes three equal channels. Errors: BadData.
[[nodiscard]] Result<engine::Image> decode_netpbm(std::string_view bytes);

} // namespace raymarch::pictures
