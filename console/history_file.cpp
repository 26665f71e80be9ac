// SPDX-License-Identifier: MIT
#include "console/history_file.hpp"

namespace raymarch::console
{
namespace
{

bool is_absolute(const char* folder) noexcept
{
    return folder != nullptr && *folder == '/';
}

} // namespace

std::string history_file(const char* state_home, const char* home)
{
    const std::string name = "/raymarchctl_history";
    if (is_absolute(state_home))
        return state_home + name;
    if (is_absolute(home))
        return home + ("/.local/state" + name);
    return {};
}

} // namespace raymarch::console
