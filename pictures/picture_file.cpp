// SPDX-License-Identifier: MIT
#include "pictures/picture_file.hpp"

#include "pictures/load_module.hpp"
#include "pictures/module.hpp"
#include "pictures/png_file.hpp"

#include <array>
#include <cctype>

namespace raymarch::pictures
{
namespace
{

struct Ending
{
    std::string_view name;
    PictureFormat format;
};
constexpr std::array endings = {
    Ending{"png", PictureFormat::Png},   Ending{"jpg", PictureFormat::Jpeg},
    Ending{"jpeg", PictureFormat::Jpeg}, Ending{"ppm", PictureFormat::Ppm},
    Ending{"tga", PictureFormat::Tga},
};

using Bytes = std::vector<std::uint8_t>;

Bytes encode_ppm(const engine::Image& image)
{
    const std::string header = "P6\n" + std::to_string(image.size.width) + ' ' +
                               std::to_string(image.size.height) + "\n255\n";
    Bytes bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), image.rgb.begin(), image.rgb.end());
    return bytes;
}

/// Uncompressed true colour, 24 bits, rows from the top.
Bytes encode_tga(const engine::Image& image)
{
    Bytes bytes(18);
    bytes[2] = 2;
    bytes[12] = static_cast<std::uint8_t>(image.size.width);
    bytes[13] = static_cast<std::uint8_t>(image.size.width >> 8);
    bytes[14] = static_cast<std::uint8_t>(image.size.height);
    bytes[15] = static_cast<std::uint8_t>(image.size.height >> 8);
    bytes[16] = 24;
    bytes[17] = 0x20;
    for (std::size_t i = 0; i < image.rgb.size(); i += engine::bytes_per_pixel)
        bytes.insert(bytes.end(), {image.rgb[i + 2], image.rgb[i + 1], image.rgb[i]});
    return bytes;
}

Result<Bytes> encode_with_opencv(const engine::Image& image, const char* extension)
{
    const auto function = module_function<EncodeFunction>(module_file, encode_symbol);
    if (function == nullptr)
        return fail(plain_error(ErrorKind::Unavailable,
                                std::string("writing ") + extension + " needs OpenCV's module " +
                                    module_file +
                                    ", which is not installed; .png, .ppm and .tga do not"));
    Bytes bytes;
    const ByteSink append = [](void* context, const std::uint8_t* data, std::size_t count) {
        auto* const target = static_cast<Bytes*>(context);
        target->insert(target->end(), data, data + count);
    };
    if (!function(extension, image.rgb.data(), image.size.width, image.size.height, append, &bytes))
        return fail(
            plain_error(ErrorKind::InputOutput,
                        std::string("OpenCV could not encode the picture as ") + extension));
    return bytes;
}

} // namespace

Result<PictureFormat> format_of(std::string_view path)
{
    if (path == "-")
        return PictureFormat::Ppm;
    const std::size_t dot = path.rfind('.');
    std::string ending(dot == std::string_view::npos ? "" : path.substr(dot + 1));
    for (char& c : ending)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const Ending& row : endings)
        if (row.name == ending)
            return row.format;
    std::string allowed;
    for (const Ending& row : endings)
        allowed += (allowed.empty() ? "." : ", .") + std::string(row.name);
    return fail(plain_error(ErrorKind::Usage, std::string(path) + ": a picture's name ends in " +
                                                  allowed + "; - is ppm on standard output"));
}

Result<Bytes> encode(const engine::Image& image, PictureFormat format)
{
    switch (format) {
    case PictureFormat::Ppm:
        return encode_ppm(image);
    case PictureFormat::Tga:
        return encode_tga(image);
    case PictureFormat::Png:
        return encode_png(image);
    case PictureFormat::Jpeg:
        return encode_with_opencv(image, ".jpg");
    }
    return fail(plain_error(ErrorKind::Usage, "no such picture format"));
}

} // namespace raymarch::pictures
