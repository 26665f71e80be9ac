// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the ray tracer of source 004 (spheres and planes, shadows, reflections, anti-aliasing) in
/// 12.12, as a machine of 14 spheres, 4 planes and a light. The numbers are
/// explained in docs/engine/whitted.md.
#pragma once

#include "protocol/packer.hpp"
#include "protocol/parameter_table.hpp"

namespace raymarch::protocol::whitted
{

inline constexpr Format word_format = signed_q(12, 12);
inline constexpr Format normal_format = signed_q(12, 12);
inline constexpr Format share_format = unsigned_q(0, 12);
inline constexpr Format channel_format = unsigned_q(5, 0);
inline constexpr Format radius_format = unsigned_q(11, 0);
inline constexpr Format limit_format = unsigned_q(12, 0);
inline constexpr Format velocity_format = signed_q(8, 24);

inline constexpr std::array<std::string_view, 2> profiles = {"measured", "repaired"};
inline constexpr std::array<std::string_view, 3> anti_aliasings = {"off", "4x", "8x"};
inline constexpr std::array<std::string_view, 2> switches = {"off", "on"};
inline constexpr std::array<std::string_view, 2> motions = {"original", "repaired"};

/// Indices into the table below: single values, then the spheres' rows, then the planes'.
enum Index : ParameterIndex {
    PROFILE,
    EX,
    EY,
    EZ,
    LX,
    LY,
    LZ,
    LR,
    S,
    REFLECTIONS,
    AA,
    PLANES,
    N,
    MOTION,
    XMIN,
    XMAX,
    YMIN,
    YMAX,
    ZMIN,
    ZMAX,
    first_sphere
};

/// Columns of S1 to S14.
namespace sphere
{
enum Column : ParameterIndex { X, Y, Z, RADIUS, R, G, B, REFLECT, VX, VY, VZ };
using Keys = RowKeys<"S", 14, "X", "Y", "Z", "RADIUS", "R", "G", "B", "REFLECT", "VX", "VY", "VZ">;
} // namespace sphere

/// Columns of P1 to P4.
namespace plane
{
enum Column : ParameterIndex {
    A,
    B,
    C,
    D,
    RED,
    GREEN,
    BLUE,
    CHECKER,
    BOUNDED,
    REFLECT,
    XL,
    YL,
    ZL
};
using Keys = RowKeys<"P", 4, "A", "B", "C", "D", "RED", "GREEN", "BLUE", "CHECKER", "BOUNDED",
                     "REFLECT", "XL", "YL", "ZL">;
} // namespace plane

[[nodiscard]] constexpr std::size_t index_of(sphere::Column column, std::size_t row) noexcept
{
    return first_sphere + row * sphere::Keys::columns + column;
}
[[nodiscard]] constexpr std::size_t index_of(plane::Column column, std::size_t row) noexcept
{
    return index_of(sphere::X, sphere::Keys::rows) + row * plane::Keys::columns + column;
}

// Laid out by hand: one row a parameter.
// clang-format off
inline constexpr std::array single_values = {
    Parameter{.key = "PROFILE", .meaning = "the original machine with its defects, or without them", .unit = "", .group = "machine", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "repaired", .slices = {{{0, 31, 31}}}, .choices = profiles},
    Parameter{.key = "EX", .meaning = "eye, x", .unit = "units", .group = "eye", .format = word_format, .min = "-1024", .max = "1024", .initial = "0", .slices = {{{1, 31, 8}}}},
    Parameter{.key = "EY", .meaning = "eye, y, downwards", .unit = "units", .group = "eye", .format = word_format, .min = "-1024", .max = "1024", .initial = "0", .slices = {{{2, 31, 8}}}},
    Parameter{.key = "EZ", .meaning = "eye, z, into the picture", .unit = "units", .group = "eye", .format = word_format, .min = "-1024", .max = "1024", .initial = "-32", .slices = {{{3, 31, 8}}}},
    Parameter{.key = "LX", .meaning = "light position, x", .unit = "units", .group = "light", .format = word_format, .min = "-1024", .max = "1024", .initial = "15", .slices = {{{4, 31, 8}}}},
    Parameter{.key = "LY", .meaning = "light position, y", .unit = "units", .group = "light", .format = word_format, .min = "-1024", .max = "1024", .initial = "15", .slices = {{{5, 31, 8}}}},
    Parameter{.key = "LZ", .meaning = "light position, z", .unit = "units", .group = "light", .format = word_format, .min = "-1024", .max = "1024", .initial = "-1", .slices = {{{6, 31, 8}}}},
    Parameter{.key = "LR", .meaning = "radius that the light is drawn with", .unit = "units", .group = "light", .format = radius_format, .min = "1", .max = "2047", .initial = "2", .slices = {{{0, 10, 0}}}},
    Parameter{.key = "S", .meaning = "distance of the screen from z = 0; larger is a telescope", .unit = "32 units", .group = "eye", .format = word_format, .min = "0.0625", .max = "63", .initial = "8", .slices = {{{7, 31, 8}}}},
    Parameter{.key = "REFLECTIONS", .meaning = "reflections of a primary ray", .unit = "", .group = "machine", .format = unsigned_q(2, 0), .min = "0", .max = "3", .initial = "3", .slices = {{{0, 28, 27}}}},
    Parameter{.key = "AA", .meaning = "anti-aliasing: 1, 5 or 9 samples a pixel", .unit = "", .group = "machine", .format = unsigned_q(2, 0), .min = "", .max = "", .initial = "off", .slices = {{{0, 26, 25}}}, .choices = anti_aliasings},
    Parameter{.key = "PLANES", .meaning = "whether the planes are drawn", .unit = "", .group = "machine", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "on", .slices = {{{0, 30, 30}}}, .choices = switches},
    Parameter{.key = "N", .meaning = "how many of the spheres are there, from S1 on", .unit = "", .group = "machine", .format = unsigned_q(4, 0), .min = "1", .max = "14", .initial = "7", .slices = {{{0, 24, 21}}}},
    Parameter{.key = "MOTION", .meaning = "rules of the movement", .unit = "", .group = "motion", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "repaired", .slice_count = 0, .choices = motions},
    Parameter{.key = "XMIN", .meaning = "wall that the spheres bounce off, left", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "-26", .slice_count = 0},
    Parameter{.key = "XMAX", .meaning = "wall that the spheres bounce off, right", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "26", .slice_count = 0},
    Parameter{.key = "YMIN", .meaning = "wall that the spheres bounce off, above", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "-30", .slice_count = 0},
    Parameter{.key = "YMAX", .meaning = "wall that the spheres bounce off, below", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "22", .slice_count = 0},
    Parameter{.key = "ZMIN", .meaning = "wall that the spheres bounce off, before", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "-16", .slice_count = 0},
    Parameter{.key = "ZMAX", .meaning = "wall that the spheres bounce off, behind", .unit = "units", .group = "motion", .format = word_format, .min = "-1024", .max = "1024", .initial = "40", .slice_count = 0},
};

inline constexpr std::uint16_t first_sphere_word = 8;
inline constexpr std::uint16_t words_per_sphere = 4;
inline constexpr std::uint16_t first_plane_word = first_sphere_word + sphere::Keys::rows * words_per_sphere;
inline constexpr std::uint16_t words_per_plane = 6;

/// The row of S1, with an empty key that repeated_rows() fills in.
inline constexpr std::array<Parameter, sphere::Keys::columns> sphere_pattern = {
    Parameter{.meaning = "sphere, centre, x", .unit = "units", .group = "spheres", .format = word_format, .min = "-1024", .max = "1024", .slices = {{{first_sphere_word, 31, 8}}}},
    Parameter{.meaning = "sphere, centre, y", .unit = "units", .group = "spheres", .format = word_format, .min = "-1024", .max = "1024", .slices = {{{first_sphere_word + 1, 31, 8}}}},
    Parameter{.meaning = "sphere, centre, z", .unit = "units", .group = "spheres", .format = word_format, .min = "-1024", .max = "1024", .slices = {{{first_sphere_word + 2, 31, 8}}}},
    Parameter{.meaning = "sphere, radius", .unit = "units", .group = "spheres", .format = radius_format, .min = "1", .max = "2047", .slices = {{{first_sphere_word + 3, 22, 12}}}},
    Parameter{.meaning = "sphere, red", .unit = "", .group = "spheres", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_sphere_word, 4, 0}}}},
    Parameter{.meaning = "sphere, green", .unit = "", .group = "spheres", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_sphere_word + 1, 4, 0}}}},
    Parameter{.meaning = "sphere, blue", .unit = "", .group = "spheres", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_sphere_word + 2, 4, 0}}}},
    Parameter{.meaning = "sphere, share of the light that it reflects", .unit = "", .group = "spheres", .format = share_format, .min = "0", .max = "1", .slices = {{{first_sphere_word + 3, 11, 0}}}},
    Parameter{.meaning = "sphere, velocity, x", .unit = "units a frame", .group = "spheres", .format = velocity_format, .min = "-16", .max = "16", .slice_count = 0},
    Parameter{.meaning = "sphere, velocity, y", .unit = "units a frame", .group = "spheres", .format = velocity_format, .min = "-16", .max = "16", .slice_count = 0},
    Parameter{.meaning = "sphere, velocity, z", .unit = "units a frame", .group = "spheres", .format = velocity_format, .min = "-16", .max = "16", .slice_count = 0},
};

/// The row of P1, with an empty key that repeated_rows() fills in.
inline constexpr std::array<Parameter, plane::Keys::columns> plane_pattern = {
    Parameter{.meaning = "plane, unit normal, x", .unit = "", .group = "planes", .format = normal_format, .min = "-1", .max = "1", .slices = {{{first_plane_word, 31, 8}}}},
    Parameter{.meaning = "plane, unit normal, y", .unit = "", .group = "planes", .format = normal_format, .min = "-1", .max = "1", .slices = {{{first_plane_word + 1, 31, 8}}}},
    Parameter{.meaning = "plane, unit normal, z", .unit = "", .group = "planes", .format = normal_format, .min = "-1", .max = "1", .slices = {{{first_plane_word + 2, 31, 8}}}},
    Parameter{.meaning = "plane, distance: A x + B y + C z + D = 0", .unit = "units", .group = "planes", .format = word_format, .min = "-1024", .max = "1024", .slices = {{{first_plane_word + 3, 31, 8}}}},
    Parameter{.meaning = "plane, red", .unit = "", .group = "planes", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_plane_word, 4, 0}}}},
    Parameter{.meaning = "plane, green", .unit = "", .group = "planes", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_plane_word + 1, 4, 0}}}},
    Parameter{.meaning = "plane, blue", .unit = "", .group = "planes", .format = channel_format, .min = "0", .max = "31", .slices = {{{first_plane_word + 2, 4, 0}}}},
    Parameter{.meaning = "plane, checkerboard: the bits of x and z that tell squares; 1, 2, 4, 8: so many units wide", .unit = "", .group = "planes", .format = unsigned_q(4, 0), .min = "0", .max = "15", .slices = {{{first_plane_word + 3, 3, 0}}}},
    Parameter{.meaning = "plane, whether it ends at its limits", .unit = "", .group = "planes", .format = unsigned_q(1, 0), .min = "", .max = "", .slices = {{{first_plane_word + 3, 4, 4}}}, .choices = switches},
    Parameter{.meaning = "plane, share of the light that it reflects", .unit = "", .group = "planes", .format = share_format, .min = "0", .max = "1", .slices = {{{first_plane_word + 4, 11, 0}}}},
    Parameter{.meaning = "plane, limit of |x|", .unit = "units", .group = "planes", .format = limit_format, .min = "0", .max = "4095", .slices = {{{first_plane_word + 4, 23, 12}}}},
    Parameter{.meaning = "plane, limit of |y|", .unit = "units", .group = "planes", .format = limit_format, .min = "0", .max = "4095", .slices = {{{first_plane_word + 5, 27, 16}}}},
    Parameter{.meaning = "plane, limit of |z|", .unit = "units", .group = "planes", .format = limit_format, .min = "0", .max = "4095", .slices = {{{first_plane_word + 5, 11, 0}}}},
};

template <std::size_t Rows, std::size_t Columns>
using Initials = std::array<std::array<std::string_view, Columns>, Rows>;

/// Image 1 of the report, and seven more within the room.
inline constexpr Initials<sphere::Keys::rows, sphere::Keys::columns> initial_spheres = {{
    //  X     Y       Z       RADIUS R     G      B      REFLECT   VX          VY          VZ
    {{"15",   "0",    "15",   "3",   "31",  "31",  "0",   "0.125",  "-0.3125",  "0.1875",   "-0.375"}},
    {{"0",    "0",    "0",    "3",   "0",   "0",   "31",  "0.125",  "0.125",    "-0.3125",  "-0.5"}},
    {{"-15",  "0",    "15",   "3",   "31",  "31",  "0",   "0.125",  "0.3125",   "0.3125",   "-0.1875"}},
    {{"0",    "15",   "15",   "3",   "31",  "0",   "0",   "0.125",  "-0.375",   "0.1875",   "-0.3125"}},
    {{"0",    "-15",  "15",   "3",   "31",  "0",   "0",   "0.125",  "0.375",    "-0.125",   "-0.1875"}},
    {{"0",    "0",    "30",   "3",   "0",   "0",   "31",  "0.125",  "0.5",      "0.1875",   "0.125"}},
    {{"0",    "0",    "15",   "15",  "0",   "31",  "0",   "0.25",   "0.125",    "0.0625",   "0"}},
    {{"-12",  "-12",  "5",    "3",   "0",   "31",  "31",  "0.5",    "-0.1875",  "-0.3125",  "0.125"}},
    {{"12",   "-12",  "5",    "3",   "31",  "0",   "31",  "0.5",    "0.1875",   "-0.375",   "0.1875"}},
    {{"-12",  "12",   "5",    "3",   "31",  "16",  "0",   "0.5",    "-0.3125",  "0.125",    "-0.1875"}},
    {{"12",   "12",   "5",    "3",   "16",  "0",   "31",  "0.5",    "0.125",    "0.3125",   "-0.375"}},
    {{"-20",  "18",   "-5",   "4",   "24",  "24",  "24",  "0.75",   "0.3125",   "-0.1875",  "0.1875"}},
    {{"20",   "18",   "-5",   "4",   "24",  "24",  "24",  "0.75",   "-0.1875",  "-0.3125",  "0.3125"}},
    {{"0",    "18",   "-10",  "3",   "31",  "8",   "16",  "0.25",   "0.1875",   "-0.5",     "0.125"}},
}};

/// The report's room: behind, floor, right, left.
inline constexpr Initials<plane::Keys::rows, plane::Keys::columns> initial_planes = {{
    //  A     B     C     D     RED   GREEN BLUE  CHECKER BOUNDED REFLECT XL  YL   ZL
    {{"0",  "0",  "-1", "40", "0",  "0",  "0",  "0", "off", "0.5", "0", "0", "0"}},
    {{"0",  "-1", "0",  "22", "29", "29", "29", "1", "off", "0.5", "0", "0", "0"}},
    {{"-1", "0",  "0",  "26", "0",  "0",  "0",  "0", "off", "0.5", "0", "0", "0"}},
    {{"1",  "0",  "0",  "26", "0",  "0",  "0",  "0", "off", "0.5", "0", "0", "0"}},
}};
// clang-format on

/// Gives each row of `pattern` its own default.
template <typename Keys>
constexpr auto rows_with(const std::array<Parameter, Keys::columns>& pattern,
                         std::uint16_t words_per_row,
                         const Initials<Keys::rows, Keys::columns>& initials)
{
    auto rows = repeated_rows<Keys>(pattern, words_per_row);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].initial = initials[i / Keys::columns][i % Keys::columns];
    return rows;
}

inline constexpr auto parameters = complete(joined(
    single_values, rows_with<sphere::Keys>(sphere_pattern, words_per_sphere, initial_spheres),
    rows_with<plane::Keys>(plane_pattern, words_per_plane, initial_planes)));
static_assert(parameters.size() <= 250 && single_values.size() == first_sphere);
static_assert(parameters[index_of(sphere::VZ, 13)].key == "S14.VZ");
static_assert(parameters[index_of(plane::ZL, 3)].key == "P4.ZL");

/// The report's second scene; the walls that it moves in are wider.
inline constexpr std::string_view image2 =
    "N=13,LR=2,AA=8x,XMIN=-40,XMAX=40,YMIN=-40,YMAX=40,ZMAX=40,"
    "S1.X=0,S1.Y=0,S1.Z=5,S1.RADIUS=3,S1.R=12,S1.G=31,S1.B=20,S1.REFLECT=0.25,"
    "S2.X=15,S2.Y=0,S2.Z=5,S2.RADIUS=3,S2.R=27,S2.G=27,S2.B=27,S2.REFLECT=0.25,"
    "S3.X=0,S3.Y=15,S3.Z=5,S3.RADIUS=3,S3.R=0,S3.G=31,S3.B=31,S3.REFLECT=0.25,"
    "S4.X=15,S4.Y=15,S4.Z=5,S4.RADIUS=3,S4.R=31,S4.G=31,S4.B=0,S4.REFLECT=0.25,"
    "S5.X=0,S5.Y=21,S5.Z=21,S5.RADIUS=15,S5.R=0,S5.G=31,S5.B=0,S5.REFLECT=0.5,"
    "S6.X=21,S6.Y=0,S6.Z=21,S6.RADIUS=15,S6.R=31,S6.G=0,S6.B=0,S6.REFLECT=0.5,"
    "S7.X=-15,S7.Y=-15,S7.Z=5,S7.RADIUS=3,S7.R=0,S7.G=0,S7.B=31,S7.REFLECT=0.25,"
    "S8.X=-15,S8.Y=0,S8.Z=5,S8.RADIUS=3,S8.R=15,S8.G=15,S8.B=31,S8.REFLECT=0.25,"
    "S9.X=15,S9.Y=-15,S9.Z=5,S9.RADIUS=3,S9.R=21,S9.G=31,S9.B=31,S9.REFLECT=0.25,"
    "S10.X=0,S10.Y=-15,S10.Z=5,S10.RADIUS=3,S10.R=15,S10.G=15,S10.B=15,S10.REFLECT=0.25,"
    "S11.X=-15,S11.Y=15,S11.Z=5,S11.RADIUS=3,S11.R=15,S11.G=12,S11.B=12,S11.REFLECT=0.25,"
    "S12.X=-21,S12.Y=0,S12.Z=21,S12.RADIUS=15,S12.R=15,S12.G=15,S12.B=0,S12.REFLECT=0.5,"
    "S13.X=0,S13.Y=-21,S13.Z=21,S13.RADIUS=15,S13.R=15,S13.G=3,S13.B=12,S13.REFLECT=0.5";
inline constexpr std::string_view without_planes = ",PLANES=off";

/// Joins several texts.
template <const std::string_view&... Parts>
inline constexpr auto joined_text = [] {
    std::array<char, (Parts.size() + ...)> text{};
    auto at = text.begin();
    ((at = std::copy(Parts.begin(), Parts.end(), at)), ...);
    return text;
}();
template <const std::string_view&... Parts>
[[nodiscard]] consteval std::string_view text_of()
{
    return {joined_text<Parts...>.data(), joined_text<Parts...>.size()};
}

// clang-format off
// One row a preset, one line a sphere or plane.
inline constexpr std::array presets = {
    Preset{"image1", "the report's first scene: a green sphere with small ones in it",
           "LR=3,AA=8x,PLANES=off"},
    Preset{"image1_room", "the first scene in the room: mirrors at three sides, a checkered floor",
           "LR=3,AA=8x"},
    Preset{"image2", "the report's second scene: thirteen spheres, three reflections",
           text_of<image2, without_planes>()},
    Preset{"image2_room", "the second scene in the room",
           image2},
    Preset{"fourteen", "all fourteen spheres in the room",
           "N=14,AA=8x,LX=4,LY=-18,LZ=-14,"
           "P2.CHECKER=2"},
    Preset{"plate", "three mirrors on a checkered plate in the dusk",
           "N=5,AA=8x,EX=4,EY=-10,EZ=-32,S=8,LX=-14,LY=-14,LZ=-12,"
           "XMIN=-16,XMAX=16,YMIN=-16,YMAX=8,ZMIN=-16,ZMAX=16,"
           "S1.X=0,S1.Y=-2,S1.Z=4,S1.RADIUS=10,S1.R=12,S1.G=12,S1.B=14,S1.REFLECT=0.75,"
           "S2.X=-10,S2.Y=3,S2.Z=-6,S2.RADIUS=5,S2.R=20,S2.G=4,S2.B=4,S2.REFLECT=0.625,"
           "S3.X=10,S3.Y=3,S3.Z=-6,S3.RADIUS=5,S3.R=4,S3.G=6,S3.B=20,S3.REFLECT=0.625,"
           "S4.X=0,S4.Y=6,S4.Z=-10,S4.RADIUS=2,S4.R=31,S4.G=28,S4.B=0,S4.REFLECT=0.25,"
           "S5.X=4,S5.Y=6,S5.Z=-13,S5.RADIUS=2,S5.R=0,S5.G=24,S5.B=8,S5.REFLECT=0.25,"
           "P1.A=0,P1.B=0,P1.C=-1,P1.D=120,P1.RED=4,P1.GREEN=3,P1.BLUE=8,P1.CHECKER=0,P1.REFLECT=0,"
           "P2.A=0,P2.B=-1,P2.C=0,P2.D=8,P2.RED=30,P2.GREEN=28,P2.BLUE=24,P2.CHECKER=4,P2.REFLECT=0.25,"
           "P2.BOUNDED=on,P2.XL=20,P2.YL=64,P2.ZL=20,"
           "P3.A=0,P3.B=0,P3.C=-1,P3.D=130,P3.RED=0,P3.GREEN=0,P3.BLUE=0,P3.CHECKER=0,P3.REFLECT=0,"
           "P4.A=0,P4.B=0,P4.C=-1,P4.D=130,P4.RED=0,P4.GREEN=0,P4.BLUE=0,P4.CHECKER=0,P4.REFLECT=0"},
    Preset{"mirrors", "between two mirrors: red and blue rows without an end",
           "N=4,AA=8x,EX=-8,EY=-4,LX=0,LY=-26,LZ=0,"
           "S1.X=-6,S1.Y=17,S1.Z=14,S1.RADIUS=5,S1.R=28,S1.G=4,S1.B=4,S1.REFLECT=0.25,"
           "S2.X=8,S2.Y=17,S2.Z=20,S2.RADIUS=5,S2.R=4,S2.G=8,S2.B=28,S2.REFLECT=0.25,"
           "S3.X=0,S3.Y=6,S3.Z=30,S3.RADIUS=6,S3.R=12,S3.G=12,S3.B=12,S3.REFLECT=0.75,"
           "S4.X=12,S4.Y=19,S4.Z=2,S4.RADIUS=3,S4.R=28,S4.G=24,S4.B=2,S4.REFLECT=0.125,"
           "P2.CHECKER=8,P2.RED=24,P2.GREEN=20,P2.BLUE=16,P2.REFLECT=0.125,"
           "P3.RED=1,P3.GREEN=2,P3.BLUE=2,P3.REFLECT=0.875,"
           "P4.RED=1,P4.GREEN=2,P4.BLUE=2,P4.REFLECT=0.875,"
           "P1.RED=3,P1.GREEN=4,P1.BLUE=8,P1.REFLECT=0.25"},
    Preset{"telescope", "the small blue sphere through a long lens: the set-up's 4096ths show",
           "S=24,LR=3,LX=6,LY=-14,LZ=-16,AA=8x"},
    Preset{"wide", "the room through a wide lens",
           "N=14,S=2,AA=8x,EZ=-20,LX=4,LY=-18,LZ=-14"},
    Preset{"measured", "the first scene in the room as the original machine draws it, with its defects",
           "PROFILE=measured,LR=3"},
    Preset{"best_case", "the first scene with everything switched off: what is fastest, made for 320x240",
           "LR=3,REFLECTIONS=0,PLANES=off"},
};
// clang-format on

inline constexpr Accelerator description = {
    .name = "whitted",
    .summary = "spheres and planes with shadows, reflections and anti-aliasing in 12.12 "
               "(source 004)",
    .kind = 4,
    .first_word_offset = 0x100,
    .word_count = first_plane_word + plane::Keys::rows * words_per_plane,
    .size = {512, 480},
    .max_size = {1280, 960},
    .ray_units = 1,
    .clock_hz = 25'000'000,
    .parameters = parameters,
    .keys = KeyIndex(parameters),
    .pack = pack_table<parameters>,
    .frame = frame_of(parameters),
    .presets = presets,
    .camera = std::nullopt,
    .colour = std::nullopt,
    .scene = std::nullopt,
};

} // namespace raymarch::protocol::whitted
