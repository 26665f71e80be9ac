// SPDX-License-Identifier: MIT
/// @file
/// The marcher's kernel in floating point: the same structure, the same outlines, vectors and
/// compaction, without the contract of bits. What it is faster by is what exactness costs.
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::bench
{

/// One an instruction set, as Model::kernels has them; costs are not counted.
[[nodiscard]] std::span<const engine::Kernel> float_kernels() noexcept;

} // namespace raymarch::bench
