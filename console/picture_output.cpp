// SPDX-License-Identifier: MIT
#include "console/picture_output.hpp"

#include "drivers/atomic_file.hpp"
#include "pictures/picture_file.hpp"

#include <cstdio>

namespace raymarch::console
{

Result<void> write_picture(const engine::Image& image, const std::string& path)
{
    const auto format = pictures::format_of(path);
    if (!format)
        return fail(format.error());
    const auto bytes = pictures::encode(image, *format);
    if (!bytes)
        return fail(bytes.error());
    if (path != "-")
        return drivers::replace_file(path, *bytes, drivers::Durability::BestEffort);
    if (std::fwrite(bytes->data(), 1, bytes->size(), stdout) != bytes->size() ||
        std::fflush(stdout) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "write", "standard output"));
    return {};
}

} // namespace raymarch::console
