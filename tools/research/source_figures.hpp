// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the speeds that the sources print.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace raymarch::tools::source
{

// The tables are formatted by hand: one row for each line of the source.
// clang-format off

/// Source 000, Table 9: a sphere at 640x480, at 100 MHz.
struct MarcherFigure
{
    std::string_view hardware;
    unsigned units;
    double fps;
};
inline constexpr std::array marcher_figures = {
    MarcherFigure{"single-cycle", 1, 5.13},
    MarcherFigure{"pipelined",    1, 7.25},
    MarcherFigure{"parallel x4",  4, 27.7},
};

/// Source 001, Table II: 4, 8 and 12 ray units at 40 MHz, plain and with the checkerboard.
inline constexpr std::array fractal_units = {4U, 8U, 12U};
struct FractalFigure
{
    std::string_view scene;
    std::array<unsigned, fractal_units.size()> plain;
    std::array<unsigned, fractal_units.size()> checker;
};
inline constexpr std::array fractal_figures = {
    FractalFigure{"menger", {16, 30, 44}, {32,  56,  82}},
    FractalFigure{"cubes",  {27, 50, 70}, {51, 114, 112}},
    FractalFigure{"cube",   {33, 59, 89}, {60, 107, 140}},
    FractalFigure{"maze",   { 9, 17, 26}, {17,  32,  49}},
};

/// Source 002, sections "RTCore Setup", "Ray-Sphere Intersection", "Division". `clocks` are those of a pixel
/// in the source, or 0 if it has none.
struct SphereFigure
{
    std::string_view claim;
    unsigned clocks;
    double fps;
};
inline constexpr std::array sphere_figures = {
    SphereFigure{"worst case, two runs of 3500 clocks",          7000, 0.05},
    SphereFigure{"worst case, divider optimised, two of 400",     800, 0.5},
    SphereFigure{"black screen, miss optimised",                  128, 2.5},
    SphereFigure{"a sphere on 3 % of the screen, as it is",         0, 0.7},
    SphereFigure{"the same, optimised",                             0, 5},
};

/// Source 003, Tables I and II and the sections of the two boards; at 100 MHz.
struct MandelbulbFigure
{
    std::string_view board;
    std::string_view claim;
    std::uint16_t width;
    std::uint16_t height;
    double fps;
};
inline constexpr std::array mandelbulb_figures = {
    MandelbulbFigure{"Nexys Video", "fastest",    1280, 720, 5},
    MandelbulbFigure{"Nexys Video", "at depth",   1280, 720, 1},
    MandelbulbFigure{"Nexys Video", "peak power", 1280, 720, 0.96},
    MandelbulbFigure{"Nexys 4 DDR", "start view",  640, 480, 10},
    MandelbulbFigure{"Nexys 4 DDR", "peak power",  640, 480, 1.8},
};

/// Source 004, Fig. 12: 25 MHz, 512x480 except the last row.
struct WhittedFigure
{
    std::string_view preset; ///< our preset with the same scene
    std::string_view planes;
    std::string_view anti_aliasing;
    unsigned reflections;
    std::uint16_t width;
    std::uint16_t height;
    std::uint64_t rays;
    std::uint64_t cycles;
    std::string_view fps;
};
inline constexpr std::array whitted_figures = {
    WhittedFigure{"image1_room", "off", "off", 0, 512, 480,    277'814,  12'662'119, "1.974"},
    WhittedFigure{"image1_room", "off", "off", 3, 512, 480,    310'175,  14'003'794, "1.785"},
    WhittedFigure{"image1_room", "off", "8x",  0, 512, 480,  2'500'295, 113'981'083, "0.219"},
    WhittedFigure{"image1_room", "off", "8x",  3, 512, 480,  2'792'565, 126'094'828, "0.198"},
    WhittedFigure{"image1_room", "on",  "off", 0, 512, 480,    490'699,  22'300'008, "1.121"},
    WhittedFigure{"image1_room", "on",  "off", 3, 512, 480,  1'802'813,  78'305'473, "0.319"},
    WhittedFigure{"image1_room", "on",  "8x",  0, 512, 480,  4'413'303, 200'596'329, "0.125"},
    WhittedFigure{"image1_room", "on",  "8x",  3, 512, 480, 16'213'574, 704'338'405, "0.035"},
    WhittedFigure{"image2_room", "off", "off", 0, 512, 480,    353'528,  22'544'244, "1.109"},
    WhittedFigure{"image2_room", "off", "off", 3, 512, 480,    547'627,  33'850'568, "0.739"},
    WhittedFigure{"image2_room", "off", "8x",  0, 512, 480,  3'182'440, 203'017'700, "0.123"},
    WhittedFigure{"image2_room", "off", "8x",  3, 512, 480,  4'929'447, 304'791'218, "0.082"},
    WhittedFigure{"image2_room", "on",  "off", 0, 512, 480,    492'358,  28'868'738, "0.866"},
    WhittedFigure{"image2_room", "on",  "off", 3, 512, 480,  1'804'498, 102'301'169, "0.244"},
    WhittedFigure{"image2_room", "on",  "8x",  0, 512, 480,  4'428'189, 259'797'987, "0.096"},
    WhittedFigure{"image2_room", "on",  "8x",  3, 512, 480, 16'225'005, 920'108'168, "0.027"},
    WhittedFigure{"image1_room", "off", "off", 0, 320, 240,    108'422,   4'678'168, "5.344"},
};
// clang-format on

} // namespace raymarch::tools::source
