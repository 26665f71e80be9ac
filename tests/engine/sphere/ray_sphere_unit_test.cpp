// SPDX-License-Identifier: MIT
#include "engine/sphere/ray_sphere_unit.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::engine::sphere
{
namespace
{

enum Set : std::size_t { Kept, Repaired, Corrected, Prototype };

struct Choice
{
    Design design;
    Faults faults;
};
constexpr std::array<Choice, 4> sets = {{{Design::Rtl, Faults::Kept},
                                         {Design::Rtl, Faults::Repaired},
                                         {Design::Rtl, Faults::Corrected},
                                         {Design::Prototype, Faults::Kept}}};

struct Row
{
    Line line;
    Ball ball;
    Reach reach;
    int derounder;
    Set set;
    End end;
    Point point;
};

constexpr Line along_z{{0, 0, 0}, {0, 0, 10}};            // a = 100
constexpr Line from_middle{{50, 50, 100}, {50, 50, 110}}; // the same, elsewhere
constexpr Ball ahead{{0, 0, 100}, 10};                    // T = 2200 and 1800 of 200, t = 11 and 9
constexpr Ball behind{{50, 50, 50}, 10};                  // t = -4 and -6
constexpr Ball around{{50, 50, 100}, 30};                 // t = 3 and -3
constexpr Ball touching{{10, 0, 100}, 10};                // t = 10, once
constexpr Ball past{{10, 1, 100}, 10};                    // by a little
constexpr Ball close{{50, 50, 104}, 10};                  // t = 1.4 and -0.6
constexpr Ball within{{50, 50, 105}, 2};                  // t = 0.7 and 0.3
constexpr Point none{};

// One row a case: the line, the ball, the reach, the derounder, the rules, what comes out.
// clang-format off
constexpr std::array rows = {
    // Straight ahead: z = 1800 * 10 / 200; the derounder takes 100 / 75 = 1 off, so 89.95.
    Row{along_z, ahead, Reach::Ray, 0, Kept, End::Hits, {0, 0, 90}},
    Row{along_z, ahead, Reach::Ray, 75, Kept, End::Hits, {0, 0, 89}},
    Row{along_z, ahead, Reach::Ray, 75, Corrected, End::Hits, {0, 0, 89}},
    Row{along_z, ahead, Reach::Ray, 75, Prototype, End::Hits, {0, 0, 89}},
    Row{along_z, past, Reach::Ray, 0, Kept, End::Misses, none},
    Row{along_z, past, Reach::Ray, 0, Prototype, End::Misses, none},
    // A line that only touches.
    Row{along_z, touching, Reach::Ray, 0, Kept, End::Misses, none},
    Row{along_z, touching, Reach::Ray, 0, Repaired, End::Misses, none},
    Row{along_z, touching, Reach::Ray, 0, Corrected, End::Hits, {0, 0, 100}},
    Row{along_z, touching, Reach::Ray, 0, Prototype, End::Hits, {0, 0, 100}},
    // A sphere behind the eye: drawn by the hardware. In x the far root stands in the first
    // product: (-800 * 50 + 1400 * 50) / 200 = 150.
    Row{from_middle, behind, Reach::Ray, 0, Kept, End::Hits, {150, 50, 40}},
    Row{from_middle, behind, Reach::Ray, 0, Repaired, End::Rejected, none},
    Row{from_middle, behind, Reach::Ray, 0, Corrected, End::Rejected, none},
    Row{from_middle, behind, Reach::Ray, 0, Prototype, End::Rejected, none},
    // The eye inside: the near root, which is behind it, unless corrected.
    Row{from_middle, around, Reach::Ray, 0, Repaired, End::Hits, {50, 50, 70}},
    Row{from_middle, around, Reach::Ray, 0, Corrected, End::Hits, {50, 50, 130}},
    Row{from_middle, around, Reach::Ray, 0, Prototype, End::Hits, {50, 50, 70}},
    // On the way to a light: something behind blocks it in the hardware, something between always.
    Row{from_middle, behind, Reach::Segment, 0, Kept, End::Hits, {150, 50, 40}},
    Row{from_middle, behind, Reach::Segment, 0, Repaired, End::Rejected, none},
    Row{from_middle, within, Reach::Segment, 0, Repaired, End::Hits, {50, 50, 103}},
    Row{from_middle, within, Reach::Segment, 0, Corrected, End::Hits, {50, 50, 103}},
    // One root before it and one beyond: both ends inside one sphere.
    Row{from_middle, around, Reach::Segment, 0, Repaired, End::Hits, {50, 50, 70}},
    Row{from_middle, around, Reach::Segment, 0, Prototype, End::Hits, {50, 50, 70}},
    Row{from_middle, around, Reach::Segment, 0, Corrected, End::Rejected, none},
    Row{from_middle, close, Reach::Segment, 0, Corrected, End::Rejected, none},
    // Both beyond.
    Row{along_z, ahead, Reach::Segment, 0, Kept, End::Rejected, none},
    Row{along_z, ahead, Reach::Segment, 0, Corrected, End::Rejected, none},
    // A line of no length: the strict comparison ends it first.
    Row{{none, none}, ahead, Reach::Ray, 0, Kept, End::Misses, none},
    Row{{none, none}, ahead, Reach::Ray, 0, Prototype, End::Rejected, none},
    Row{{none, none}, ahead, Reach::Ray, 0, Corrected, End::Rejected, none},
    // Towards zero, not downwards: -30.25 is -30, and in 16 bits 65506.
    Row{{{0, 0, 0}, {0, 0, 2}}, {{0, 0, -10}, 20}, Reach::Ray, 0, Prototype, End::Hits, {0, 0, -30}},
    Row{{{0, 0, 0}, {0, 0, 2}}, {{0, 0, -10}, 20}, Reach::Ray, 4, Prototype, End::Hits, {0, 0, -30}},
    Row{{{0, 0, 0}, {0, 0, 2}}, {{0, 0, -10}, 20}, Reach::Ray, 0, Kept, End::Hits, {0, 0, 65506}},
    // Saturation: the far root of a sphere around the eye, beyond the numbers.
    Row{along_z, {{0, 0, 131'071}, 131'071}, Reach::Segment, 0, Corrected, End::Rejected, none},
    Row{{{0, 0, 131'000}, {0, 0, 131'010}}, {{0, 0, 131'000}, 131'000}, Reach::Ray, 0, Corrected, End::Hits, {0, 0, 131'071}},
    // Beyond the prototype's range: a = 2^32 wraps to 0, b = 0.
    Row{{{0, 0, 0}, {0, 0, 65'536}}, ahead, Reach::Ray, 0, Prototype, End::Rejected, none},
    Row{{{0, 0, 0}, {0, 0, 65'536}}, ahead, Reach::Ray, 0, Corrected, End::Hits, {0, 0, 90}},
};
// clang-format on

TEST(RaySphereUnit, CasesByHand)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        const Rules& rules = rules_of(sets[row.set].design, sets[row.set].faults);
        const Strike strike = intersect(rules, row.line, row.ball, row.reach, row.derounder);
        EXPECT_EQ(strike.end, row.end) << "row " << i;
        EXPECT_EQ(strike.point, row.point) << "row " << i << ": " << strike.point.x << ' '
                                           << strike.point.y << ' ' << strike.point.z;
    }
}

/// A negative T is a huge one to the hardware, so only roots from 0 to 9 are below its threshold.
TEST(RaySphereUnit, TheUnsignedThreshold)
{
    // a = 1, b = -2 z, c = z^2 - r^2: T1, T2 = 2 (z +- r), against 10.
    const Line line{{0, 0, 0}, {0, 0, 1}};
    const auto ends = [&](Faults faults, int z, int r) {
        return intersect(rules_of(Design::Rtl, faults), line, {{0, 0, z}, r}, Reach::Segment, 0)
            .end;
    };
    EXPECT_EQ(ends(Faults::Kept, 2, 1), End::Rejected); // 6 and 2
    EXPECT_EQ(ends(Faults::Kept, 2, 2), End::Rejected); // 8 and 0
    EXPECT_EQ(ends(Faults::Kept, 2, 3), End::Hits);     // 10 and -2; one at most 2 a
    EXPECT_EQ(ends(Faults::Kept, 1, 2), End::Hits);     // 6 and -2
    EXPECT_EQ(ends(Faults::Kept, -5, 2), End::Hits);    // -6 and -14
    EXPECT_EQ(ends(Faults::Repaired, 2, 3), End::Hits); // 10 is not below it
    EXPECT_EQ(ends(Faults::Repaired, 1, 2), End::Rejected);
    EXPECT_EQ(ends(Faults::Repaired, -5, 2), End::Rejected);
    EXPECT_EQ(ends(Faults::Corrected, 2, 3), End::Rejected); // 10 is past the other end, 2
}

} // namespace
} // namespace raymarch::engine::sphere
