// SPDX-License-Identifier: MIT
#include "engine/whitted/fast/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/whitted/fast/kernels.cpp" // once for each instruction set
#include <hwy/foreach_target.h>

#include "engine/whitted/fast/picture-inl.hpp"

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
