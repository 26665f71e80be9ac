// SPDX-License-Identifier: MIT
#include "pictures/area_scale.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace raymarch::pictures
{
namespace
{

using engine::bytes_per_pixel;
using engine::Image;

/// What one new pixel covers along one side, in units of which an old pixel has `to` and a new one
/// `from`: so both have whole lengths.
struct Cover
{
    std::uint64_t begin;
    std::uint64_t end;
    std::uint64_t unit; ///< length of an old pixel

    Cover(std::size_t pixel, std::size_t from, std::size_t to)
        : begin(std::uint64_t{pixel} * from)
        , end(begin + from)
        , unit(to)
    {}

    [[nodiscard]] std::size_t first() const { return static_cast<std::size_t>(begin / unit); }
    [[nodiscard]] std::size_t last() const { return static_cast<std::size_t>((end - 1) / unit); }
    [[nodiscard]] std::uint64_t weight(std::size_t old) const
    {
        return std::min(end, (old + 1) * unit) - std::max(begin, old * unit);
    }
};

/// Adds a row of the picture to the sums of a new row, `weight` times.
void add_row(const std::uint8_t* row, std::size_t from, std::uint64_t weight,
             std::vector<std::uint64_t>& sums)
{
    const std::size_t to = sums.size() / bytes_per_pixel;
    for (std::size_t x = 0; x < to; ++x) {
        const Cover cover(x, from, to);
        for (std::size_t old = cover.first(); old <= cover.last(); ++old)
            for (std::size_t c = 0; c < bytes_per_pixel; ++c)
                sums[x * bytes_per_pixel + c] +=
                    weight * cover.weight(old) * row[old * bytes_per_pixel + c];
    }
}

} // namespace

Image area_scaled(const Image& image, engine::PictureSize size)
{
    const engine::PictureSize old = image.size;
    assert(old.width > 0 && old.height > 0 && size.width > 0 && size.height > 0);
    // The area of a new pixel; a sum has at most 2^32 times 255 of it.
    const std::uint64_t area = std::uint64_t{old.width} * old.height;
    Image result(size);
    for (std::size_t y = 0; y < size.height; ++y) {
        std::vector<std::uint64_t> sums(bytes_per_pixel * size.width);
        const Cover cover(y, old.height, size.height);
        for (std::size_t row = cover.first(); row <= cover.last(); ++row)
            add_row(&image.rgb[row * bytes_per_pixel * old.width], old.width, cover.weight(row),
                    sums);
        std::transform(sums.begin(), sums.end(), result.row(y).begin(), [=](std::uint64_t sum) {
            return static_cast<std::uint8_t>((sum + area / 2) / area);
        });
    }
    return result;
}

} // namespace raymarch::pictures
