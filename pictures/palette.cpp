// SPDX-License-Identifier: MIT
#include "pictures/palette.hpp"

#include <algorithm>
#include <cassert>
#include <span>

namespace raymarch::pictures
{
namespace
{

constexpr std::size_t channels = 3;

/// One colour of the picture. `packed` is 0xRRGGBB, so that the order is that of the palette.
struct Entry
{
    std::uint32_t packed = 0;
    std::uint32_t pixels = 0;
    std::uint8_t index = 0; ///< of the palette
};

/// Colours that will be one. The error is the sum over the pixels of the squared distance from the
/// mean, in `channel`, the one where it is greatest.
struct Group
{
    std::span<Entry> entries;
    std::uint64_t pixels = 0;
    std::array<std::uint64_t, channels> sums{}; ///< over the pixels
    std::uint64_t error = 0;
    std::size_t channel = 0;
};

std::uint32_t pack(const std::uint8_t* rgb) noexcept
{
    return std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
}

std::uint32_t channel_of(std::uint32_t packed, std::size_t channel) noexcept
{
    return packed >> (16 - 8 * channel) & 0xFF;
}

Colour colour_of(std::uint32_t packed) noexcept
{
    return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
            static_cast<std::uint8_t>(packed)};
}

/// The colours of the picture with their numbers of pixels, rising.
std::vector<Entry> count_colours(const engine::Image& image)
{
    std::vector<std::uint32_t> pixels(image.rgb.size() / engine::bytes_per_pixel);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = pack(&image.rgb[i * engine::bytes_per_pixel]);
    std::sort(pixels.begin(), pixels.end());
    std::vector<Entry> colours;
    for (const std::uint32_t pixel : pixels) {
        if (colours.empty() || colours.back().packed != pixel)
            colours.push_back({.packed = pixel});
        ++colours.back().pixels;
    }
    return colours;
}

/// 2^32 pixels of 255 squared are 2^48: no sum overflows.
Group group_of(std::span<Entry> entries) noexcept
{
    Group group{.entries = entries};
    std::array<std::uint64_t, channels> squares{};
    for (const Entry& entry : entries) {
        group.pixels += entry.pixels;
        for (std::size_t channel = 0; channel < channels; ++channel) {
            const std::uint64_t value = channel_of(entry.packed, channel);
            group.sums[channel] += entry.pixels * value;
            squares[channel] += entry.pixels * value * value;
        }
    }
    assert(group.pixels > 0);
    for (std::size_t channel = 0; channel < channels; ++channel) {
        // The mean is a fraction; its whole part comes off first, for the sum squared would need
        // more than 64 bits.
        const std::uint64_t sum = group.sums[channel];
        const std::uint64_t mean = sum / group.pixels;
        const std::uint64_t rest = sum % group.pixels;
        const std::uint64_t error =
            squares[channel] - mean * (sum + rest) - rest * rest / group.pixels;
        if (error > group.error) {
            group.error = error;
            group.channel = channel;
        }
    }
    return group;
}

/// Where the second half of a group begins: with the colours above the mean. Neither half is empty
/// when the error is not 0.
std::size_t cut(const Group& group)
{
    const std::uint64_t mean = group.sums[group.channel] / group.pixels;
    const auto middle =
        std::partition(group.entries.begin(), group.entries.end(), [&](const Entry& entry) {
            return channel_of(entry.packed, group.channel) <= mean;
        });
    return static_cast<std::size_t>(middle - group.entries.begin());
}

/// The mean of the group, rounded to nearest.
std::uint32_t mean_of(const Group& group) noexcept
{
    std::uint32_t packed = 0;
    for (const std::uint64_t sum : group.sums)
        packed = packed << 8 | static_cast<std::uint32_t>((sum + group.pixels / 2) / group.pixels);
    return packed;
}

std::vector<Group> gather(std::span<Entry> colours)
{
    std::vector<Group> groups = {group_of(colours)};
    while (groups.size() < max_palette_colours) {
        const auto widest =
            std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
                return a.error < b.error; // the first of equals: the order is always the same
            });
        if (widest->error == 0)
            break;
        const std::span<Entry> entries = widest->entries;
        const std::size_t middle = cut(*widest);
        *widest = group_of(entries.first(middle));
        groups.push_back(group_of(entries.subspan(middle)));
    }
    return groups;
}

/// The palette; each of the colours gets its index in it.
std::vector<Colour> choose_palette(std::vector<Entry>& colours)
{
    std::vector<std::uint32_t> chosen;
    if (colours.size() <= max_palette_colours) {
        for (Entry& entry : colours) {
            entry.index = static_cast<std::uint8_t>(chosen.size());
            chosen.push_back(entry.packed);
        }
    } else {
        const std::vector<Group> groups = gather(colours);
        for (const Group& group : groups)
            chosen.push_back(mean_of(group));
        const std::vector<std::uint32_t> means = chosen;
        std::sort(chosen.begin(), chosen.end());
        chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const auto place = std::lower_bound(chosen.begin(), chosen.end(), means[i]);
            for (Entry& entry : groups[i].entries)
                entry.index = static_cast<std::uint8_t>(place - chosen.begin());
        }
        std::sort(colours.begin(), colours.end(),
                  [](const Entry& a, const Entry& b) { return a.packed < b.packed; });
    }
    std::vector<Colour> palette(chosen.size());
    std::transform(chosen.begin(), chosen.end(), palette.begin(), colour_of);
    return palette;
}

} // namespace

IndexedImage indexed(const engine::Image& image)
{
    std::vector<Entry> colours = count_colours(image);
    IndexedImage result{.size = image.size, .palette = choose_palette(colours)};
    result.indices.resize(image.rgb.size() / engine::bytes_per_pixel);
    const Entry* last = colours.data(); // the neighbour's colour is often this pixel's
    for (std::size_t i = 0; i < result.indices.size(); ++i) {
        const std::uint32_t pixel = pack(&image.rgb[i * engine::bytes_per_pixel]);
        if (last->packed != pixel)
            last = &*std::lower_bound(
                colours.begin(), colours.end(), pixel,
                [](const Entry& entry, std::uint32_t value) { return entry.packed < value; });
        result.indices[i] = last->index;
    }
    return result;
}

} // namespace raymarch::pictures
