// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the deep-zoom Mandelbulb of source 003 (Klein and Koch, Heidelberg): ray marching by 3D
/// CORDIC. Numbers of steps, of bits and of iterations are what its hardware is built with.
#pragma once

#include "protocol/packer.hpp"
#include "protocol/parameter_table.hpp"

namespace raymarch::protocol::mandelbulb
{

inline constexpr Format position_format = signed_q(8, 64);
inline constexpr Format direction_format = signed_q(2, 57);

inline constexpr std::array<std::string_view, 2> forms = {"q8_57", "q8_64"};
inline constexpr std::array<std::string_view, 2> derivatives = {"sliding", "q33_32"};
inline constexpr std::array<std::string_view, 2> colours = {"steps", "index"};
inline constexpr std::array<std::string_view, 2> aspects = {"natural", "square"};

/// Indices into the table below; a position's lower 32 bits stand behind it.
enum Index : ParameterIndex {
    X,
    X_TAIL,
    Y,
    Y_TAIL,
    Z,
    Z_TAIL,
    FX,
    FY,
    FZ,
    RX,
    RY,
    RZ,
    UX,
    UY,
    UZ,
    N,
    K,
    POWER,
    I,
    B,
    STEPS,
    FORM,
    DERIVATIVE,
    SCALE,
    COLOUR,
    ASPECT
};

namespace detail
{

inline constexpr std::uint16_t integer_word = 2; ///< integer bits of the three positions
inline constexpr std::uint16_t fraction_word = 3;
inline constexpr std::uint16_t direction_word = 9;

consteval Parameter position(std::uint8_t axis, std::string_view key, std::string_view meaning,
                             std::string_view initial)
{
    const auto lsb = static_cast<std::uint8_t>(8 * axis);
    const auto fraction = static_cast<std::uint16_t>(fraction_word + 2 * axis);
    return {
        .key = key,
        .meaning = meaning,
        .unit = "units",
        .group = "camera",
        .format = position_format,
        .min = "-4",
        .max = "4",
        .initial = initial,
        .slices = {{{integer_word, static_cast<std::uint8_t>(lsb + 7), lsb}, {fraction, 31, 0}}},
        .slice_count = 2,
        .tail_bits = 32};
}

consteval Parameter tail(std::uint8_t axis, const Parameter& upper)
{
    return tail_of(upper, {{{static_cast<std::uint16_t>(fraction_word + 2 * axis + 1), 31, 0}}}, 1);
}

consteval Parameter direction(std::uint8_t number, std::string_view key, std::string_view meaning,
                              std::string_view initial)
{
    const auto word = static_cast<std::uint16_t>(direction_word + 2 * number);
    return {.key = key,
            .meaning = meaning,
            .unit = "",
            .group = "camera",
            .format = direction_format,
            .min = "-1",
            .max = "1",
            .initial = initial,
            .slices = {{{word, 26, 0}, {static_cast<std::uint16_t>(word + 1), 31, 0}}},
            .slice_count = 2};
}

inline constexpr Parameter x = position(0, "X", "camera position, x", "0");
inline constexpr Parameter y = position(1, "Y", "camera position, y", "-2.5");
inline constexpr Parameter z = position(2, "Z", "camera position, z", "0");

} // namespace detail

// Laid out by hand: one row a parameter.
// clang-format off
inline constexpr auto parameters = complete(std::array{
    detail::x, detail::tail(0, detail::x),
    detail::y, detail::tail(1, detail::y),
    detail::z, detail::tail(2, detail::z),
    detail::direction(0, "FX", "camera basis, forwards, x", "0"),
    detail::direction(1, "FY", "camera basis, forwards, y", "1"),
    detail::direction(2, "FZ", "camera basis, forwards, z", "0"),
    detail::direction(3, "RX", "camera basis, to the right, x", "1"),
    detail::direction(4, "RY", "camera basis, to the right, y", "0"),
    detail::direction(5, "RZ", "camera basis, to the right, z", "0"),
    detail::direction(6, "UX", "camera basis, upwards, x", "0"),
    detail::direction(7, "UY", "camera basis, upwards, y", "0"),
    detail::direction(8, "UZ", "camera basis, upwards, z", "1"),
    Parameter{.key = "N", .meaning = "steps of CORDIC, BKM and division", .unit = "steps", .group = "arithmetic", .format = unsigned_q(7, 0), .min = "8", .max = "64", .initial = "32", .slices = {{{0, 14, 8}}}},
    Parameter{.key = "K", .meaning = "bits of the approximate multiplier; 0: N + 4, 17 at least", .unit = "bits", .group = "arithmetic", .format = unsigned_q(7, 0), .min = "0", .max = "64", .initial = "0", .slices = {{{0, 22, 16}}}},
    Parameter{.key = "POWER", .meaning = "power of the Mandelbulb", .unit = "", .group = "object", .format = unsigned_q(5, 0), .min = "2", .max = "16", .initial = "8", .slices = {{{0, 28, 24}}}},
    Parameter{.key = "I", .meaning = "iterations of a point", .unit = "iterations", .group = "object", .format = unsigned_q(7, 0), .min = "1", .max = "64", .initial = "25", .slices = {{{1, 6, 0}}}},
    Parameter{.key = "B", .meaning = "a ray ends at 2^-B of its first distance", .unit = "bits", .group = "march", .format = unsigned_q(5, 0), .min = "4", .max = "16", .initial = "12", .slices = {{{1, 12, 8}}}},
    Parameter{.key = "STEPS", .meaning = "the most evaluations of a ray", .unit = "evaluations", .group = "march", .format = unsigned_q(8, 0), .min = "1", .max = "200", .initial = "200", .slices = {{{1, 23, 16}}}},
    Parameter{.key = "FORM", .meaning = "format of a coordinate", .unit = "", .group = "arithmetic", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "q8_57", .slices = {{{0, 0, 0}}}, .choices = forms},
    Parameter{.key = "DERIVATIVE", .meaning = "format of the derivative", .unit = "", .group = "arithmetic", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "sliding", .slices = {{{0, 1, 1}}}, .choices = derivatives},
    Parameter{.key = "SCALE", .meaning = "fraction bits of a distance beyond those of a coordinate, for zoom beyond 44", .unit = "bits", .group = "march", .format = unsigned_q(6, 0), .min = "0", .max = "60", .initial = "0", .slices = {{{1, 29, 24}}}},
    Parameter{.key = "COLOUR", .meaning = "colours by evaluations of the ray or by index of the last iteration", .unit = "", .group = "colour", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "steps", .slices = {{{0, 2, 2}}}, .choices = colours},
    Parameter{.key = "ASPECT", .meaning = "square: the picture is stretched to its size", .unit = "", .group = "camera", .format = unsigned_q(1, 0), .min = "", .max = "", .initial = "natural", .slices = {{{0, 3, 3}}}, .choices = aspects},
});

inline constexpr std::array presets = {
    Preset{"front", "the whole Mandelbulb from the front", "COLOUR=steps"},
    Preset{"whole", "the whole from above a corner: the view that the zooms start from", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638"},
    Preset{"whole_index", "the same, coloured by the index of the last iteration", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,COLOUR=index"},
    Preset{"a_z12", "zoom level 12 at target A", "X=0.53742372989654541016,Y=-0.52350127696990966797,Z=0.60108101367950439453,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985"},
    Preset{"a_z21", "level 21, near the end of single precision", "X=0.39703845977783203125,Y=-0.42289328575134277344,Z=0.57028365135192871094,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985"},
    Preset{"a_z23", "level 23: the last bit of single precision", "X=0.39683234691619873047,Y=-0.42274570465087890625,Z=0.57023847103118896484,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985"},
    Preset{"a_z26", "level 26: clean with 32 steps, blocks in single precision", "X=0.3967722654342651367,Y=-0.42270255088806152344,Z=0.5702252388000488281,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985"},
    Preset{"a_z29", "level 29: the deepest that the source reports", "X=0.39676477227296746975,Y=-0.42269720151712797396,Z=0.57022363469271075687,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985"},
    Preset{"a_z47", "level 47 with 48 steps and 40 iterations", "X=0.3967636991264775759,Y=-0.4226964324400765971,Z=0.5702233992682461672,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985,N=48,I=40"},
    Preset{"a_z50", "level 50 with 57 steps: where double precision shows grain", "X=0.3967636991228955523,Y=-0.4226964324375095394,Z=0.5702233992674603513,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985,N=57,I=40,SCALE=38"},
    Preset{"a_z52", "level 52", "X=0.39676369912251185923,Y=-0.42269643243723442616,Z=0.5702233992673761964,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985,N=57,I=40,SCALE=40"},
    Preset{"a_z54", "level 54: double precision is broken", "X=0.39676369912241593596,Y=-0.4226964324371658144,Z=0.5702233992673551022,FX=-0.800199072848166715,FY=0.57346760149188536,FZ=-0.17554587392496196,RX=0.582513303753025236,RY=0.81282116787811076,UX=-0.14268740225987117,UY=0.102257806980241645,UZ=0.98447125206778985,N=57,I=40,SCALE=42"},
    Preset{"deep12", "level 12 at target B: a symmetrical valley", "X=0.5253443717956542969,Y=-0.26124727725982666016,Z=0.7342517375946044922,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622"},
    Preset{"deep21", "level 21 at target B", "X=0.3955358266830444336,Y=-0.1442719697952270508,Z=0.71860015392303466797,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622"},
    Preset{"deep26", "level 26 at target B: what 32 steps are for", "X=0.3952896595001220703,Y=-0.14405024051666259766,Z=0.71857047080993652344,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622"},
    Preset{"deep30", "level 30: the end of 32 steps", "X=0.39528226131365173934,Y=-0.14404356132281326275,Z=0.7185695752757139676,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622"},
    Preset{"deep46", "level 46: the end of 48 steps", "X=0.3952817651716622471,Y=-0.1440431142310381052,Z=0.71856951545369573964,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,N=48,I=40,SCALE=34"},
    Preset{"deep54", "level 54: the end of Q8.57, with a frame scale", "X=0.39528176516412116825,Y=-0.14404311422424243005,Z=0.718569515452786467,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,N=57,I=40,SCALE=42"},
    Preset{"deep56", "level 56 in Q8.64", "X=0.39528176516409904636,Y=-0.1440431142242224896,Z=0.71856951545278387595,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,N=64,I=40,FORM=q8_64,SCALE=44"},
    Preset{"deep58", "level 58 in Q8.64, beyond double precision", "X=0.3952817651640935015,Y=-0.1440431142242174929,Z=0.7185695154527832074,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,N=64,I=40,FORM=q8_64,SCALE=46"},
    Preset{"power2", "power 2", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=2"},
    Preset{"power3", "power 3", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=3"},
    Preset{"power4", "power 4", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=4"},
    Preset{"power5", "power 5", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=5"},
    Preset{"power6", "power 6", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=6"},
    Preset{"power12", "power 12", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=12"},
    Preset{"power16", "power 16", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,POWER=16"},
    Preset{"small_board", "9 steps and a stretched picture, as on the smaller of the two boards", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,N=9,ASPECT=square"},
    Preset{"small_board_zoom", "9 steps at level 10: the pixels of which the source speaks", "X=0.95940363407135009766,Y=-0.8259158134460449219,Z=0.69365406036376953125,FX=-0.80019907284816666,FY=0.57346760149188538,FZ=-0.175545873924961945,RX=0.58478196056017273,RY=0.811028809971753084,RZ=-0.01619654281637738,UX=-0.13308456866344473,UY=0.115616518867098964,UZ=0.984338010110713424,N=9"},
    Preset{"sixteen_steps", "16 steps at level 16, two levels too deep for them", "X=0.4034106731414794922,Y=-0.1513683795928955078,Z=0.7195496559143066406,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,N=16"},
    Preset{"short_rays", "rays that stop far out: the colours of the source's Fig. 11c", "X=1.8999999999999999112,Y=-1.5,Z=0.9000000000000000222,FX=-0.73568293802924789,FY=0.58080231949677463,FZ=-0.3484813916980648,RX=0.61964428857902076,RY=0.784882765533426285,UX=-0.27351703845291431,UY=0.215934504041774444,UZ=0.93731569902577638,B=6,STEPS=40"},
    Preset{"short_rays_zoom", "the valley of deep12 under short rays", "X=0.5253443717956542969,Y=-0.26124727725982666016,Z=0.7342517375946044922,FX=-0.73991185231710799,FY=0.66676175498458539,FZ=-0.089214420866482784,RX=0.66768760052328946,RY=0.74407306365668169,RZ=0.02342101722837966,UX=-0.08199828600719908,UY=0.0422378743598155,UZ=0.99573703509583622,B=5"},
};
// clang-format on

inline constexpr Accelerator description = {
    .name = "mandelbulb",
    .summary = "deep-zoom Mandelbulb by 3D CORDIC and BKM (source 003)",
    .kind = 3,
    .first_word_offset = 0x100,
    .word_count = 27,
    .size = {1280, 720},
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

} // namespace raymarch::protocol::mandelbulb
