// SPDX-License-Identifier: MIT
/// @file
/// The instruction sets that Highway compiles a kernel for: those that have a row in
/// engine/isa.hpp, and its plain C++, without which it does not compile. Newer versions of Highway
/// know more sets, which would only take time. To be included before any header of Highway.
#pragma once

#if defined(__x86_64__) || defined(__i386__)
#define HWY_DISABLED_TARGETS (~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3 | HWY_EMU128 | HWY_SCALAR))
#endif
