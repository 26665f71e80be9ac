// SPDX-License-Identifier: MIT
/// @file
/// Finds a function in a module. A module stays loaded: that takes longer than a picture to draw.
#pragma once

namespace raymarch::pictures
{

/// Null when the module is not installed or lacks the function.
[[nodiscard]] void* find_in_module(const char* file, const char* symbol);

template <typename Function>
[[nodiscard]] Function module_function(const char* file, const char* symbol)
{
    return reinterpret_cast<Function>(find_in_module(file, symbol));
}

} // namespace raymarch::pictures
