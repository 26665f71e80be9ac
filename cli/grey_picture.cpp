// SPDX-License-Identifier: MIT
#include "cli/grey_picture.hpp"

#include <fmt/format.h>

#include <string>

namespace raymarch::cli
{
namespace
{

constexpr unsigned step = 255 / 15;

tl::unexpected<Error> no_export(const std::string& why)
{
    return fail(plain_error(
        ErrorKind::BadData,
        fmt::format("{}; an export needs {}x{} pixels in 16 levels of grey, as the accelerator "
                    "fractal draws with COLOUR=off",
                    why, protocol::export_size.width, protocol::export_size.height)));
}

} // namespace

Result<protocol::GreyPicture> grey_of(const engine::Image& image)
{
    if (image.size != protocol::export_size)
        return no_export(fmt::format("the picture is {}x{}", image.size.width, image.size.height));
    protocol::GreyPicture picture;
    for (std::size_t i = 0; i < picture.levels.size(); ++i) {
        const unsigned red = image.rgb[engine::bytes_per_pixel * i];
        const unsigned green = image.rgb[engine::bytes_per_pixel * i + 1];
        const unsigned blue = image.rgb[engine::bytes_per_pixel * i + 2];
        const auto where = [i, &image] {
            return fmt::format("the pixel in column {}, row {} is", i % image.size.width,
                               i / image.size.width);
        };
        if (red != green || red != blue)
            return no_export(fmt::format("{} {},{},{}, not grey", where(), red, green, blue));
        if (red % step != 0)
            return no_export(fmt::format("{} {}, not a multiple of {}", where(), red, step));
        picture.levels[i] = static_cast<std::uint8_t>(red / step);
    }
    return picture;
}

engine::Image image_of(const protocol::GreyPicture& picture)
{
    engine::Image image(protocol::export_size);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] =
            static_cast<std::uint8_t>(step * picture.levels[i / engine::bytes_per_pixel]);
    return image;
}

} // namespace raymarch::cli
