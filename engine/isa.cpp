// SPDX-License-Identifier: MIT
#include "engine/isa.hpp"

namespace raymarch::engine
{
namespace
{

// Highway's targets of these names are compiled for these sets (hwy/ops/set_macros-inl.h); its own
// answer would take its library, which measures the processor's clock at the start of each program.
#if defined(__x86_64__) || defined(__i386__)
bool runs_sse4() noexcept
{
    return __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("pclmul") != 0 &&
           __builtin_cpu_supports("aes") != 0;
}
/// F16C and LZCNT come with FMA and BMI.
bool runs_avx2() noexcept
{
    return runs_sse4() && __builtin_cpu_supports("avx2") != 0 &&
           __builtin_cpu_supports("fma") != 0 && __builtin_cpu_supports("bmi") != 0 &&
           __builtin_cpu_supports("bmi2") != 0;
}
bool runs_avx512() noexcept
{
    return runs_avx2() && __builtin_cpu_supports("avx512f") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}
#endif
bool runs_anyway() noexcept
{
    return true;
}

struct Target
{
    Isa isa;
    bool (*runs)() noexcept;
};
constexpr std::array targets = {
    Target{Isa::Scalar, runs_anyway},
#if defined(__x86_64__) || defined(__i386__)
    Target{Isa::Sse4, runs_sse4},
    Target{Isa::Avx2, runs_avx2},
    Target{Isa::Avx512, runs_avx512},
#elif defined(__ARM_NEON)
    Target{Isa::Neon, runs_anyway}, // the program is compiled for it
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
