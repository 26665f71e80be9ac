// SPDX-License-Identifier: MIT
/// @file
/// Every block against its vectors, bit for bit: with the machine's 128-bit products and with our
/// own.
#include "engine/mandelbulb/distance.hpp"
#include "tests/engine/mandelbulb/vectors.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::mandelbulb
{
namespace
{

template <typename Format>
class MandelbulbBlocks : public ::testing::Test
{};
using Formats = ::testing::Types<Q57<Int128>, Q57<PortableInt128>>;
TYPED_TEST_SUITE(MandelbulbBlocks, Formats);

/// Calls check(row, N) for each row of both files of a block.
template <typename Check>
void for_each_row(const std::string& block, Check check)
{
    for (const int steps : {32, 57}) {
        const std::string name = block + "_N" + std::to_string(steps);
        int line = 1;
        for (const VectorRow& row : read_vectors(name)) {
            SCOPED_TRACE(name + ".tsv:" + std::to_string(++line));
            check(row, steps);
        }
    }
}

Arithmetic arithmetic_of(const VectorRow& row, int steps)
{
    return {.steps = steps,
            .kept_bits = row.number("k"),
            .power = row.number("d"),
            .derivative =
                row.number("slide") != 0 ? DerivativeForm::Sliding : DerivativeForm::Saturating};
}

TYPED_TEST(MandelbulbBlocks, Vectoring)
{
    for_each_row("vectoring", [](const VectorRow& row, int steps) {
        const auto [magnitude, angle] = to_polar<TypeParam>(row.raw("x"), row.raw("y"), steps);
        EXPECT_EQ(magnitude, row.raw("mag"));
        EXPECT_EQ(angle, row.word("angle"));
    });
}

TYPED_TEST(MandelbulbBlocks, Rotation)
{
    for_each_row("rotation", [](const VectorRow& row, int steps) {
        const auto [x, y] = to_cartesian<TypeParam>(row.raw("r"), row.word("angle"), steps);
        EXPECT_EQ(x, row.raw("r_cos"));
        EXPECT_EQ(y, row.raw("r_sin"));
    });
}

TYPED_TEST(MandelbulbBlocks, ApproximateProduct)
{
    for_each_row("amul", [](const VectorRow& row, int) {
        EXPECT_EQ(approximate_product<TypeParam>(row.raw("a"), row.raw("b"), row.number("k")),
                  row.raw("product"));
    });
}

TYPED_TEST(MandelbulbBlocks, Logarithm)
{
    for_each_row("ln", [](const VectorRow& row, int steps) {
        EXPECT_EQ(logarithm<TypeParam>(row.raw("r"), steps), row.raw("ln_r"));
    });
}

TYPED_TEST(MandelbulbBlocks, Division)
{
    for_each_row("divide", [](const VectorRow& row, int steps) {
        const Derivative dr{row.word("dr"), row.number("fd")};
        EXPECT_EQ(divide<TypeParam>(row.raw("num"), dr, row.number("ts"), steps), row.raw("quot"));
    });
}

TYPED_TEST(MandelbulbBlocks, Iteration)
{
    for_each_row("iteration", [](const VectorRow& row, int steps) {
        Orbit<TypeParam> orbit{.w = {row.raw("x"), row.raw("y"), row.raw("z")},
                               .c = {row.raw("cx"), row.raw("cy"), row.raw("cz")},
                               .dr = {row.word("dr"), row.number("fd")}};
        const bool goes_on = iterate(orbit, arithmetic_of(row, steps), Last::No);
        EXPECT_EQ(goes_on, row.number("hold") == 0);
        EXPECT_EQ(orbit.r, row.raw("r"));
        EXPECT_EQ(orbit.w, (Point<TypeParam>{row.raw("x1"), row.raw("y1"), row.raw("z1")}));
        EXPECT_EQ(orbit.dr, (Derivative{row.word("dr1"), row.number("fd1")}));
    });
}

TYPED_TEST(MandelbulbBlocks, Distance)
{
    for_each_row("distance", [](const VectorRow& row, int steps) {
        Arithmetic with = arithmetic_of(row, steps);
        with.scale = row.number("ts");
        const Point<TypeParam> point{row.raw("cx"), row.raw("cy"), row.raw("cz")};
        const Orbit<TypeParam> orbit = orbit_of<TypeParam>(point, with);
        EXPECT_EQ(orbit.index, row.number("last_k"));
        EXPECT_EQ(orbit.r, row.raw("r"));
        EXPECT_EQ(orbit.dr, (Derivative{row.word("dr"), row.number("fd")}));
        EXPECT_EQ(estimate<TypeParam>(point, with).distance, row.raw("dst"));
    });
}

} // namespace
} // namespace raymarch::engine::mandelbulb
