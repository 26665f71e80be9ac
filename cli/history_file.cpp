// SPDX-License-Identifier: MIT
#include "cli/history_file.hpp"

#include <filesystem>
#include <system_error>

namespace raymarch::cli
{
namespace
{

bool is_absolute(const char* folder) noexcept
{
    return folder != nullptr && *folder == '/';
}

/// Returns an empty path for a FIFO or a device: libedit would wait for a FIFO and replace a
/// device.
std::string ordinary_or_empty(std::string path)
{
    std::error_code ignored;
    const auto there = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        return {};
    return path;
}

} // namespace

std::string history_file(const char* state_home, const char* home)
{
    const std::string name = "/raymarchctl_history";
    if (is_absolute(state_home))
        return ordinary_or_empty(state_home + name);
    if (is_absolute(home))
        return ordinary_or_empty(home + ("/.local/state" + name));
    return {};
}

} // namespace raymarch::cli
