// SPDX-License-Identifier: MIT
/// @file
/// The words in the pipeline's own numbers; they are latched once a frame.
#pragma once

#include "engine/whitted/formats.hpp"
#include "engine/whitted/profile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace raymarch::engine::whitted
{

inline constexpr std::size_t max_spheres = 15; ///< with the light
inline constexpr std::size_t plane_count = 4;

/// One entry of the sphere table, with what the host computes beforehand.
struct Sphere
{
    Vector centre;
    Colour colour;       ///< multiples of 32
    Weight reflect = 0;  ///< the share of the light that it reflects
    Wide radius;         ///< an integer
    Wide squared_radius; ///< an integer
    Word inverse_radius; ///< floored
};

/// A sphere of an integer radius, 1 to 2047; colours are of 5 bits.
[[nodiscard]] Sphere make_sphere(const Vector& centre, std::uint16_t radius,
                                 const std::array<std::uint8_t, 3>& colour,
                                 Weight reflect) noexcept;

/// One entry of the plane table: all p with normal . p + offset = 0, seen from where the sum is
/// positive.
struct Plane
{
    Vector normal;            ///< (A, B, C), a unit vector
    Word offset;              ///< D
    Colour colour;            ///< multiples of 32
    std::uint8_t checker = 0; ///< squares differ in these bits of int(x) and int(z); 0: no squares
    bool bounded = false;
    Weight reflect = 0;
    std::array<std::uint16_t, 3> limits{}; ///< integers, below 4096; only where bounded
};

/// Channels of 5 bits, 31 of which is 992.
[[nodiscard]] Colour ray_colour(const std::array<std::uint8_t, 3>& five_bits) noexcept;

enum class AntiAliasing : std::uint8_t { Off, Four, Eight };

/// The state of one frame.
struct Frame
{
    Defects defects{Profile::Repaired};
    Vector eye;
    Vector light;
    Word screen;                  ///< the distance S from the eye's side, in units of 32
    std::uint8_t reflections = 0; ///< 0 to 3 after the primary ray
    AntiAliasing anti_aliasing = AntiAliasing::Off;
    bool planes_drawn = false;
    std::uint8_t last = 0; ///< the index of the light, which is the last of the spheres
    std::array<Sphere, max_spheres> spheres;
    std::array<Plane, plane_count> planes;
};

/// The light as a sphere: white, without reflection. The hardware makes it, whatever was sent.
[[nodiscard]] Sphere make_light(const Vector& centre, std::uint16_t radius) noexcept;

/// Unpacks the words. Those that no frame can set count as what is nearest to them: no sphere or
/// 15 of them as 1 or 14, a radius of 0 as 1, both anti-aliasing bits as 8x.
[[nodiscard]] Frame latch(std::span<const std::uint32_t> words) noexcept;

} // namespace raymarch::engine::whitted
