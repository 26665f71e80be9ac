// SPDX-License-Identifier: MIT
#include "engine/isa.hpp"

#include "engine/draw.hpp"
#include "engine/models.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <utility>

namespace raymarch::engine
{
namespace
{

TEST(Isa, NamesAndRowsBelongTogether)
{
    for (const IsaRow& row : isa_rows) {
        EXPECT_EQ(name_of(row.isa), row.name);
        EXPECT_EQ(find_isa(row.name), row.isa);
    }
    EXPECT_FALSE(find_isa("AVX2"));
    EXPECT_FALSE(find_isa(""));
}

TEST(Isa, ScalarRunsEverywhereAndIsTheReference)
{
    EXPECT_TRUE(supported(Isa::Scalar));
    for (const Model& model : models)
        EXPECT_EQ(kernel_of(model, Isa::Scalar), nullptr);
}

/// The library that compiles the kernels says the same of this processor.
TEST(Isa, HighwayAgrees)
{
    const std::int64_t here = hwy::SupportedTargets() | HWY_STATIC_TARGET;
    for (const auto& [isa, bit] :
         {std::pair{Isa::Sse4, HWY_SSE4}, std::pair{Isa::Avx2, HWY_AVX2},
          std::pair{Isa::Avx512, HWY_AVX3}, std::pair{Isa::Neon, HWY_NEON}})
        EXPECT_EQ(supported(isa), (here & bit) != 0) << name_of(isa);
}

TEST(Isa, TheFastestKernelIsOneThatRunsHere)
{
    for (const Model& model : models) {
        const Kernel* const best = kernel_of(model);
        if (best == nullptr)
            continue; // the reference alone
        EXPECT_TRUE(supported(best->isa));
        EXPECT_EQ(kernel_of(model, best->isa), best);
        for (const IsaRow& row : isa_rows)
            EXPECT_TRUE(kernel_of(model, row.isa) == nullptr || row.isa <= best->isa);
    }
}

} // namespace
} // namespace raymarch::engine
