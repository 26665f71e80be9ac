// SPDX-License-Identifier: MIT
#include "cli/picture_output.hpp"

#include "drivers/user_file.hpp"
#include "pictures/picture_file.hpp"

namespace raymarch::cli
{

void add_picture_output_option(CLI::App& command, std::string& path)
{
    command
        .add_option("-o,--output", path,
                    "file for the picture; the ending of its name is png, jpg, ppm or tga; - is "
                    "ppm on standard output")
        ->type_name("FILE")
        ->required();
}

Result<void> check_picture_output(const std::string& path)
{
    if (const auto format = pictures::format_of(path); !format)
        return fail(format.error());
    return drivers::check_output(path);
}

Result<void> write_picture(const engine::Image& image, const std::string& path)
{
    const auto format = pictures::format_of(path);
    if (!format)
        return fail(format.error());
    const auto bytes = pictures::encode(image, *format);
    if (!bytes)
        return fail(bytes.error());
    return drivers::write_output(path, *bytes);
}

} // namespace raymarch::cli
