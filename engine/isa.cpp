// SPDX-License-Identifier: MIT
#include "engine/isa.hpp"

#include <hwy/targets.h>

namespace raymarch::engine
{
namespace
{

struct Target
{
    Isa isa;
    std::int64_t bit; ///< Highway's
};
constexpr std::array targets = {
    Target{Isa::Sse4, HWY_SSE4},
    Target{Isa::Neon, HWY_NEON},
    Target{Isa::Avx2, HWY_AVX2},
    Target{Isa::Avx512, HWY_AVX3},
};

} // namespace

bool supported(Isa isa) noexcept
{
    // The library asks the processor only where it can; what this program is compiled for runs
    // anyway.
    static const std::int64_t here = hwy::SupportedTargets() | HWY_STATIC_TARGET;
    for (const Target& target : targets)
        if (target.isa == isa)
            return (here & target.bit) != 0;
    return isa == Isa::Scalar;
}

} // namespace raymarch::engine
