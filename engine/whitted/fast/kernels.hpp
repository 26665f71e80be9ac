// SPDX-License-Identifier: MIT
/// @file
/// The ray tracer in vectors: the same bits as the stages beside this folder, many rays at once.
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine::whitted::fast
{

/// See Model.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;

} // namespace raymarch::engine::whitted::fast
