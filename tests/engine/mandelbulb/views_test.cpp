// SPDX-License-Identifier: MIT
/// @file
/// Rays of ten views from far to very near, bit for bit (tests/data/mandelbulb/views.tsv).
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "tests/engine/mandelbulb/views.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::mandelbulb
{
namespace
{

template <typename Format>
class MandelbulbViews : public ::testing::Test
{};
using Formats = ::testing::Types<Q57<Int128>, Q57<PortableInt128>>;
TYPED_TEST_SUITE(MandelbulbViews, Formats);

TYPED_TEST(MandelbulbViews, PixelsAreThoseOfTheVectors)
{
    for (const View& view : read_views())
        for (const PixelCheck& pixel : view.pixels) {
            SCOPED_TRACE(view.name + " " + std::to_string(pixel.x) + "," + std::to_string(pixel.y));
            const Direction ray = ray_direction(view.frame, {1280, 720}, pixel.x, pixel.y);
            EXPECT_EQ(ray, pixel.direction);
            const March<TypeParam> end = march<TypeParam>(
                position_in<TypeParam>(view.frame.position), ray, view.frame.arithmetic, {});
            EXPECT_EQ(end.evaluations, pixel.evaluations);
            EXPECT_EQ(end.index, pixel.index);
            EXPECT_EQ(end.t, pixel.t);
        }
}

} // namespace
} // namespace raymarch::engine::mandelbulb
