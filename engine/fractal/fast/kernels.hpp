// SPDX-License-Identifier: MIT
/// @file
/// The fractal's kernels: the pixels of fractal.hpp in vectors (docs/engine/fractal.md, "Fast
/// kernels").
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine::fractal::fast
{

/// See Model.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;

} // namespace raymarch::engine::fractal::fast
