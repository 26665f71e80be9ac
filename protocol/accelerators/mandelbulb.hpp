// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the deep-zoom Mandelbulb of source 003 (Klein and Koch, Heidelberg): ray marching by 3D
/// CORDIC. Numbers of steps, of bits and of iterations are what its hardware is built with.
#pragma once

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

inline constexpr auto fields = fields_of(parameters);

inline constexpr std::array presets = {
    Preset{"front", "the whole Mandelbulb from the front", ""},
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
    .fields = fields.span(),
    .frame = frame_of(parameters),
    .presets = presets,
    .camera = std::nullopt,
    .colour = std::nullopt,
};

} // namespace raymarch::protocol::mandelbulb
