// SPDX-License-Identifier: MIT
/// @file
/// Reads tests/data/mandelbulb/views.tsv: a camera a row, and checked pixels of 1280 x 720.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "tests/engine/mandelbulb/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace raymarch::engine::mandelbulb
{

struct PixelCheck
{
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    Direction direction{};
    int evaluations = 0;
    int index = 0;
    std::int64_t t = 0;
};

struct View
{
    std::string name;
    Frame frame{};
    std::vector<PixelCheck> pixels{};
};

/// "i,j:rdx:rdy:rdz:steps,k,t"
inline PixelCheck pixel_check(std::string text)
{
    std::ranges::replace(text, ',', ' ');
    std::ranges::replace(text, ':', ' ');
    std::istringstream fields(text);
    PixelCheck pixel;
    std::string x, y, z, t;
    fields >> pixel.x >> pixel.y >> x >> y >> z >> pixel.evaluations >> pixel.index >> t;
    EXPECT_TRUE(fields) << text;
    pixel.direction = {direction_word(x), direction_word(y), direction_word(z)};
    pixel.t = direction_word(t);
    return pixel;
}

inline std::vector<View> read_views()
{
    std::ifstream file(RAYMARCH_TEST_DATA "/data/mandelbulb/views.tsv");
    std::string line;
    std::getline(file, line);
    std::vector<View> views;
    while (std::getline(file, line)) {
        std::istringstream columns(line);
        View view;
        std::string s[3], f[3], r[3], u[3];
        columns >> view.name >> s[0] >> s[1] >> s[2] >> f[0] >> f[1] >> f[2];
        columns >> r[0] >> r[1] >> r[2] >> u[0] >> u[1] >> u[2];
        const auto direction = [](const std::string(&hex)[3]) {
            return Direction{direction_word(hex[0]), direction_word(hex[1]),
                             direction_word(hex[2])};
        };
        view.frame.position = {wide_word<Int128>(s[0]), wide_word<Int128>(s[1]),
                               wide_word<Int128>(s[2])};
        view.frame.forward = direction(f);
        view.frame.right = direction(r);
        view.frame.up = direction(u);
        for (std::string pixel; columns >> pixel;)
            view.pixels.push_back(pixel_check(pixel));
        views.push_back(view);
    }
    EXPECT_FALSE(views.empty());
    return views;
}

} // namespace raymarch::engine::mandelbulb
