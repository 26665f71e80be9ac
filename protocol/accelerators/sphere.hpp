// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the sphere tracer of source 002 ("Real Time Ray Tracing"): spheres and lights by integer
/// intersection, as the hardware draws one sphere and as the C prototype draws several. The widths
/// are those of the prototype. The hardware's registers hold the lower bits
/// (docs/engine/sphere.md).
#pragma once

#include "protocol/packer.hpp"
#include "protocol/parameter_table.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace raymarch::protocol::sphere
{

/// The format of coordinates: the hardware's 16 unsigned bits, and a sign.
inline constexpr Format coordinate_format = signed_q(17, 0);
inline constexpr Format radius_format = unsigned_q(16, 0);
inline constexpr Format strength_format = unsigned_q(31, 0);

inline constexpr std::array<std::string_view, 4> models = {"rtl", "rtl_top", "rtl_timed", "c"};
inline constexpr std::array<std::string_view, 3> faults = {"kept", "repaired", "corrected"};
inline constexpr std::array<std::string_view, 2> tints = {"yellow", "grey"};

/// Indices into the table below; spheres and lights have four columns a row.
enum Index : ParameterIndex { MODEL, FAULTS, TINT, N, M, CUTOFF, D, K, EX, EY, EZ, F, S1 };

using SphereKeys = RowKeys<"S", 3, "X", "Y", "Z", "R">;
using LightKeys = RowKeys<"L", 8, "X", "Y", "Z", "S">;

inline constexpr ParameterIndex L1 = S1 + SphereKeys::rows * SphereKeys::columns;

// Laid out by hand: one row a parameter.
// clang-format off
inline constexpr std::array settings = {
    Parameter{.key = "MODEL", .meaning = "whose arithmetic: the hardware's core, its frame buffer one pixel late, that with its divider's timing, the C prototype", .unit = "", .group = "mode", .format = unsigned_q(2, 0), .min = "", .max = "", .initial = "rtl", .slices = {{{0, 1, 0}}}, .choices = models},
    Parameter{.key = "FAULTS", .meaning = "the source's faults: kept, without the two slips of the ray-sphere unit, corrected", .unit = "", .group = "mode", .format = unsigned_q(2, 0), .min = "", .max = "", .initial = "kept", .slices = {{{0, 3, 2}}}, .choices = faults},
    Parameter{.key = "TINT", .meaning = "colour of the hardware's 16 shades", .unit = "", .group = "mode", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "yellow", .slices = {{{0, 4, 4}}}, .choices = tints},
    Parameter{.key = "N", .meaning = "number of spheres; the hardware has one", .unit = "", .group = "spheres", .format = unsigned_q(2, 0), .min = "0", .max = "3", .initial = "1", .slices = {{{0, 9, 8}}}},
    Parameter{.key = "M", .meaning = "number of lights; the hardware has one", .unit = "", .group = "lights", .format = unsigned_q(4, 0), .min = "0", .max = "8", .initial = "1", .slices = {{{0, 15, 12}}}},
    Parameter{.key = "CUTOFF", .meaning = "what a point without light shows: of 15, c of 255", .unit = "", .group = "shading", .format = unsigned_q(8, 0), .min = "0", .max = "255", .initial = "2", .slices = {{{0, 23, 16}}}},
    Parameter{.key = "D", .meaning = "derounder: points move towards the ray's start by 1/(2D) of its segment; 0: not at all", .unit = "", .group = "shading", .format = unsigned_q(16, 0), .min = "0", .max = "65535", .initial = "75", .slices = {{{1, 31, 16}}}},
    Parameter{.key = "K", .meaning = "calibration, the factor of every strength; the hardware's ten switches", .unit = "", .group = "shading", .format = unsigned_q(16, 0), .min = "0", .max = "65535", .initial = "200", .slices = {{{1, 15, 0}}}},
    Parameter{.key = "EX", .meaning = "camera position, x, to the right", .unit = "units", .group = "camera", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "320", .slices = {{{2, 16, 0}}}},
    Parameter{.key = "EY", .meaning = "camera position, y, downwards", .unit = "units", .group = "camera", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "240", .slices = {{{3, 16, 0}}}},
    Parameter{.key = "EZ", .meaning = "camera position, z, into the picture", .unit = "units", .group = "camera", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "0", .slices = {{{4, 16, 0}}}},
    Parameter{.key = "F", .meaning = "z of the screen plane, on which pixel (x, y) is the point (x, y)", .unit = "units", .group = "camera", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "1000", .slices = {{{5, 16, 0}}}},
};

inline constexpr std::array sphere_pattern = {
    Parameter{.key = "X", .meaning = "centre of a sphere, x; the prototype's are red, green and blue", .unit = "units", .group = "spheres", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "0", .slices = {{{6, 16, 0}}}},
    Parameter{.key = "Y", .meaning = "centre of a sphere, y", .unit = "units", .group = "spheres", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "0", .slices = {{{7, 16, 0}}}},
    Parameter{.key = "Z", .meaning = "centre of a sphere, z", .unit = "units", .group = "spheres", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "0", .slices = {{{8, 16, 0}}}},
    Parameter{.key = "R", .meaning = "radius of a sphere", .unit = "units", .group = "spheres", .format = radius_format, .min = "0", .max = "65535", .initial = "0", .slices = {{{9, 15, 0}}}},
};

inline constexpr std::array light_pattern = {
    Parameter{.key = "X", .meaning = "position of a light, x", .unit = "units", .group = "lights", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "50", .slices = {{{18, 16, 0}}}},
    Parameter{.key = "Y", .meaning = "position of a light, y", .unit = "units", .group = "lights", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "50", .slices = {{{19, 16, 0}}}},
    Parameter{.key = "Z", .meaning = "position of a light, z", .unit = "units", .group = "lights", .format = coordinate_format, .min = "-65536", .max = "65535", .initial = "1000", .slices = {{{20, 16, 0}}}},
    Parameter{.key = "S", .meaning = "strength of a light: times K, over the distance squared", .unit = "", .group = "lights", .format = strength_format, .min = "0", .max = "2147483647", .initial = "0", .slices = {{{21, 30, 0}}}},
};
// clang-format on

/// The first sphere is the hardware's at power-up; the others stand beside it.
consteval auto sphere_rows()
{
    auto rows = repeated_rows<SphereKeys>(sphere_pattern, 4);
    const std::array<std::string_view, rows.size()> initial = {
        "320", "240", "1100", "100", "180", "160", "1000", "60", "460", "330", "1200", "80"};
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].initial = initial[i];
    return rows;
}

/// The first light is the hardware's at power-up; the others are off.
consteval auto light_rows()
{
    auto rows = repeated_rows<LightKeys>(light_pattern, 4);
    rows[3].initial = "4095";
    return rows;
}

inline constexpr auto parameters = complete(joined(settings, sphere_rows(), light_rows()));
static_assert(parameters[S1].key == "S1.X" && parameters[L1].key == "L1.X");

// Laid out by hand: one row a preset.
// clang-format off
inline constexpr std::array presets = {
    Preset{"board", "what the board's screen shows first: one pixel late, some quotients stale", "MODEL=rtl_timed,S1.X=325"},
    Preset{"core", "the hardware's core by itself, its lit side turned away from the light", "S1.X=325"},
    Preset{"core_close", "the same from close by: the slip in x bends the light's edge", "F=600,S1.Z=900,S1.R=300,L1.X=80,L1.Y=20,L1.Z=500,L1.S=16000"},
    Preset{"repaired", "the first frame without the two slips of the ray-sphere unit", "FAULTS=repaired,S1.X=325"},
    Preset{"shades", "sixteen shades of grey, corrected, from close by", "FAULTS=corrected,TINT=grey,F=600,S1.Z=900,S1.R=300,L1.X=80,L1.Y=20,L1.Z=500,L1.S=4000"},
    Preset{"prototype", "the C prototype's own scene", "MODEL=c,F=300,K=75,D=25,CUTOFF=25,N=2,S1.X=200,S1.Y=240,S1.Z=400,S1.R=100,S2.X=260,S2.Y=100,S2.Z=500,S2.R=50,M=2,L1.X=50,L1.Y=50,L1.Z=500,L1.S=150000,L2.X=0,L2.Y=350,L2.Z=400,L2.S=50000"},
    Preset{"prototype_demo", "the C prototype with the hardware's scene", "MODEL=c,K=75,CUTOFF=25,L1.S=60000"},
    Preset{"overlap", "three spheres as the prototype overlaps them: the first one's colour, the last one's place", "MODEL=c,F=600,K=75,D=200,CUTOFF=25,N=3,S1.X=170,S1.Y=270,S1.Z=950,S1.R=170,S2.X=480,S2.Y=200,S2.Z=1100,S2.R=190,S3.X=340,S3.Y=360,S3.Z=760,S3.R=80,M=3,L1.X=80,L1.Y=20,L1.Z=620,L1.S=160000,L2.X=620,L2.Y=100,L2.Z=780,L2.S=110000,L3.X=300,L3.Y=250,L3.Z=600,L3.S=50000"},
    Preset{"trio", "the same three, the nearest in front", "MODEL=c,FAULTS=corrected,F=600,K=75,D=200,CUTOFF=25,N=3,S1.X=170,S1.Y=270,S1.Z=950,S1.R=170,S2.X=480,S2.Y=200,S2.Z=1100,S2.R=190,S3.X=340,S3.Y=360,S3.Z=760,S3.R=80,M=3,L1.X=80,L1.Y=20,L1.Z=620,L1.S=160000,L2.X=620,L2.Y=100,L2.Z=780,L2.S=110000,L3.X=300,L3.Y=250,L3.Z=600,L3.S=50000"},
    Preset{"eclipse", "a small sphere's shadow on a large one", "MODEL=c,FAULTS=corrected,F=500,K=75,D=300,CUTOFF=20,N=2,S1.X=360,S1.Y=250,S1.Z=800,S1.R=260,S2.X=250,S2.Y=150,S2.Z=450,S2.R=50,L1.X=150,L1.Y=60,L1.Z=330,L1.S=260000"},
    Preset{"room", "inside a sphere, with two others and two lights", "MODEL=c,FAULTS=corrected,F=300,K=75,D=100,CUTOFF=10,N=3,S1.Z=200,S1.R=1200,S2.X=180,S2.Y=280,S2.Z=700,S2.R=130,S3.X=480,S3.Y=220,S3.Z=800,S3.R=150,M=2,L1.X=320,L1.Y=-300,L1.Z=300,L1.S=1500000,L2.X=700,L2.Y=600,L2.Z=200,L2.S=500000"},
    Preset{"wide", "a screen plane close to the eye: spheres at the sides stretch", "MODEL=c,FAULTS=corrected,F=150,K=75,D=75,CUTOFF=20,N=3,S1.X=60,S1.Y=240,S1.Z=260,S1.R=120,S2.X=320,S2.Y=280,S2.Z=300,S2.R=110,S3.X=600,S3.Y=200,S3.Z=270,S3.R=120,M=2,L1.X=200,L1.Y=60,L1.Z=100,L1.S=60000,L2.X=480,L2.Y=80,L2.Z=100,L2.S=60000"},
};
// clang-format on

inline constexpr Accelerator description = {
    .name = "sphere",
    .summary = "spheres and lights by integer intersection, shadows, inverse square (source 002)",
    .kind = 2,
    .first_word_offset = 0x100,
    .word_count = 50,
    .size = {640, 480},
    .max_size = {1920, 1080},
    .ray_units = 1,
    .clock_hz = 100'000'000,
    .parameters = parameters,
    .keys = KeyIndex(parameters),
    .pack = pack_table<parameters>,
    .frame = frame_of(parameters),
    .presets = presets,
    .camera = std::nullopt,
    .colour = std::nullopt,
    .scene = std::nullopt,
};

} // namespace raymarch::protocol::sphere
