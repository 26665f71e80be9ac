// SPDX-License-Identifier: MIT
/// @file
/// What source 000 began with: its loop in scalar floating point (Fig. 3 and 4), one pixel after
/// the other. Its basis and scenes are this project's, so that it draws the same views.
#pragma once

#include "engine/model.hpp"

namespace raymarch::bench
{

/// As Kernel::draw; costs are not counted. The same source, compiled with -O2 and with
/// -O3 -march=native.
void draw_student_o2(const engine::Picture& picture, const engine::Region& region,
                     const engine::Canvas& canvas) noexcept;
void draw_student_native(const engine::Picture& picture, const engine::Region& region,
                         const engine::Canvas& canvas) noexcept;

} // namespace raymarch::bench
