// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the views that the marcher's engines are timed with.
#pragma once

#include "protocol/accelerators/marcher.hpp"

#include <array>
#include <string_view>

namespace raymarch::bench
{

struct View
{
    std::string_view name;
    std::string_view settings; ///< on top of the initial state
};

/// The initial camera before each scene, then the presets. (Before infinite_cube it stands inside a
/// cube, so that each ray ends where it begins.)
inline constexpr auto views = [] {
    using protocol::marcher::presets;
    std::array<View, 4 + presets.size()> all = {
        View{"initial sphere", "OBJ=sphere"},
        View{"initial cube", "OBJ=cube"},
        View{"initial infinite_cube", "OBJ=infinite_cube"},
        View{"initial tunnel", "OBJ=tunnel"},
    };
    for (std::size_t i = 0; i < presets.size(); ++i)
        all[4 + i] = {presets[i].name, presets[i].settings};
    return all;
}();

} // namespace raymarch::bench
