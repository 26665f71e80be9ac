// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the marcher of source 000 (Imperial College, "Mathematical Accelerator"): signed distance
/// scenes by sphere tracing in Q8.24. Fields, widths and formats: its Tables 4 to 6; ranges:
/// §5.1.2.
#pragma once

#include "protocol/packer.hpp"
#include "protocol/parameter_table.hpp"

namespace raymarch::protocol::marcher
{

inline constexpr Format direction_format = signed_q(1, 17);
inline constexpr Format zoom_format = unsigned_q(8, 24);
inline constexpr Format light_format = signed_q(7, 3);
inline constexpr Format colour_format = unsigned_q(0, 10);
inline constexpr Format object_format = unsigned_q(2, 0);

inline constexpr std::array<std::string_view, 4> scenes = {"sphere", "cube", "infinite_cube",
                                                           "tunnel"};

/// Indices into the table below.
enum Index : ParameterIndex { FX, FY, FZ, RX, RY, RZ, UX, UY, UZ, ZM, LX, LY, LZ, R, G, B, OBJ };

// Laid out by hand: one row a parameter.
// clang-format off
inline constexpr auto parameters = complete(std::array{
    Parameter{.key = "FX", .meaning = "camera basis, from the target to the camera, x", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{2, 31, 14}}}},
    Parameter{.key = "FY", .meaning = "camera basis, from the target to the camera, y", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{2, 13, 0}, {3, 31, 28}}}, .slice_count = 2},
    Parameter{.key = "FZ", .meaning = "camera basis, from the target to the camera, z", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "1", .slices = {{{3, 27, 10}}}},
    Parameter{.key = "RX", .meaning = "camera basis, to the right, x", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "1", .slices = {{{4, 31, 14}}}},
    Parameter{.key = "RY", .meaning = "camera basis, to the right, y", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{4, 13, 0}, {5, 31, 28}}}, .slice_count = 2},
    Parameter{.key = "RZ", .meaning = "camera basis, to the right, z", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{5, 27, 10}}}},
    Parameter{.key = "UX", .meaning = "camera basis, upwards, x", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{6, 31, 14}}}},
    Parameter{.key = "UY", .meaning = "camera basis, upwards, y", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "1", .slices = {{{6, 13, 0}, {7, 31, 28}}}, .slice_count = 2},
    Parameter{.key = "UZ", .meaning = "camera basis, upwards, z", .unit = "", .group = "camera", .format = direction_format, .min = "-1", .max = "1", .initial = "0", .slices = {{{7, 27, 10}}}},
    Parameter{.key = "ZM", .meaning = "distance of the camera from the target (zoom)", .unit = "units", .group = "camera", .format = zoom_format, .min = "0", .max = "10", .initial = "3", .slices = {{{1, 31, 0}}}},
    Parameter{.key = "LX", .meaning = "light position, x", .unit = "units", .group = "light", .format = light_format, .min = "-64", .max = "63.875", .initial = "3", .slices = {{{0, 29, 20}}}},
    Parameter{.key = "LY", .meaning = "light position, y", .unit = "units", .group = "light", .format = light_format, .min = "-64", .max = "63.875", .initial = "2", .slices = {{{0, 19, 10}}}},
    Parameter{.key = "LZ", .meaning = "light position, z", .unit = "units", .group = "light", .format = light_format, .min = "-64", .max = "63.875", .initial = "5", .slices = {{{0, 9, 0}}}},
    Parameter{.key = "R", .meaning = "surface colour, red", .unit = "", .group = "colour", .format = colour_format, .min = "0", .max = "1", .initial = "1", .slices = {{{3, 9, 0}}}},
    Parameter{.key = "G", .meaning = "surface colour, green", .unit = "", .group = "colour", .format = colour_format, .min = "0", .max = "1", .initial = "1", .slices = {{{5, 9, 0}}}},
    Parameter{.key = "B", .meaning = "surface colour, blue", .unit = "", .group = "colour", .format = colour_format, .min = "0", .max = "1", .initial = "1", .slices = {{{7, 9, 0}}}},
    Parameter{.key = "OBJ", .meaning = "scene", .unit = "", .group = "object", .format = object_format, .min = "", .max = "", .initial = "sphere", .slices = {{{0, 31, 30}}}, .choices = scenes},
});

/// At least two views of each scene; every camera stands in free space.
inline constexpr std::array presets = {
    Preset{"sphere", "the unit sphere from the front, lit from the upper right", "FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=1.9,LX=3,LY=2,LZ=5,R=1,G=1,B=1,OBJ=sphere"},
    Preset{"sphere_dawn", "the sphere from above with the light low at its side", "FX=0.2962,FY=0.5,FZ=0.8138,RX=0.93969,RY=0,RZ=-0.34202,UX=-0.17101,UY=0.86603,UZ=-0.46985,ZM=1.7,LX=6,LY=2,LZ=1,R=1,G=0.6,B=0.3,OBJ=sphere"},
    Preset{"cube", "the cube over one corner", "FX=0.57923,FY=0.57358,FZ=0.57923,RX=0.70711,RY=0,RZ=-0.70711,UX=-0.40558,UY=0.81915,UZ=-0.40558,ZM=1.5,LX=1,LY=4,LZ=2.5,R=0.9,G=0.75,B=0.2,OBJ=cube"},
    Preset{"cube_edge", "the cube edge-on, lit from the left", "FX=0.59737,FY=0.24192,FZ=0.7646,RX=0.78801,RY=0,RZ=-0.61566,UX=-0.14894,UY=0.9703,UZ=-0.19064,ZM=1.35,LX=-3,LY=2,LZ=5,R=0.3,G=0.8,B=0.9,OBJ=cube"},
    Preset{"lattice", "into the infinite lattice from a gap between the cubes", "FX=0.19245,FY=0.19245,FZ=0.96225,RX=0.98058,RY=0,RZ=-0.19612,UX=-0.03774,UY=0.98131,UZ=-0.18871,ZM=2.59808,LX=0.5,LY=1.5,LZ=3,R=0.4,G=0.9,B=0.6,OBJ=infinite_cube"},
    Preset{"lattice_diagonal", "the lattice along a slanting street", "FX=0.76249,FY=0.4575,FZ=0.4575,RX=0.5145,RY=0,RZ=-0.85749,UX=-0.3923,UY=0.88921,UZ=-0.23538,ZM=3.27872,LX=3,LY=3,LZ=1,R=1,G=0.5,B=0.7,OBJ=infinite_cube"},
    Preset{"tunnel", "down the straight shaft of the Menger tunnel", "FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=2,LX=0.25,LY=0.5,LZ=2,R=0.5,G=0.7,B=1,OBJ=tunnel"},
    Preset{"tunnel_turn", "a crossing of the Menger tunnel, seen from its middle", "FX=0.42262,FY=0,FZ=0.90631,RX=0.90631,RY=0,RZ=-0.42262,UX=0,UY=1,UZ=0,ZM=0,LX=0.5,LY=0.75,LZ=0,R=1,G=0.8,B=0.5,OBJ=tunnel"},
};
// clang-format on

inline constexpr Accelerator description = {
    .name = "marcher",
    .summary = "signed distance scenes by sphere tracing, Lambert and ambient light (source 000)",
    .kind = 0,
    .first_word_offset = 0x00,
    .word_count = 8,
    .size = {640, 480},
    .max_size = {1920, 1080},
    .ray_units = 4,
    .clock_hz = 100'000'000,
    .parameters = parameters,
    .keys = KeyIndex(parameters),
    .pack = pack_table<parameters>,
    .frame = frame_of(parameters),
    .presets = presets,
    .camera =
        OrbitCamera{.forward = {FX, FY, FZ}, .right = {RX, RY, RZ}, .up = {UX, UY, UZ}, .zoom = ZM},
    .colour = Colour{{R, G, B}},
    .scene = OBJ,
};

} // namespace raymarch::protocol::marcher
