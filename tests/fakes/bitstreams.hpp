// SPDX-License-Identifier: MIT
/// @file
/// Bitstreams to order, with the header and word for word the packets that Vivado's have (UG470,
/// "Bitstream Composition").
#pragma once

#include "board/bitstream.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::test
{

/// What stands where a check sequence may stand.
enum class Check : std::uint8_t {
    Sequence, ///< Vivado's
    Reset,    ///< the command that resets it: Vivado's with CRC=DISABLE, and the open tools'
    Constant, ///< 0000DEFC: older tools' with the same option
};

inline constexpr std::size_t whole_frames =
    board::zynq_7020.frames + board::zynq_7020.padding_frames;

/// What a bitstream is to be; the default is a whole one for the board.
struct BitstreamPlan
{
    std::string design = "top;UserID=0XFFFFFFFF;Version=2020.1";
    std::string part = std::string(board::zynq_7020.part);
    std::uint32_t idcode = board::zynq_7020.idcode;
    std::optional<std::uint32_t> second_idcode; ///< written as well, after the first
    std::size_t frames = whole_frames;          ///< with their data
    std::size_t repeated_frames = 0;            ///< compressed: frames that repeat another's data
    Check check = Check::Sequence;
    bool names_device = true;
    bool ends = true;
};

/// A compressed one for the whole board is the shortest: a test that takes it is quick.
[[nodiscard]] inline BitstreamPlan compressed_plan()
{
    return {.frames = 2, .repeated_frames = board::zynq_7020.frames};
}

/// One bit after the other, as the hardware does: slow, and not the way of board/.
[[nodiscard]] inline std::uint32_t reference_crc(std::uint32_t crc, std::uint32_t address,
                                                 std::uint32_t word)
{
    std::uint64_t bits = std::uint64_t{address} << 32 | word;
    for (int i = 0; i < 37; ++i, bits >>= 1) {
        const bool differs = ((crc ^ bits) & 1) != 0;
        crc = (crc >> 1) ^ (differs ? 0x82F6'3B78U : 0U);
    }
    return crc;
}

/// Configuration words as a tool puts them together.
class WordWriter
{
  public:
    explicit WordWriter(Check check) : check_(check) {}

    void plain(std::uint32_t word, std::size_t count = 1)
    {
        words_.insert(words_.end(), count, word);
    }
    void no_operation(std::size_t count = 1) { plain(0x2000'0000, count); }
    void write(std::uint32_t address, std::initializer_list<std::uint32_t> values)
    {
        plain(0x3000'0000U | address << 13 | static_cast<std::uint32_t>(values.size()));
        for (const std::uint32_t value : values)
            data(address, value);
        if (address == command && *values.begin() == 7)
            crc_ = 0;
    }
    void frames(std::size_t count)
    {
        const std::size_t size = count * board::words_a_frame;
        plain(0x3000'4000);
        plain(0x5000'0000U | static_cast<std::uint32_t>(size));
        for (std::size_t i = 0; i < size; ++i)
            data(2, static_cast<std::uint32_t>(i * 0x0101'6A09));
    }
    void check()
    {
        if (check_ == Check::Reset)
            return write(command, {7});
        plain(0x3000'0001);
        plain(check_ == Check::Sequence ? crc_ : 0xDEFC);
        crc_ = 0;
    }
    [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }

    static constexpr std::uint32_t command = 4;

  private:
    void data(std::uint32_t address, std::uint32_t value)
    {
        plain(value);
        if (check_ == Check::Sequence)
            crc_ = reference_crc(crc_, address, value);
    }

    Check check_;
    std::uint32_t crc_ = 0;
    std::vector<std::uint32_t> words_;
};

/// The configuration words.
[[nodiscard]] inline std::vector<std::uint32_t> configuration_words(const BitstreamPlan& plan = {})
{
    constexpr std::uint32_t far = 1;
    constexpr std::uint32_t command = WordWriter::command;
    constexpr std::uint32_t control_0 = 5;
    constexpr std::uint32_t mask = 6;
    constexpr std::uint32_t control_1 = 24;
    WordWriter writer(plan.check);
    writer.plain(0xFFFF'FFFF, 8);
    writer.plain(0x0000'00BB);
    writer.plain(0x1122'0044);
    writer.plain(0xFFFF'FFFF, 2);
    writer.plain(0xAA99'5566);
    writer.no_operation();
    writer.write(17, {0}); // TIMER
    writer.write(16, {0}); // WBSTAR
    writer.write(command, {0});
    writer.no_operation();
    writer.write(command, {7}); // RCRC
    writer.no_operation(2);
    writer.write(19, {0});
    writer.write(9, {0x0200'3FE5}); // COR0
    writer.write(14, {0});          // COR1
    if (plan.names_device)
        writer.write(12, {plan.idcode});
    if (plan.second_idcode)
        writer.write(12, {*plan.second_idcode});
    writer.write(command, {9}); // SWITCH
    writer.no_operation();
    writer.write(mask, {0x401});
    writer.write(control_0, {0x501});
    writer.write(mask, {0});
    writer.write(control_1, {0});
    writer.no_operation(8);
    writer.write(far, {0});
    writer.write(command, {1}); // WCFG
    writer.no_operation();
    writer.frames(plan.frames);
    if (plan.repeated_frames > 0)
        writer.write(command, {2}); // MFW
    for (std::size_t i = 0; i < plan.repeated_frames; ++i) {
        writer.write(far, {static_cast<std::uint32_t>(i)});
        writer.write(10, {0, 0, 0, 0}); // MFWR
    }
    writer.check();
    writer.no_operation(2);
    writer.write(command, {10}); // GRESTORE
    writer.no_operation();
    writer.write(command, {3}); // LFRM
    writer.no_operation(100);
    writer.write(command, {5}); // START
    writer.no_operation();
    writer.write(far, {0x03BE'0000});
    writer.write(mask, {0x501});
    writer.write(control_0, {0x501});
    writer.check();
    writer.no_operation(2);
    if (plan.ends)
        writer.write(command, {13}); // DESYNC
    else
        writer.no_operation(2);
    writer.no_operation(400);
    return writer.words();
}

/// A `.bin` is low byte first, the data of a `.bit` high byte first.
[[nodiscard]] inline std::string bytes_of(const std::vector<std::uint32_t>& words,
                                          board::BitstreamForm form)
{
    std::string bytes;
    bytes.reserve(4 * words.size());
    for (const std::uint32_t word : words)
        for (int i = 0; i < 4; ++i)
            bytes +=
                static_cast<char>(word >> (form == board::BitstreamForm::Bin ? 8 * i : 24 - 8 * i));
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
    return bytes_of(configuration_words(plan), board::BitstreamForm::Bin);
}

/// Words with the header of a `.bit`.
[[nodiscard]] inline std::string bit_of(const std::vector<std::uint32_t>& words,
                                        const BitstreamPlan& plan = {})
{
    using namespace std::string_literals;
    const std::string data = bytes_of(words, board::BitstreamForm::Bit);
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

[[nodiscard]] inline std::string make_bit(const BitstreamPlan& plan = {})
{
    return bit_of(configuration_words(plan), plan);
}

} // namespace raymarch::test
