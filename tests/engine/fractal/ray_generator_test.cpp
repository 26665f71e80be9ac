// SPDX-License-Identifier: MIT
#include "engine/fractal/ray_generator.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace raymarch::engine::fractal
{
namespace
{

TEST(RayGenerator, ThePlaneOfTheHardwaresSizes)
{
    for (const auto& [size, step] : {std::pair{PictureSize{400, 300}, 436},
                                     {PictureSize{200, 150}, 873},
                                     {PictureSize{100, 75}, 1747}}) {
        const Plane plane = plane_of(size);
        EXPECT_EQ(plane.left, word(-87382));
        EXPECT_EQ(plane.top, -one);
        EXPECT_EQ(plane.step, word(step));
    }
}

TEST(RayGenerator, AnyPlaneIsFlooredFrom20Bits)
{
    for (std::uint16_t height = 1; height <= 1200; ++height) {
        for (const std::uint16_t width : {std::uint16_t{1}, std::uint16_t{401}, height}) {
            const Plane plane = plane_of({width, height});
            const std::int64_t step = (std::int64_t{2} << 20) / height / 16;
            const std::int64_t scaled = std::int64_t{width} << 20;
            const std::int64_t left = -((scaled + height - 1) / height);
            EXPECT_EQ(plane.step, Number::from_raw(step));
            EXPECT_EQ(plane.left, Number::from_raw(left >> 4)) << width << 'x' << height;
        }
    }
}

TEST(RayGenerator, RowZeroLooksUp)
{
    const Camera camera = camera_along({word(0), word(0), one});
    const Plane plane = plane_of({400, 300});
    const Point top = ray_direction(camera, plane, 200, 0);
    EXPECT_NEAR(top.y.raw(), 65536 / std::sqrt(2), 40);
    EXPECT_NEAR(top.z.raw(), 65536 / std::sqrt(2), 40);
    EXPECT_GT(ray_direction(camera, plane, 399, 150).x, word(0));
}

TEST(RayGenerator, APositiveForwardYLooksDown)
{
    const Camera camera = camera_along({word(0), half, one});
    EXPECT_LT(ray_direction(camera, plane_of({400, 300}), 200, 150).y, word(0));
}

TEST(RayGenerator, TheSignOfYComesBehindTheFloor)
{
    // Below the middle v.y is positive and its product almost never exact: minus the floor.
    const Camera camera = camera_along({word(0), word(0), one});
    const Plane plane = plane_of({400, 300});
    const Point above = ray_direction(camera, plane, 200, 0); // v.y = -1
    EXPECT_EQ(above.y.raw(), above.z.raw());                  // exact: n itself
    const Camera turned = camera_along({word(1), word(0), word(65535)});
    EXPECT_EQ(turned.right, (Point{word(65535), word(0), word(-1)}));
    EXPECT_EQ(turned.up, (Point{word(0), word(65534), word(0)}));
    const Camera down = camera_along({word(3), word(5), word(7)});
    EXPECT_EQ(down.up, (Point{word(-1), word(0), word(0)})); // floor(5 * -3), -floor(5 * 7)
}

TEST(RayGenerator, DirectionsHaveAboutLengthOne)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    for (int i = 0; i < 2000; ++i) {
        const double turn = raymarch::test::pick(random, 0, 6283) / 1000.0;
        const auto at = [](double c) { return word(static_cast<std::int32_t>(c * 65535)); };
        const Camera camera = camera_along({at(std::sin(turn)), word(0), at(std::cos(turn))});
        const Point d = ray_direction(camera, plane_of({400, 300}),
                                      raymarch::test::pick<std::uint16_t>(random, 0, 399),
                                      raymarch::test::pick<std::uint16_t>(random, 0, 299));
        const double length = std::hypot(d.x.raw(), d.y.raw(), d.z.raw()) / 65536;
        EXPECT_NEAR(length, 1, 0.0012);
    }
}

} // namespace
} // namespace raymarch::engine::fractal
