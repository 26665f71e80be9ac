// SPDX-License-Identifier: MIT
#include "engine/isa.hpp"

namespace raymarch::engine
{
namespace
{

using Ask = bool (*)() noexcept;

struct Target
{
    Isa isa;
    Ask runs;
};

// What Highway's targets of these names are compiled for (hwy/detect_targets.h); its own answer
// would take its library, which measures the processor's clock at the start of each program.
constexpr std::array targets = {
    Target{Isa::Scalar, []() noexcept { return true; }},
#if defined(__x86_64__) || defined(__i386__)
    Target{Isa::Sse4,
           []() noexcept {
               return __builtin_cpu_supports("sse4.2") != 0 &&
                      __builtin_cpu_supports("pclmul") != 0 && __builtin_cpu_supports("aes") != 0;
           }},
    Target{Isa::Avx2,
           []() noexcept {
               return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                      __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
           }},
    Target{Isa::Avx512,
           []() noexcept {
               return __builtin_cpu_supports("avx512f") != 0 &&
                      __builtin_cpu_supports("avx512bw") != 0 &&
                      __builtin_cpu_supports("avx512cd") != 0 &&
                      __builtin_cpu_supports("avx512dq") != 0 &&
                      __builtin_cpu_supports("avx512vl") != 0;
           }},
#elif defined(__ARM_NEON)
    Target{Isa::Neon,
           []() noexcept { return true; }}, // what the program is compiled for runs anyway
#endif
};

} // namespace

bool supported(Isa isa) noexcept
{
    for (const Target& target : targets)
        if (target.isa == isa)
            return target.runs();
    return false;
}

} // namespace raymarch::engine
