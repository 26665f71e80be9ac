// SPDX-License-Identifier: MIT
/// @file
/// The accelerators in vectors: the same bytes and costs as the plain scalar models, many pixels at
/// a time ("Fast kernels" on each model's page). See Model::kernels.
#pragma once

#include "engine/model.hpp"

#include <span>

namespace raymarch::engine
{

namespace fractal::fast
{
[[nodiscard]] std::span<const Kernel> kernels() noexcept;
}
namespace mandelbulb::fast
{
[[nodiscard]] std::span<const Kernel> kernels() noexcept;
}
namespace marcher::fast
{
[[nodiscard]] std::span<const Kernel> kernels() noexcept;
}
namespace sphere::fast
{
/// The span is empty on 32-bit ARM, whose vectors have no double.
[[nodiscard]] std::span<const Kernel> kernels() noexcept;
} // namespace sphere::fast
namespace whitted::fast
{
[[nodiscard]] std::span<const Kernel> kernels() noexcept;
}

} // namespace raymarch::engine
