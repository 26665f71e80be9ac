// SPDX-License-Identifier: MIT
#include "engine/fast/kernels.hpp"

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
RAYMARCH_DEFINE_KERNELS(marcher)
#endif
