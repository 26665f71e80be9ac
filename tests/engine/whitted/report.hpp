// SPDX-License-Identifier: MIT
/// @file
/// What the tests share: rows of data/whitted/*.tsv, and the report's scenes as frames.
#pragma once

#include "engine/whitted/frame.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace raymarch::engine::whitted::test
{

using Columns = std::vector<std::string>;

/// The rows of a table without its head line, split at tabs.
[[nodiscard]] inline std::vector<Columns> read_table(const std::string& name)
{
    std::istringstream lines(
        raymarch::test::read_text(std::string(RAYMARCH_TEST_DATA "/data/whitted/") + name));
    std::vector<Columns> rows;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        Columns& row = rows.emplace_back();
        std::istringstream columns(line);
        for (std::string column; std::getline(columns, column, '\t');)
            row.push_back(column);
    }
    EXPECT_FALSE(rows.empty()) << name;
    return rows;
}

/// A number, decimal or with 0x.
[[nodiscard]] inline std::int64_t number(const std::string& column)
{
    return std::stoll(column, nullptr, 0);
}

[[nodiscard]] inline Word word(const std::string& column)
{
    return Word::from_raw(number(column));
}

/// The three words from column `at` on.
[[nodiscard]] inline Vector vector_at(const Columns& row, std::size_t at)
{
    return {word(row.at(at)), word(row.at(at + 1)), word(row.at(at + 2))};
}

[[nodiscard]] inline std::array<int, 3> raw(const Vector& v)
{
    return {v.x.raw(), v.y.raw(), v.z.raw()};
}

/// Whole numbers.
[[nodiscard]] constexpr Vector at(int x, int y, int z)
{
    return {Word::from_raw(x * 4096), Word::from_raw(y * 4096), Word::from_raw(z * 4096)};
}

/// The report's room: three black walls, a checkered floor.
[[nodiscard]] inline std::array<Plane, plane_count> room()
{
    const auto wall = [](Vector normal, int offset) {
        Plane plane{.normal = normal, .offset = Word::from_raw(offset * 4096)};
        plane.reflect = 0x800;
        return plane;
    };
    std::array planes = {wall(at(0, 0, -1), 40), wall(at(0, -1, 0), 22), wall(at(-1, 0, 0), 26),
                         wall(at(1, 0, 0), 26)};
    planes[1].colour = ray_colour({29, 29, 29});
    planes[1].checker = 1;
    return planes;
}

/// The spheres, then the light behind them.
inline void set_spheres(Frame& frame, const std::vector<Sphere>& spheres,
                        std::uint16_t light_radius)
{
    frame.last = static_cast<std::uint8_t>(spheres.size());
    std::copy(spheres.begin(), spheres.end(), frame.spheres.begin());
    frame.spheres[frame.last] = make_light(frame.light, light_radius);
}

/// What the machine has after a reset, without spheres.
[[nodiscard]] inline Frame reset_frame(Profile profile)
{
    Frame frame;
    frame.defects = Defects(profile);
    frame.eye = at(0, 0, -32);
    frame.light = at(15, 15, -1);
    frame.screen = Word::from_raw(8 * 4096);
    frame.planes = room();
    set_spheres(frame, {}, 2);
    return frame;
}

/// image1 or image2 of scenes.tsv; the light of image 1 has radius 3.
[[nodiscard]] inline Frame report_frame(Profile profile, const std::string& scene)
{
    std::vector<Sphere> spheres;
    for (const Columns& row : read_table("scenes.tsv")) {
        if (row.at(0) != scene)
            continue;
        const auto five_bits = [&](std::size_t i) {
            return static_cast<std::uint8_t>(number(row.at(i)));
        };
        const auto whole = [&](std::size_t i) { return static_cast<int>(number(row.at(i))); };
        spheres.push_back(make_sphere(
            at(whole(6), whole(7), whole(8)), static_cast<std::uint16_t>(number(row.at(5))),
            {five_bits(1), five_bits(2), five_bits(3)}, static_cast<Weight>(number(row.at(4)))));
    }
    EXPECT_FALSE(spheres.empty()) << scene;
    Frame frame = reset_frame(profile);
    set_spheres(frame, spheres, scene == "image1" ? 3 : 2);
    return frame;
}

/// Optimised builds test everything, the others what they can in a second or two.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
inline constexpr bool optimised = true;
#else
inline constexpr bool optimised = false;
#endif

} // namespace raymarch::engine::whitted::test
