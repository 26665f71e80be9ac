// SPDX-License-Identifier: MIT
/// @file
/// The Mandelbulb's kernels: the pixels of mandelbulb.hpp in vectors (docs/engine/mandelbulb.md,
/// "Fast kernels").
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine::mandelbulb::fast
{

/// See Model.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;

} // namespace raymarch::engine::mandelbulb::fast
