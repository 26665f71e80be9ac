// SPDX-License-Identifier: MIT
/// @file
/// The table of one function in all instruction sets that it was compiled for. Included behind
/// hwy/highway.h by a file that Highway compiles once for each of them (foreach_target.h).
#pragma once

#include "engine/model.hpp"

#include <hwy/highway.h>

/// The kernels of `draw`, which is defined in namespace HWY_NAMESPACE: an initialiser of
/// std::array. Those that were not compiled are nullptr.
#define RAYMARCH_KERNELS(draw)                                                                     \
    ::raymarch::engine::Kernel{::raymarch::engine::Isa::Sse4, HWY_CHOOSE_SSE4(draw)},              \
        ::raymarch::engine::Kernel{::raymarch::engine::Isa::Neon, HWY_CHOOSE_NEON(draw)},          \
        ::raymarch::engine::Kernel{::raymarch::engine::Isa::Avx2, HWY_CHOOSE_AVX2(draw)},          \
        ::raymarch::engine::Kernel                                                                 \
    {                                                                                              \
        ::raymarch::engine::Isa::Avx512, HWY_CHOOSE_AVX3(draw)                                     \
    }
