// SPDX-License-Identifier: MIT
#include "engine/marcher/fast/kernels.hpp"

#include "engine/fast/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/marcher/fast/kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 // the plain C++, which is not used
#include "engine/marcher/fast/region-inl.hpp"
#endif

#if HWY_ONCE
#include "engine/fast/kernel_table.hpp"

#include <array>

namespace raymarch::engine::marcher::fast
{

std::span<const Kernel> kernels() noexcept
{
    static constexpr std::array table = {RAYMARCH_KERNELS(draw)};
    return table;
}

} // namespace raymarch::engine::marcher::fast
#endif
