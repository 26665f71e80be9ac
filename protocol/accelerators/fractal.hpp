// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the fractal marcher of source 001 ("FPGA Fractal Ray Marching"): four scenes by sphere
/// tracing in words of Q6.16, in sixteen greys. Its switches and keys are parameters here.
#pragma once

#include "protocol/packer.hpp"
#include "protocol/parameter_table.hpp"

namespace raymarch::protocol::fractal
{

inline constexpr Format word_format = signed_q(6, 16);
inline constexpr Format scene_format = unsigned_q(2, 0);
inline constexpr Format switch_format = unsigned_q(1, 0);
inline constexpr Format hue_format = unsigned_q(8, 0);

inline constexpr std::array<std::string_view, 4> scenes = {"menger", "cubes", "cube", "maze"};
inline constexpr std::array<std::string_view, 2> switches = {"off", "on"};
inline constexpr std::array<std::string_view, 2> collisions = {"faithful", "closed"};

/// Indices into the table below.
enum Index : ParameterIndex {
    X,
    Y,
    Z,
    FX,
    FY,
    FZ,
    SCENE,
    DITHER,
    TEXTURE,
    CHECKER,
    COLOUR,
    HUE,
    COLLISION
};

// Laid out by hand: one row a parameter. The largest number is 32 less a unit of 2^-16.
// clang-format off
inline constexpr auto parameters = complete(std::array{
    Parameter{.key = "X", .meaning = "camera position, x", .unit = "units", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "0", .slices = {{{0, 21, 0}}}},
    Parameter{.key = "Y", .meaning = "camera position, y (up)", .unit = "units", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "1", .slices = {{{1, 21, 0}}}},
    Parameter{.key = "Z", .meaning = "camera position, z", .unit = "units", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "-1.5", .slices = {{{2, 21, 0}}}},
    Parameter{.key = "FX", .meaning = "direction of view, x", .unit = "", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "0", .slices = {{{3, 21, 0}}}},
    Parameter{.key = "FY", .meaning = "direction of view, y (positive looks down)", .unit = "", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "0", .slices = {{{4, 21, 0}}}},
    Parameter{.key = "FZ", .meaning = "direction of view, z", .unit = "", .group = "camera", .format = word_format, .min = "-32", .max = "31.9999847412109375", .initial = "1", .slices = {{{5, 21, 0}}}},
    Parameter{.key = "SCENE", .meaning = "scene", .unit = "", .group = "scene", .format = scene_format, .min = "", .max = "", .initial = "menger", .slices = {{{6, 1, 0}}}, .choices = scenes},
    Parameter{.key = "DITHER", .meaning = "half a grey more by the parity of the pixel", .unit = "", .group = "picture", .format = switch_format, .min = "", .max = "", .initial = "off", .slices = {{{6, 4, 4}}}, .choices = switches},
    Parameter{.key = "TEXTURE", .meaning = "bricks", .unit = "", .group = "picture", .format = switch_format, .min = "", .max = "", .initial = "off", .slices = {{{6, 5, 5}}}, .choices = switches},
    Parameter{.key = "CHECKER", .meaning = "every other pixel a frame", .unit = "", .group = "picture", .format = switch_format, .min = "", .max = "", .initial = "off", .slices = {{{6, 6, 6}}}, .choices = switches},
    Parameter{.key = "COLOUR", .meaning = "greys shown in a hue", .unit = "", .group = "picture", .format = switch_format, .min = "", .max = "", .initial = "off", .slices = {{{6, 7, 7}}}, .choices = switches},
    Parameter{.key = "HUE", .meaning = "hue", .unit = "1/256 turn", .group = "picture", .format = hue_format, .min = "0", .max = "255", .initial = "0", .slices = {{{6, 15, 8}}}},
    Parameter{.key = "COLLISION", .meaning = "walls as leaky as the hardware's, or closed", .unit = "", .group = "walk", .format = switch_format, .min = "", .max = "", .initial = "faithful", .slice_count = 0, .choices = collisions},
});

/// At least two views of each scene.
inline constexpr std::array presets = {
    Preset{"start", "where the hardware stands after reset, its Menger tunnel ahead", "X=0,Y=1,Z=-1.5,FX=0,FY=0,FZ=1,SCENE=menger,DITHER=on,TEXTURE=on"},
    Preset{"menger_shaft", "down a straight shaft of the Menger sponge, with a wide view", "X=1,Y=1,Z=-1.75,FX=0,FY=0,FZ=0.8,SCENE=menger,DITHER=on,TEXTURE=on,COLOUR=on,HUE=18"},
    Preset{"menger_crossing", "a crossing of three shafts, looked at from below", "X=1,Y=1,Z=-1.2,FX=0.33455,FY=-0.20791,FZ=0.91916,SCENE=menger,DITHER=on,TEXTURE=on,COLOUR=on,HUE=150"},
    Preset{"menger_corner", "round a corner of the sponge and down", "X=0.75,Y=1,Z=0,FX=0.83652,FY=0.25882,FZ=0.48296,SCENE=menger,DITHER=on,TEXTURE=on,COLOUR=on,HUE=220"},
    Preset{"cubes", "along a diagonal of the infinite cubes", "X=0.5,Y=0.5,Z=0.5,FX=0.57923,FY=-0.57358,FZ=0.57923,SCENE=cubes,DITHER=on,TEXTURE=on"},
    Preset{"cubes_street", "a street between the cubes", "X=0.5,Y=0.5,Z=0.2,FX=0.26765,FY=-0.18093,FZ=1.25922,SCENE=cubes,DITHER=on,TEXTURE=on,COLOUR=on,HUE=18"},
    Preset{"cubes_above", "the cubes from above", "X=0.5,Y=0.5,Z=0.5,FX=0.975,FY=0.65,FZ=0.56292,SCENE=cubes,DITHER=on,TEXTURE=on,COLOUR=on,HUE=60"},
    Preset{"cube", "one cube over a corner", "X=0.9,Y=0.9,Z=-0.9,FX=-0.71959,FY=0.6359,FZ=0.71959,SCENE=cube,DITHER=on,TEXTURE=on"},
    Preset{"cube_edge", "the cube from near one of its edges", "X=0.75,Y=0.6,Z=-0.6,FX=-0.79087,FY=0.6359,FZ=0.64043,SCENE=cube,DITHER=on,TEXTURE=on,COLOUR=on,HUE=220"},
    Preset{"cube_side", "one side of the cube in the light, one turning away", "X=0.62,Y=0.55,Z=-0.85,FX=-0.59755,FY=0.41042,FZ=0.95629,SCENE=cube,DITHER=on,TEXTURE=on,COLOUR=on,HUE=150"},
    Preset{"maze", "the maze from the start", "X=0,Y=1,Z=-1.5,FX=0,FY=0,FZ=1,SCENE=maze,DITHER=on,TEXTURE=on,COLOUR=on,HUE=180"},
    Preset{"maze_pillar", "a pillar of the maze", "X=0,Y=0,Z=0,FX=0.70711,FY=0,FZ=0.70711,SCENE=maze,DITHER=on,TEXTURE=on,COLOUR=on,HUE=10"},
    Preset{"maze_depth", "into the depth of the maze", "X=0.5,Y=0.9,Z=0.5,FX=0.10527,FY=0.35,FZ=0.59701,SCENE=maze,DITHER=on,TEXTURE=on,COLOUR=on,HUE=120"},
    Preset{"maze_walk", "the maze at twice the frame rate, and walls that hold", "X=0,Y=1,Z=-1.5,FX=0.88623,FY=-0.24311,FZ=1.05617,SCENE=maze,DITHER=on,TEXTURE=on,CHECKER=on,COLOUR=on,HUE=220,COLLISION=closed"},
};
// clang-format on

inline constexpr Accelerator description = {
    .name = "fractal",
    .summary = "four fractal scenes in sixteen greys, bricks, dither, checkerboard (source 001)",
    .kind = 1,
    .first_word_offset = 0x100,
    .word_count = 7,
    .size = {400, 300},
    .max_size = {1600, 1200},
    .ray_units = 12,
    .clock_hz = 40'000'000,
    .parameters = parameters,
    .keys = KeyIndex(parameters),
    .pack = pack_table<parameters>,
    .frame = frame_of(parameters),
    .presets = presets,
    .camera = std::nullopt,
    .colour = std::nullopt,
    .scene = SCENE,
};

} // namespace raymarch::protocol::fractal
