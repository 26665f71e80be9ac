// SPDX-License-Identifier: MIT
#include "tools/research/mandelbulb_reference.hpp"

#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "tests/engine/mandelbulb/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raymarch::tools
{
namespace
{

using namespace engine::mandelbulb;

constexpr engine::PictureSize size{1280, 720};

Frame view(const std::string& name)
{
    for (const View& view : read_views())
        if (view.name == name)
            return view.frame;
    ADD_FAILURE() << name;
    return {};
}

/// How many in a hundred of some rays end within half a ray's distance of those of long double,
/// once the median difference is taken away.
template <typename Depth>
int clean_percent(const Frame& frame, Depth depth)
{
    std::vector<long double> differences;
    long double half_a_ray = 0;
    for (std::uint16_t y = 330; y < 390; y += 6)
        for (std::uint16_t x = 610; x < 670; x += 6) {
            const auto exact = march_reference<long double>(frame, size, x, y, ThetaBy::Atan2);
            half_a_ray = exact.t / size.height / 2;
            differences.push_back(depth(frame, x, y) - exact.t);
        }
    std::vector<long double> sorted = differences;
    std::ranges::sort(sorted);
    const long double shift = sorted[sorted.size() / 2];
    const auto clean = std::ranges::count_if(
        differences, [&](long double d) { return std::fabs(d - shift) <= half_a_ray; });
    return static_cast<int>(static_cast<std::size_t>(clean) * 100 / differences.size());
}

template <typename Real>
long double depth_of_real(const Frame& frame, std::uint16_t x, std::uint16_t y)
{
    return march_reference<Real>(frame, size, x, y, ThetaBy::Atan2).t;
}

long double depth_of_fixed(const Frame& frame, std::uint16_t x, std::uint16_t y)
{
    using Narrow = Q57<Int128>;
    const March<Narrow> ray =
        march<Narrow>(position_in<Narrow>(frame.position), ray_direction(frame, size, x, y),
                      frame.arithmetic, {frame.epsilon_shift, frame.max_evaluations});
    return std::ldexp(static_cast<long double>(ray.t), -57);
}

TEST(MandelbulbReference, AtLevel12AllAreClean)
{
    const Frame frame = view("A_z12");
    EXPECT_GE(clean_percent(frame, depth_of_real<float>), 90);
    EXPECT_GE(clean_percent(frame, depth_of_real<double>), 99);
    EXPECT_GE(clean_percent(frame, depth_of_fixed), 99);
}

TEST(MandelbulbReference, AtLevel26SinglePrecisionIsNot)
{
    const Frame frame = view("A_z26"); // the source's Fig. 9 and 10
    EXPECT_LT(clean_percent(frame, depth_of_real<float>), 50);
    EXPECT_GE(clean_percent(frame, depth_of_real<double>), 95);
    EXPECT_GE(clean_percent(frame, depth_of_fixed), 90);
}

TEST(MandelbulbReference, ARowHasTheColoursOfTheFixedOne)
{
    const Frame frame = view("whole");
    constexpr std::size_t width = 64;
    std::vector<std::uint8_t> real(width * 3), fixed(width * 3);
    std::vector<engine::PixelCost> real_costs(width), fixed_costs(width);
    draw_reference_row<double>(frame, {{width, 36}, 16, 0}, real, real_costs, ThetaBy::Acos);
    draw_row(frame, {{width, 36}, 16, 0}, fixed, fixed_costs);
    int same = 0;
    for (std::size_t x = 0; x < width; ++x)
        same += real_costs[x] == fixed_costs[x] && real[3 * x] == fixed[3 * x] ? 1 : 0;
    EXPECT_GE(same, 62);
    EXPECT_NE(real_costs[0], real_costs[width / 2]);
}

} // namespace
} // namespace raymarch::tools
