// SPDX-License-Identifier: MIT
/// @file
/// Limits the instruction sets that Highway compiles to those in engine/isa.hpp, and to plain C++,
/// which Highway requires. Newer versions of Highway know more sets, which would only take time.
/// Include this before any header of Highway.
#pragma once

#if defined(__x86_64__) || defined(__i386__)
#define HWY_DISABLED_TARGETS (~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3 | HWY_EMU128 | HWY_SCALAR))
#endif
