// SPDX-License-Identifier: MIT
#include "pictures/png_file.hpp"

#include <png.h>

#include <string>

namespace raymarch::pictures
{

Result<std::vector<std::uint8_t>> encode_png(const engine::Image& image)
{
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    png.width = image.size.width;
    png.height = image.size.height;
    png.format = PNG_FORMAT_RGB;
    // A preview is written for every frame, and the default takes six times as long.
    png.flags = PNG_IMAGE_FLAG_FAST;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
    png_alloc_size_t length = bytes.size();
    if (::png_image_write_to_memory(&png, bytes.data(), &length, 0, image.rgb.data(), 0, nullptr) ==
        0)
        return fail(
            plain_error(ErrorKind::InputOutput,
                        std::string("libpng could not encode the picture: ") + png.message));
    bytes.resize(length);
    return bytes;
}

} // namespace raymarch::pictures
