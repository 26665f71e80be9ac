// SPDX-License-Identifier: MIT
#include "engine/whitted/ray_setup.hpp"

#include "engine/whitted/arithmetic.hpp"

namespace raymarch::engine::whitted
{
namespace
{

constexpr std::array<SamplePlace, 1> single = {{{0, 0, 0}}};
constexpr std::array<SamplePlace, 5> four = {
    {{0, 0, 1}, {-1, -1, 3}, {-1, 1, 3}, {1, -1, 3}, {1, 1, 3}}};
constexpr std::array<SamplePlace, 9> eight = {{{0, 0, 2},
                                               {-1, -1, 4},
                                               {-1, 1, 4},
                                               {1, -1, 4},
                                               {1, 1, 4},
                                               {-1, 0, 3},
                                               {0, 1, 3},
                                               {0, -1, 3},
                                               {1, 0, 3}}};

enum class Shift : bool { Signed, Unsigned };

/// A 24-bit word divided by 32, with the sign kept or lost.
int scaled(int raw, Shift shift) noexcept
{
    constexpr int word_mask = (1 << Word::width) - 1;
    return (shift == Shift::Unsigned ? raw & word_mask : raw) >> screen_shift;
}

/// One axis of the screen: pixels from its middle, minus the eye, in units of 32.
Word across(unsigned pixel, int half_pixels, unsigned pixels, Word eye, Shift shift) noexcept
{
    constexpr int half_pixel = 1 << (fraction_bits - 1);
    constexpr int half_of_one = half_pixel >> screen_shift;
    const int at = static_cast<int>(pixel) * 2 * half_pixel + half_pixels * half_pixel;
    const int middle = static_cast<int>(pixels) * half_of_one;
    return Word::from_raw(scaled(at, shift) - middle - scaled(eye.raw(), Shift::Signed));
}

} // namespace

std::span<const SamplePlace> sample_places(AntiAliasing anti_aliasing) noexcept
{
    switch (anti_aliasing) {
    case AntiAliasing::Off:
        return single;
    case AntiAliasing::Four:
        return four;
    case AntiAliasing::Eight:
        return eight;
    }
    return single;
}

Vector screen_point(const Frame& frame, PictureSize size, unsigned x, unsigned y,
                    const SamplePlace& place) noexcept
{
    const auto shift_with = [&](Defect defect) {
        return frame.defects.has(defect) ? Shift::Unsigned : Shift::Signed;
    };
    const Shift shift = shift_with(Defect::UnsignedPixel);
    const Word dx = across(x, place.dx, size.width, frame.eye.x, shift);
    const Word dy = across(y, place.dy, size.height, frame.eye.y, shift);
    // R7: the unsigned eye comes with a screen 128 further away, which is right for z < 0 alone.
    const Shift depth = shift_with(Defect::UnsignedEye);
    const int offset = depth == Shift::Unsigned ? 1 << (Word::width - screen_shift) : 0;
    const Word dz = Word::from_raw(frame.screen.raw() + offset - scaled(frame.eye.z.raw(), depth));
    return {dx, dy, dz};
}

Vector primary_direction(const Frame& frame, PictureSize size, unsigned x, unsigned y,
                         const SamplePlace& place) noexcept
{
    return normalise(screen_point(frame, size, x, y, place));
}

} // namespace raymarch::engine::whitted
