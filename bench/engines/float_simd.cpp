// SPDX-License-Identifier: MIT
#include "engines/float_simd.hpp"

#include "engine/fast/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engines/float_simd.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

#include "engines/float_region-inl.hpp"

#endif

#if HWY_ONCE

#include "engine/fast/kernel_table.hpp"

#include <array>

namespace raymarch::engine::marcher::fast
{
namespace
{

constexpr std::array float_table = {RAYMARCH_KERNELS(draw_float)};

} // namespace
} // namespace raymarch::engine::marcher::fast

namespace raymarch::bench
{

std::span<const engine::Kernel> float_kernels() noexcept
{
    return engine::marcher::fast::float_table;
}

} // namespace raymarch::bench

#endif
