// SPDX-License-Identifier: MIT
#include "engine/isa.hpp"

#include "engine/draw.hpp"
#include "engine/models.hpp"

#include <gtest/gtest.h>

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
