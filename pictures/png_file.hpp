// SPDX-License-Identifier: MIT
/// @file
/// A picture to the bytes of a PNG file, by libpng.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <cstdint>
#include <vector>

namespace raymarch::pictures
{

/// Errors: InputOutput with libpng's words.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_png(const engine::Image& image);

} // namespace raymarch::pictures
