// SPDX-License-Identifier: MIT
/// @file
/// The sphere tracer's kernels: the pixels of sphere.hpp in vectors (docs/engine/sphere.md, "Fast
/// kernels"). What a picture owes to its order stays with finish().
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine::sphere::fast
{

/// See Model. None where the vectors have no numbers of 53 bits.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;

} // namespace raymarch::engine::sphere::fast
