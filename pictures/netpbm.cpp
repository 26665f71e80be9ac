// SPDX-License-Identifier: MIT
#include "pictures/netpbm.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace raymarch::pictures
{
namespace
{

Error wrong(std::string why)
{
    return plain_error(ErrorKind::BadData, std::move(why));
}

bool is_space(char c) noexcept
{
    return std::string_view(" \t\n\v\f\r").find(c) != std::string_view::npos;
}

/// Takes white space, comments up to the end of their lines, and a number off the front.
std::optional<std::uint16_t> take_number(std::string_view& bytes) noexcept
{
    while (!bytes.empty() && (is_space(bytes[0]) || bytes[0] == '#'))
        bytes.remove_prefix(bytes[0] == '#' ? std::min(bytes.find('\n'), bytes.size()) : 1);
    std::uint16_t number = 0;
    const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), number);
    if (error != std::errc{})
        return std::nullopt;
    bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()));
    return number;
}

} // namespace

Result<engine::Image> decode_netpbm(std::string_view bytes)
{
    const bool grey = bytes.starts_with("P5");
    if (!grey && !bytes.starts_with("P6"))
        return fail(wrong("is no binary PGM or PPM picture (P5, P6)"));
    bytes.remove_prefix(2);
    const bool apart = !bytes.empty() && (is_space(bytes[0]) || bytes[0] == '#');
    const auto width = take_number(bytes);
    const auto height = take_number(bytes);
    const auto maximum = take_number(bytes);
    if (!apart || !width || !height || !maximum || *width == 0 || *height == 0 || bytes.empty() ||
        !is_space(bytes[0]))
        return fail(wrong("has no header of width, height and maximum"));
    if (*maximum != 255 && *maximum != 15)
        return fail(
            wrong("has a maximum of " + std::to_string(*maximum) + "; 255 and 15 are read"));
    bytes.remove_prefix(1);
    const std::size_t pixels = std::size_t{*width} * *height;
    const std::size_t channels = grey ? 1 : engine::bytes_per_pixel;
    if (bytes.size() / channels != pixels || bytes.size() % channels != 0)
        return fail(wrong("has " + std::to_string(bytes.size()) + " bytes of pixels in place of " +
                          std::to_string(*width) + "x" + std::to_string(*height) + "x" +
                          std::to_string(channels)));
    engine::Image image(engine::PictureSize{.width = *width, .height = *height});
    const unsigned factor = 255U / *maximum;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const unsigned sample =
            static_cast<std::uint8_t>(bytes[grey ? i / engine::bytes_per_pixel : i]);
        if (sample > *maximum)
            return fail(wrong("has a sample of " + std::to_string(sample) + " above its maximum"));
        image.rgb[i] = static_cast<std::uint8_t>(sample * factor);
    }
    return image;
}

} // namespace raymarch::pictures
