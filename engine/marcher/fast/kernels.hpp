// SPDX-License-Identifier: MIT
/// @file
/// The marcher on vectors: the same bytes and costs as draw_row, from the same stages, many pixels
/// at a time (docs/engine.md, "Fast kernels").
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine::marcher::fast
{

/// See Model.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;

} // namespace raymarch::engine::marcher::fast
