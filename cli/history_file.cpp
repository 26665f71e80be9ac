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

/// libedit would wait for a FIFO, and replace a device.
std::string unless_it_is_no_file(std::string path)
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
        return unless_it_is_no_file(state_home + name);
    if (is_absolute(home))
        return unless_it_is_no_file(home + ("/.local/state" + name));
    return {};
}

} // namespace raymarch::cli
