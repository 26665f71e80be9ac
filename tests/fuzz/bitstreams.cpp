// SPDX-License-Identifier: MIT
/// @file
/// A bitstream that is taken is taken again as a `.bin`, as the same one, and stays as it is.
/// Frames with their check sequence are taken whatever they hold, and not when a bit of them is
/// another. What is read of an overlay lies within it.
#include "tests/fakes/bitstreams.hpp"
#include "board/bitstream.hpp"
#include "board/flat_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

using namespace raymarch; // NOLINT(google-build-using-namespace)

namespace
{

using Bytes = std::span<const std::uint8_t>;

void check(Bytes bytes)
{
    const auto bitstream = board::parse_bitstream(bytes, "any");
    if (!bitstream)
        return;
    static_cast<void>(board::check_bitstream(*bitstream, board::zynq_7020, "any"));
    const auto bin = board::bin_of(*bitstream);
    const auto again = board::parse_bitstream(bin, "again");
    if (!again || again->form != board::BitstreamForm::Bin || again->idcode != bitstream->idcode ||
        again->compressed != bitstream->compressed || again->checked != bitstream->checked ||
        again->frame_words != bitstream->frame_words ||
        again->repeated_frames != bitstream->repeated_frames || board::bin_of(*again) != bin)
        std::abort();
}

/// Vivado's words around the given ones as frame data.
void check_frames(Bytes bytes)
{
    static const auto around = test::configuration_words({.frames = 1});
    constexpr std::size_t frames_at = 59;
    const auto frame = around.begin() + frames_at;
    std::vector<std::uint32_t> words(around.begin(), frame);
    std::uint32_t crc = 0;
    for (auto word = around.begin() + 25; word != frame - 2;) { // from RCRC on
        const std::uint32_t header = *word++;
        if (header != 0x2000'0000)
            crc = test::reference_crc(crc, header >> 13 & 0x1F, *word++);
    }
    words.back() = 0x5000'0000U | static_cast<std::uint32_t>(bytes.size() / 4);
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
        std::uint32_t word = 0;
        for (const std::uint8_t byte : bytes.subspan(at, 4))
            word = word << 8 | byte;
        words.push_back(word);
        crc = test::reference_crc(crc, 2, word);
    }
    words.insert(words.end(), {0x3000'0001, crc});
    words.insert(words.end(), frame + board::words_a_frame + 2, around.end());
    const std::string whole = test::bytes_of(words, board::BitstreamForm::Bin);
    std::vector<std::uint8_t> bin(whole.begin(), whole.end());
    const auto taken = board::parse_bitstream(bin, "made");
    if (!taken || !taken->checked || taken->frame_words != bytes.size() / 4)
        std::abort();
    if (bytes.size() < 4)
        return;
    const std::size_t at = crc % (bytes.size() / 4 * 4); // any
    bin[4 * frames_at + at] ^= static_cast<std::uint8_t>(1U << (crc >> 29));
    if (board::parse_bitstream(bin, "damaged"))
        std::abort();
}

/// Behind a right beginning, or the fuzzer would hardly get past it.
void check_behind(Bytes beginning, Bytes bytes)
{
    std::vector<std::uint8_t> whole(beginning.begin(), beginning.end());
    whole.insert(whole.end(), bytes.begin(), bytes.end());
    check(whole);
}

/// As the structure of a tree whose header is right and whose strings are its first bytes.
void check_tree(Bytes bytes)
{
    constexpr std::array<std::uint32_t, 10> cells = {0xD00D'FEED, 0, 40, 40};
    std::vector<std::uint8_t> tree;
    for (const std::uint32_t cell : cells)
        for (int shift = 24; shift >= 0; shift -= 8)
            tree.push_back(static_cast<std::uint8_t>(cell >> shift));
    tree.insert(tree.end(), bytes.begin(), bytes.end());
    for (std::size_t i = 0; i < 4; ++i)
        tree[4 + i] = static_cast<std::uint8_t>(tree.size() >> (24 - 8 * i));
    const auto values = board::values_of(tree, "", "any");
    if (!values)
        return;
    for (const Bytes value : *values)
        if (value.data() < tree.data() || value.data() + value.size() > tree.data() + tree.size())
            std::abort();
}

constexpr std::array<std::uint8_t, 25> bit_header = {
    0x00, 0x09, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F, 0xF0, 0x00, 0x00, 0x01,
    'a',  0,    0,    'b',  0,    0,    'c',  0,    0,    'd',  0,    0};
constexpr std::array<std::uint8_t, 12> bin_sync = {0x66, 0x55, 0x99, 0xAA, 0x01, 0x80,
                                                   0x01, 0x30, 0x93, 0x70, 0x72, 0x03};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Bytes bytes{data, size};
    check(bytes);
    check_frames(bytes);
    check_behind(bin_sync, bytes);
    check_behind(bit_header, bytes);

    // With a length that is right, and a sync word and IDCODE of the form.
    std::vector<std::uint8_t> bit(bit_header.begin(), bit_header.end());
    const auto length = static_cast<std::uint32_t>(size + bin_sync.size());
    bit.push_back('e');
    for (int shift = 24; shift >= 0; shift -= 8)
        bit.push_back(static_cast<std::uint8_t>(length >> shift));
    for (std::size_t word = 0; word < bin_sync.size(); word += 4)
        for (std::size_t i = 4; i-- > 0;)
            bit.push_back(bin_sync[word + i]);
    check_behind(bit, bytes);
    static_cast<void>(board::values_of(bytes, "", "any"));
    check_tree(bytes);
    return 0;
}
