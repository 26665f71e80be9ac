// SPDX-License-Identifier: MIT
/// @file
/// Colours to the picture's bytes.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_PIXELS) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_PIXELS
#undef RAYMARCH_ENGINE_MARCHER_FAST_PIXELS
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_PIXELS
#endif

#include "engine/image.hpp"
#include "engine/marcher/fast/lanes-inl.hpp"
#include "engine/model.hpp"

#include <algorithm>
#include <array>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// A colour is red, green and blue from the lowest byte on.
constexpr std::size_t colour_bytes = sizeof(std::uint32_t);

/// Packs colours to three bytes each.
inline void pack(const std::uint32_t* colours, std::size_t count, std::uint8_t* to) noexcept
{
    const hn::FixedTag<std::uint8_t, 16> bytes;
    constexpr std::size_t at_once = 4;
    alignas(16) constexpr std::array<std::uint8_t, 16> packed = {
        0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 0x80, 0x80, 0x80, 0x80};
    const auto order = hn::Load(bytes, packed.data());
    // 16 bytes are stored, of which the last four are the next pixels': two more must be there.
    for (; count >= at_once + 2; count -= at_once, colours += at_once) {
        const auto four = hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(colours));
        hn::StoreU(hn::TableLookupBytesOr0(four, order), bytes, to);
        to += bytes_per_pixel * at_once;
    }
    for (; count > 0; --count, ++colours, to += bytes_per_pixel)
        for (std::size_t i = 0; i < bytes_per_pixel; ++i)
            to[i] = static_cast<std::uint8_t>(*colours >> (8 * i));
}

/// Writes pixels that are `step` apart.
class PixelWriter
{
  public:
    PixelWriter(const Canvas& canvas, std::size_t step) : canvas_(canvas), step_(step) {}

    void colours(std::size_t pixel, std::size_t count, const std::uint32_t* colours) const noexcept
    {
        std::uint8_t* const to = canvas_.rgb.data() + bytes_per_pixel * pixel;
        if (step_ == 1)
            return pack(colours, count, to);
        for (std::size_t i = 0; i < count; ++i)
            pack(colours + i, 1, to + bytes_per_pixel * step_ * i);
    }

    void fill(std::size_t pixel, std::size_t count, std::uint32_t colour) const noexcept
    {
        if (step_ == 1 && colour == 0) {
            std::memset(canvas_.rgb.data() + bytes_per_pixel * pixel, 0, bytes_per_pixel * count);
            return;
        }
        std::array<std::uint32_t, 64> same;
        same.fill(colour);
        for (std::size_t i = 0; i < count; i += same.size())
            colours(pixel + step_ * i, std::min(same.size(), count - i), same.data());
    }

    void cost(std::size_t pixel, std::int32_t queries) const noexcept
    {
        canvas_.costs[pixel] = {.steps = static_cast<std::uint32_t>(queries), .rays = 1};
    }

  private:
    const Canvas& canvas_;
    std::size_t step_;
};

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
