// SPDX-License-Identifier: MIT
#include "engine/marcher/ray_generator.hpp"

#include "engine/marcher/inverse_sqrt.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace raymarch::engine::marcher
{
namespace
{

constexpr int unit_length = 1 << 24;

Frame default_frame()
{
    const protocol::Accelerator& accelerator = protocol::marcher::description;
    return latch(protocol::pack(accelerator, protocol::initial_state(accelerator)));
}

TEST(RayGenerator, TheMiddleLooksStraightAhead)
{
    const Point ray = ray_direction(default_frame(), {5, 3}, 2, 1);
    EXPECT_EQ(ray.x.raw(), 0);
    EXPECT_EQ(ray.y.raw(), 0);
    EXPECT_NEAR(ray.z.raw(), -unit_length, 1);
}

TEST(RayGenerator, DirectionsByHand)
{
    // Of 3 x 3: u, v in -2, 0, 2 and f = 3; v counts upwards.
    const Point top = ray_direction(default_frame(), {3, 3}, 1, 0);
    EXPECT_EQ(top.x.raw(), 0);
    EXPECT_NEAR(top.y.raw(), 2 / std::sqrt(13.0) * unit_length, 2);
    EXPECT_NEAR(top.z.raw(), -3 / std::sqrt(13.0) * unit_length, 2);
    const Point corner = ray_direction(default_frame(), {3, 3}, 2, 2);
    EXPECT_NEAR(corner.x.raw(), 2 / std::sqrt(17.0) * unit_length, 2);
    EXPECT_NEAR(corner.y.raw(), -2 / std::sqrt(17.0) * unit_length, 2);
    EXPECT_NEAR(corner.z.raw(), -3 / std::sqrt(17.0) * unit_length, 2);
}

TEST(RayGenerator, IsSymmetric)
{
    constexpr PictureSize size{40, 30};
    const Frame frame = default_frame();
    for (std::uint16_t y = 0; y < size.height; ++y) {
        for (std::uint16_t x = 0; x < size.width; ++x) {
            const auto mirrored_x = static_cast<std::uint16_t>(size.width - 1 - x);
            const auto mirrored_y = static_cast<std::uint16_t>(size.height - 1 - y);
            const Point ray = ray_direction(frame, size, x, y);
            const Point other = ray_direction(frame, size, mirrored_x, mirrored_y);
            const std::string at = std::to_string(x) + "," + std::to_string(y);
            // The floor of -c is minus the ceiling of c: the sum is 0 or -1.
            EXPECT_LE(std::abs(ray.x.raw() + other.x.raw()), 1) << at;
            EXPECT_LE(std::abs(ray.y.raw() + other.y.raw()), 1) << at;
            EXPECT_EQ(ray.z, other.z) << at;
        }
    }
}

TEST(RayGenerator, DirectionsHaveLengthOne)
{
    constexpr PictureSize largest{1920, 1080};
    Frame frame = default_frame();
    frame.right = {131071, -131072, 131071}; // longer than any camera's, and the numbers still fit
    frame.up = {-131072, 131071, 131071};
    frame.forward = {-131072, -131072, -131072};
    for (const std::uint16_t x : std::array<std::uint16_t, 5>{0, 1, 959, 960, 1919}) {
        for (const std::uint16_t y : std::array<std::uint16_t, 4>{0, 539, 540, 1079}) {
            const Point ray = ray_direction(frame, largest, x, y);
            EXPECT_NEAR(length(ray).raw(), unit_length, 4) << x << ',' << y;
        }
    }
}

} // namespace
} // namespace raymarch::engine::marcher
