// SPDX-License-Identifier: MIT
#include "engine/whitted/fast/kernels.hpp"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3 // no model has a row for it
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/whitted/fast/kernels.cpp" // once for each instruction set
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR // Highway's own, compiled where nothing else is certain to run
#include "engine/whitted/fast/picture-inl.hpp"
#endif

#if HWY_ONCE
#include "engine/kernel_table.hpp"

namespace raymarch::engine::whitted::fast
{

std::span<const Kernel> kernels() noexcept
{
    static constexpr std::array all = {RAYMARCH_KERNELS(draw)};
    return all;
}

} // namespace raymarch::engine::whitted::fast
#endif
