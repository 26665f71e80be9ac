// SPDX-License-Identifier: MIT
#include "engines/float_simd.hpp"

#include "engine/kernel_targets.hpp"
#include "engine/marcher/fast/lane_orders.hpp"
#include "engine/marcher/fast/outline.hpp"
#include "engine/marcher/frame.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engines/float_simd.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

#include "engine/marcher/fast/lanes-inl.hpp"

#include "engine/marcher/fast/compaction-inl.hpp"
#include "engine/marcher/fast/pixels-inl.hpp"
#include "engines/float_stages-inl.hpp"

#include "engines/float_region-inl.hpp"

#endif

#if HWY_ONCE

#include "engine/kernel_table.hpp"

namespace raymarch::engine::marcher
{
namespace
{

constexpr std::array float_table = {RAYMARCH_KERNELS(draw_float)};

} // namespace
} // namespace raymarch::engine::marcher

namespace raymarch::bench
{

std::span<const engine::Kernel> float_kernels() noexcept
{
    return engine::marcher::float_table;
}

} // namespace raymarch::bench

#endif
