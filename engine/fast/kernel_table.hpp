// SPDX-License-Identifier: MIT
/// @file
/// The table of one function in all instruction sets that it was compiled for. Included behind
/// hwy/highway.h by a file that Highway compiles once for each of them (foreach_target.h).
#pragma once

#include "engine/model.hpp"

#include <hwy/highway.h>

#include <array>
#include <span>

/// Lists the kernels of `draw`, which is defined in namespace HWY_NAMESPACE, as initialisers of a
/// std::array. The function is nullptr for an instruction set that was not compiled.
#define RAYMARCH_KERNELS(draw)                                                                     \
    ::raymarch::engine::Kernel{::raymarch::engine::Isa::Sse4, HWY_CHOOSE_SSE4(draw)},              \
        ::raymarch::engine::Kernel{::raymarch::engine::Isa::Neon, HWY_CHOOSE_NEON(draw)},          \
        ::raymarch::engine::Kernel{::raymarch::engine::Isa::Avx2, HWY_CHOOSE_AVX2(draw)},          \
        ::raymarch::engine::Kernel                                                                 \
    {                                                                                              \
        ::raymarch::engine::Isa::Avx512, HWY_CHOOSE_AVX3(draw)                                     \
    }

/// Defines the accelerator's kernels(), which engine/fast/kernels.hpp declares.
#define RAYMARCH_DEFINE_KERNELS(accelerator)                                                       \
    std::span<const raymarch::engine::Kernel>                                                      \
    raymarch::engine::accelerator::fast::kernels() noexcept                                        \
    {                                                                                              \
        static constexpr std::array table = {RAYMARCH_KERNELS(draw)};                              \
        return table;                                                                              \
    }
