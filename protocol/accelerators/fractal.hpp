// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the fractal marcher of source 001 ("FPGA Fractal Ray Marching"): four scenes by sphere
/// tracing in words of Q6.16, in sixteen greys. Its switches and keys are parameters here.
#pragma once

#include "protocol/parameter_table.hpp"

namespace raymarch::protocol::fractal
{

inline constexpr Format word_format = signed_q(6, 16);
inline constexpr Format scene_format = unsigned_q(2, 0);
inline constexpr Format switch_format = unsigned_q(1, 0);
inline constexpr Format hue_format = unsigned_q(8, 0);
inline constexpr Format speed_format = unsigned_q(2, 0);

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
    SPEED,
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
    Parameter{.key = "SPEED", .meaning = "pause between steps (0 is the fastest)", .unit = "", .group = "walk", .format = speed_format, .min = "0", .max = "3", .initial = "0", .slice_count = 0},
    Parameter{.key = "COLLISION", .meaning = "walls as leaky as the hardware's, or closed", .unit = "", .group = "walk", .format = switch_format, .min = "", .max = "", .initial = "faithful", .slice_count = 0, .choices = collisions},
});

inline constexpr auto fields = fields_of(parameters);

/// At least two views of each scene.
inline constexpr std::array presets = {
    Preset{"start", "where the hardware is after reset: the Menger tunnel from one of its crossings", "X=0,Y=1,Z=-1.5,FX=0,FY=0,FZ=1,SCENE=menger"},
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
    .fields = fields.span(),
    .frame = frame_of(parameters),
    .presets = presets,
    .camera = std::nullopt,
    .colour = std::nullopt,
};

} // namespace raymarch::protocol::fractal
