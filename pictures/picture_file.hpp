// SPDX-License-Identifier: MIT
/// @file
/// A picture in memory to the bytes of a picture file.
///
/// PPM and TGA are written here, PNG by libpng; JPEG by OpenCV, in a module that is loaded when the
/// first such picture is asked for: the programs start without OpenCV and run on boards that lack
/// it.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::pictures
{

enum class PictureFormat : std::uint8_t { Ppm, Tga, Png, Jpeg };

/// By the ending of a file's name, any case: ppm, tga, png, jpg, jpeg; `-` is PPM.
/// Errors: Usage, naming what is allowed.
[[nodiscard]] Result<PictureFormat> format_of(std::string_view path);

/// The bytes of the file. Errors: Unavailable when the format needs the OpenCV module and it is not
/// installed.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode(const engine::Image& image,
                                                       PictureFormat format);

} // namespace raymarch::pictures
