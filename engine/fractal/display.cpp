// SPDX-License-Identifier: MIT
#include "engine/fractal/display.hpp"

namespace raymarch::engine::fractal
{
namespace
{

constexpr unsigned saturation = 165;

/// The four bits that reach the pins, as a byte.
std::uint8_t channel(unsigned sum) noexcept
{
    return static_cast<std::uint8_t>((sum & 0xFF) / 16 * 17);
}

/// Hue, saturation and lightness, all in 256ths, to red, green and blue.
Rgb colour_of(unsigned lightness, std::uint8_t hue, unsigned strength) noexcept
{
    const unsigned above = lightness + 1;
    const unsigned chroma = (above < 128 ? 2 * above : 512 - 2 * above) * strength / 256;
    const unsigned least = lightness - chroma / 2; // modulo 256 in channel()

    const unsigned turn = 6U * hue;
    const unsigned sextant = turn / 256 % 4; // two bits: the last two sextants repeat the first
    const unsigned within = turn % 256 + 1;
    const unsigned ramp = (turn / 256 % 2 == 0 ? within : 256 - within) * chroma / 256;

    // The sextants add this to blue, green and red: the hardware has red and blue exchanged.
    const unsigned blue = sextant == 0 ? chroma : 0;
    const unsigned green = sextant == 1 ? chroma : sextant == 2 ? ramp : 0;
    const unsigned red = sextant == 3 ? chroma : ramp;
    return {channel(red + least), channel(green + least), channel(blue + least)};
}

} // namespace

Palette palette(Colouring colouring, std::uint8_t hue) noexcept
{
    Palette colours{};
    for (unsigned grey = 0; grey < colours.size(); ++grey)
        colours[grey] = colour_of(16 * grey, hue, colouring == Colouring::Hue ? saturation : 0);
    return colours;
}

} // namespace raymarch::engine::fractal
