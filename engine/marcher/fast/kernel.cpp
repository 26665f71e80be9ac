// SPDX-License-Identifier: MIT
#include "engine/marcher/fast/kernel.hpp"

#include "engine/kernel_targets.hpp"
#include "engine/marcher/fast/lane_orders.hpp"
#include "engine/marcher/fast/outline.hpp"
#include "engine/marcher/frame.hpp"
#include "engine/marcher/inverse_sqrt_table.hpp"
#include "engine/marcher/ray_marcher.hpp"
#include "engine/marcher/scene_query.hpp"
#include "engine/marcher/shading.hpp"
#include "engine/marcher/surface_vectors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/marcher/fast/kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 // the plain C++, which is not used

#include "engine/marcher/fast/lanes-inl.hpp"

#include "engine/marcher/fast/compaction-inl.hpp"

#include "engine/marcher/fast/inverse_sqrt-inl.hpp"

#include "engine/marcher/fast/ray_generator-inl.hpp"
#include "engine/marcher/fast/scene_query-inl.hpp"

#include "engine/marcher/fast/pixels-inl.hpp"
#include "engine/marcher/fast/ray_marcher-inl.hpp"
#include "engine/marcher/fast/shading-inl.hpp"
#include "engine/marcher/fast/surface_vectors-inl.hpp"

#include "engine/marcher/fast/region-inl.hpp"

#endif

#if HWY_ONCE

#include "engine/kernel_table.hpp"

namespace raymarch::engine::marcher
{

std::span<const Kernel> kernels() noexcept
{
    static constexpr std::array table = {RAYMARCH_KERNELS(draw)};
    return table;
}

} // namespace raymarch::engine::marcher

#endif
