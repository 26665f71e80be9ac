// SPDX-License-Identifier: MIT
/// @file
/// Both forms against the second implementation (tests/model/mandelbulb_model.py, wide.tsv): points
/// near and far, every number of steps, powers, frame scales; again with both kinds of 128 bits.
#include "engine/mandelbulb/ray_marcher.hpp"
#include "tests/engine/mandelbulb/vectors.hpp"
#include "tests/engine/mandelbulb/words.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::mandelbulb
{
namespace
{

Arithmetic arithmetic_of(const VectorRow& row)
{
    return {.steps = row.number("N"),
            .kept_bits = row.number("k"),
            .power = row.number("d"),
            .iterations = row.number("I"),
            .derivative =
                row.number("slide") != 0 ? DerivativeForm::Sliding : DerivativeForm::Saturating,
            .scale = row.number("ts")};
}

constexpr const char* outcomes[] = {"hit", "miss", "limit"};

template <typename Format, typename Wide>
void check(const VectorRow& row)
{
    const auto coordinate = [&](const char* name) {
        return static_cast<typename Format::Coordinate>(wide_word<Wide>(row.text(name)));
    };
    const auto floored = [&](const char* name) {
        return static_cast<typename Format::Coordinate>(wide_word<Wide>(row.text(name)) >>
                                                        (64 - Format::fraction_bits));
    };
    const auto direction = [&](const char* name) {
        return static_cast<std::int64_t>(wide_word<Wide>(row.text(name)));
    };
    const Arithmetic with = arithmetic_of(row);
    const Point<Format> point{floored("x"), floored("y"), floored("z")};
    const Orbit<Format> orbit = orbit_of<Format>(point, with);
    EXPECT_TRUE(orbit.r == coordinate("r"));
    EXPECT_EQ(orbit.dr, (Derivative{row.word("dr"), row.number("fd")}));
    EXPECT_TRUE(estimate<Format>(point, with).distance == coordinate("dst"));

    const March<Format> ray =
        march<Format>(point, {direction("rdx"), direction("rdy"), direction("rdz")}, with,
                      {row.number("b"), row.number("most")});
    EXPECT_EQ(outcomes[static_cast<std::size_t>(ray.outcome)], row.text("outcome"));
    EXPECT_EQ(ray.evaluations, row.number("steps"));
    EXPECT_EQ(ray.index, row.number("last_k"));
    EXPECT_TRUE(ray.t == coordinate("t"));
}

template <typename Wide>
class MandelbulbForms : public ::testing::Test
{};
using WideIntegers = ::testing::Types<Int128, PortableInt128>;
TYPED_TEST_SUITE(MandelbulbForms, WideIntegers);

TYPED_TEST(MandelbulbForms, AreThoseOfTheSecondImplementation)
{
    int line = 1;
    for (const VectorRow& row : read_vectors("wide")) {
        SCOPED_TRACE("wide.tsv:" + std::to_string(++line));
        if (row.number("f") == 57)
            check<Q57<TypeParam>, TypeParam>(row);
        else
            check<Q64<TypeParam>, TypeParam>(row);
    }
}

} // namespace
} // namespace raymarch::engine::mandelbulb
