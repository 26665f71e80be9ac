// SPDX-License-Identifier: MIT
/// @file
/// Bitstreams to order, with the packets and the header that Vivado's have.
#pragma once

#include "drivers/bitstream.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::test
{

/// What a bitstream is to be; the default is a whole one for the board.
struct BitstreamPlan
{
    std::string design = "top;UserID=0XFFFFFFFF;Version=2020.1";
    std::string part = std::string(drivers::zynq_7020.part);
    std::uint32_t idcode = drivers::zynq_7020.idcode;
    std::size_t bytes = drivers::zynq_7020.bitstream_bytes;
    bool compressed = false;
    bool names_device = true;
    bool ends = true;
};

/// The configuration words.
[[nodiscard]] inline std::vector<std::uint32_t> configuration_words(const BitstreamPlan& plan = {})
{
    constexpr std::uint32_t padding = 0xFFFF'FFFF;
    constexpr std::uint32_t nothing = 0x2000'0000;
    std::vector<std::uint32_t> words(8, padding);
    for (const std::uint32_t word : {0x0000'00BBU, 0x1122'0044U, padding, padding, 0xAA99'5566U,
                                     nothing, 0x3000'8001U, 0x0000'0007U}) // CMD: reset the CRC
        words.push_back(word);
    if (plan.names_device)
        words.insert(words.end(), {0x3001'8001, plan.idcode});
    if (plan.compressed)
        words.insert(words.end(), {0x3001'4004, 0, 0, 0, 0});                      // MFWR
    std::vector<std::uint32_t> end = {0x3000'8001, 0x0000'000D, nothing, nothing}; // CMD: DESYNC
    if (!plan.ends)
        end.assign(4, nothing);
    const std::size_t frames = plan.bytes / 4 - words.size() - end.size() - 2;
    words.insert(words.end(),
                 {0x3000'4000, 0x5000'0000 | static_cast<std::uint32_t>(frames)}); // FDRI, type 2
    words.insert(words.end(), frames, 0x1234'5678);
    words.insert(words.end(), end.begin(), end.end());
    return words;
}

/// A `.bin` is low byte first, the data of a `.bit` high byte first.
[[nodiscard]] inline std::string bytes_of(const std::vector<std::uint32_t>& words,
                                          drivers::BitstreamForm form)
{
    std::string bytes;
    bytes.reserve(4 * words.size());
    for (const std::uint32_t word : words)
        for (int i = 0; i < 4; ++i)
            bytes += static_cast<char>(word >>
                                       (form == drivers::BitstreamForm::Bin ? 8 * i : 24 - 8 * i));
    return bytes;
}

[[nodiscard]] inline std::string big_endian(std::size_t value, int count)
{
    std::string bytes;
    for (int i = count - 1; i >= 0; --i)
        bytes += static_cast<char>(value >> 8 * i);
    return bytes;
}

[[nodiscard]] inline std::string make_bin(const BitstreamPlan& plan = {})
{
    return bytes_of(configuration_words(plan), drivers::BitstreamForm::Bin);
}

[[nodiscard]] inline std::string make_bit(const BitstreamPlan& plan = {})
{
    using namespace std::string_literals;
    const std::string data = bytes_of(configuration_words(plan), drivers::BitstreamForm::Bit);
    std::string bytes = "\x00\x09\x0F\xF0\x0F\xF0\x0F\xF0\x0F\xF0\x00\x00\x01"s;
    const auto field = [&](char letter, const std::string& text) {
        bytes += letter + big_endian(text.size() + 1, 2) + text + '\0';
    };
    field('a', plan.design);
    field('b', plan.part);
    field('c', "2025/06/01");
    field('d', "12:34:56");
    return bytes + 'e' + big_endian(data.size(), 4) + data;
}

} // namespace raymarch::test
