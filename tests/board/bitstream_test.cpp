// SPDX-License-Identifier: MIT
#include "board/bitstream.hpp"

#include "board/configuration_crc.hpp"
#include "drivers/atomic_file.hpp"
#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/random.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace raymarch::board
{
namespace
{

using test::BitstreamPlan;
using test::Check;
using test::make_bin;
using test::make_bit;

/// A short one, which only the count of its frames tells from a whole one.
const BitstreamPlan small{.frames = 1};

/// Made once: a whole one has a million words, whose check sequence is computed bit by bit.
const std::vector<std::uint32_t>& whole_words()
{
    static const auto words = test::configuration_words();
    return words;
}
const std::string& whole_bit()
{
    static const std::string bytes = test::bit_of(whole_words());
    return bytes;
}
const std::string& whole_bin()
{
    static const std::string bytes = test::bytes_of(whole_words(), BitstreamForm::Bin);
    return bytes;
}
std::string with_part(const std::string& part)
{
    static const auto words = test::configuration_words(test::compressed_plan());
    return test::bit_of(words, {.part = part});
}

Result<Bitstream> parse(const std::string& bytes)
{
    return parse_bitstream(drivers::as_bytes(bytes), "FILE");
}

/// Whether it would be loaded. The bitstream borrows the bytes.
Result<Bitstream> take(const std::string& bytes)
{
    auto bitstream = parse(bytes);
    if (bitstream)
        if (auto fits = check_bitstream(*bitstream, zynq_7020, "FILE"); !fits)
            return fail(fits.error());
    return bitstream;
}

void expect_refused(const std::string& bytes, const std::string& part)
{
    const auto bitstream = parse(bytes);
    ASSERT_FALSE(bitstream) << part;
    EXPECT_EQ(bitstream.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(bitstream.error().message.starts_with("FILE: ")) << bitstream.error().message;
    EXPECT_NE(bitstream.error().message.find(part), std::string::npos) << bitstream.error().message;
}

void expect_unfit(const std::string& bytes, const std::string& part)
{
    const auto bitstream = parse(bytes);
    ASSERT_TRUE(bitstream) << bitstream.error().message;
    const auto fits = check_bitstream(*bitstream, zynq_7020, "FILE");
    ASSERT_FALSE(fits) << part;
    EXPECT_EQ(fits.error().kind, ErrorKind::BadData);
    EXPECT_NE(fits.error().message.find(part), std::string::npos) << fits.error().message;
}

TEST(Bitstream, ABitSaysWhatItIs)
{
    const auto bitstream = take(whole_bit());
    ASSERT_TRUE(bitstream) << bitstream.error().message;
    EXPECT_EQ(bitstream->form, BitstreamForm::Bit);
    EXPECT_EQ(bitstream->design, "top;UserID=0XFFFFFFFF;Version=2020.1");
    EXPECT_EQ(bitstream->part, "7z020clg400");
    EXPECT_EQ(bitstream->date, "2025/06/01");
    EXPECT_EQ(bitstream->time, "12:34:56");
    EXPECT_EQ(bitstream->idcode, 0x0372'7093U);
    EXPECT_FALSE(bitstream->compressed);
    EXPECT_TRUE(bitstream->checked);
    // UG470, and what Project X-Ray writes for this part: 10008 frames of 101 words.
    EXPECT_EQ(bitstream->data.size(), 4'045'564U);
    EXPECT_EQ(bitstream->frame_words, 1'010'808U);
}

TEST(Bitstream, ABinIsTheSameWithoutTheHeader)
{
    const auto from_bit = take(whole_bit());
    const auto from_bin = take(whole_bin());
    ASSERT_TRUE(from_bit && from_bin);
    EXPECT_EQ(from_bin->form, BitstreamForm::Bin);
    EXPECT_EQ(from_bin->idcode, from_bit->idcode);
    EXPECT_TRUE(from_bin->checked);
    const auto converted = bin_of(*from_bit);
    EXPECT_TRUE(std::string(converted.begin(), converted.end()) == whole_bin());
    const auto unchanged = bin_of(*from_bin);
    EXPECT_TRUE(std::string(unchanged.begin(), unchanged.end()) == whole_bin());
}

/// What the kernel's driver looks for before it takes a file.
TEST(Bitstream, AConvertedBitHasTheSyncWordThatTheKernelWants)
{
    const std::string bit = make_bit(small);
    const auto bin = bin_of(*parse(bit));
    const std::string text(bin.begin(), bin.end());
    const std::size_t at = text.find("\x66\x55\x99\xAA");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(at % 4, 0U);
}

TEST(Bitstream, TheRevisionOfTheDeviceDoesNotCount)
{
    const std::string bytes = make_bin({.idcode = 0x2372'7093, .frames = 1});
    EXPECT_EQ(parse(bytes)->idcode, 0x0372'7093U);
}

TEST(Bitstream, ACompressedOneIsShortAndHasAllFrames)
{
    BitstreamPlan plan = test::compressed_plan();
    const auto taken = take(make_bit(plan));
    ASSERT_TRUE(taken) << taken.error().message;
    EXPECT_TRUE(taken->compressed);
    EXPECT_TRUE(taken->checked);
    EXPECT_LT(taken->data.size(), 300'000U);
    plan.repeated_frames -= 3;
    expect_unfit(make_bit(plan), "only a part of the logic: 9995 frames; a whole bitstream of "
                                 "7z020clg400 has 9996");
    plan.repeated_frames = 10;
    expect_unfit(make_bin(plan), "only a part of the logic: 12 frames");
}

// --- the device ---

TEST(Bitstream, ThePartMayBeWrittenAsTheToolsTakeIt)
{
    for (const char* const part :
         {"7z020clg400", "xc7z020clg400-1", "7z020clg400-1", "xc7z020clg400", "XC7Z020CLG400-1",
          "7Z020CLG400", "Xc7z020Clg400", "xc7z020clg400-2", "xc7z020clg400-3", "xc7z020clg400-1C",
          "xc7z020clg400-2I", "xc7z020clg400-1LI", "xc7z020clg400-1li", "7z020clg400-3E"}) {
        const std::string bytes = with_part(part);
        const auto taken = take(bytes);
        ASSERT_TRUE(taken) << part << ": " << taken.error().message;
        EXPECT_EQ(taken->part, part) << "as it is written";
    }
}

TEST(Bitstream, OtherPartsAreRefused)
{
    for (const char* const part : {"7z010clg400",
                                   "xc7z010clg400-1",
                                   "XC7Z010CLG400-1",
                                   "7z020clg484",
                                   "xc7z020clg484-1",
                                   "7z020clg40",
                                   "7z020clg4001",
                                   "7a35tcpg236",
                                   "xc7a35tcpg236-1",
                                   "xcxc7z020clg400",
                                   "",
                                   "xc",
                                   "-1",
                                   "7z020clg400-",
                                   "7z020clg400-4",
                                   "7z020clg400-0",
                                   "7z020clg400-12",
                                   "7z020clg400-1LIX",
                                   "7z020clg400-x",
                                   "7z020clg400 ",
                                   " 7z020clg400",
                                   "7z020clg400-1-1",
                                   "7z020clg400x",
                                   "c7z020clg400"})
        expect_unfit(with_part(part),
                     fmt::format("it is for part {}, the board's is 7z020clg400", //
                                 part));
    expect_unfit(with_part("xc7z020clg484-1"), ": the package, and so the pins, are others");
    const auto other = take(with_part("7z010clg400"));
    EXPECT_FALSE(other.error().message.find("package") != std::string::npos);
}

TEST(Bitstream, OneForAnotherDeviceDoesNotFit)
{
    expect_unfit(make_bit({.idcode = 0x0372'2093, .frames = 1}), "03722093");
    expect_unfit(make_bin({.idcode = 0x0372'2093, .frames = 1}), "03722093");
    expect_unfit(test::bit_of(whole_words(), {.design = "top;PARTIAL=TRUE"}), "only a part");
    expect_unfit(make_bit(small), "a whole bitstream of 7z020clg400 has 4045564");
    BitstreamPlan large = test::compressed_plan();
    large.repeated_frames = 150'000;
    expect_unfit(make_bit(large), "4045564 at most");
}

TEST(Bitstream, AllDevicesThatAreNamedAreOne)
{
    for (const std::uint32_t first : {0x0372'2093U, 0x0372'7093U}) {
        const std::uint32_t second = first ^ 0x0000'5000U;
        expect_refused(
            make_bin({.idcode = first, .second_idcode = second, .frames = 1}),
            fmt::format("names two devices, with IDCODE {:08X} and {:08X}", first, second));
    }
    const std::string twice =
        make_bin({.second_idcode = 0x1372'7093, .frames = 1}); // another revision of the same
    EXPECT_TRUE(parse(twice));
}

// --- cut and partial ---

/// Without their check the words may be counted, too: fewer frames than the logic has.
TEST(Bitstream, OneWithTooFewFramesIsRefusedWhateverItsLength)
{
    for (const Check check : {Check::Sequence, Check::Reset}) {
        auto words = test::configuration_words({.frames = test::whole_frames - 1, .check = check});
        words.insert(words.end(), words_a_frame, 0x2000'0000);
        EXPECT_EQ(4 * words.size(), zynq_7020.bitstream_bytes);
        expect_unfit(test::bit_of(words), "only a part of the logic: 10007 frames");
    }
}

TEST(Bitstream, EveryCutOfABitIsNoticed)
{
    const std::string whole = make_bit(small);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(parse(whole.substr(0, size))) << size;
}

TEST(Bitstream, EveryCutOfABinBeforeItsEndIsNoticed)
{
    const std::string whole = make_bin(small);
    constexpr std::size_t idle_words = 400; // after DESYNC nothing counts
    for (std::size_t size = 0; size < whole.size() - 4 * idle_words; ++size)
        EXPECT_FALSE(parse(whole.substr(0, size))) << size;
}

TEST(Bitstream, ACutOfAWholeBinIsRefusedUpToItsLastWord)
{
    for (const std::size_t missing : {1U, 4U, 404U, 1600U, 1604U, 2096U, 1'000'000U, 4'045'000U})
        EXPECT_FALSE(take(whole_bin().substr(0, whole_bin().size() - missing))) << missing;
}

// --- damage ---

/// Where the words of a whole one are, by the layout that UG470 lists.
constexpr std::size_t sync_at = 12;
constexpr std::size_t reset_crc_at = 22; // the command; from here on a check sequence covers all
constexpr std::size_t frames_at = 59;
constexpr std::size_t end_at = frames_at + 1'010'808 + 123; // DESYNC

/// One bit anywhere from the first RCRC to the end: in packets, frames, check sequences.
TEST(Bitstream, EveryFlippedBitOfAPacketIsNoticed)
{
    const auto words = test::configuration_words(small);
    const std::size_t end = words.size() - 401;
    ASSERT_EQ(words[end], 13U);
    for (std::size_t at = reset_crc_at; at <= end; ++at) {
        for (int bit = 0; bit < 32; ++bit) {
            auto damaged = words;
            damaged[at] ^= 1U << bit;
            const bool idle = words[at] == 0x2000'0000 && damaged[at] == 0; // padding, too
            EXPECT_EQ(parse(test::bytes_of(damaged, BitstreamForm::Bin)).has_value(), idle)
                << "bit " << bit << " of word " << at;
        }
    }
    for (int bit = 0; bit < 32; ++bit) {
        auto damaged = words;
        damaged[sync_at] ^= 1U << bit;
        expect_refused(test::bytes_of(damaged, BitstreamForm::Bin), "no sync word");
    }
}

TEST(Bitstream, AFlippedBitInAWholeOneIsNoticed)
{
    auto random = test::seeded_random();
    std::string bin = whole_bin();
    const auto expect_seen = [&](std::size_t at, int bit) {
        bin[at] = static_cast<char>(bin[at] ^ (1 << bit));
        EXPECT_FALSE(take(bin)) << "bit " << bit << " of byte " << at;
        bin[at] = static_cast<char>(bin[at] ^ (1 << bit));
    };
    for (const std::size_t at :
         {frames_at, frames_at + 1'010'807, frames_at + 1'010'809, end_at - 3, end_at - 1, end_at})
        expect_seen(4 * at, 0);
    for (int i = 0; i < 10; ++i)
        expect_seen(test::pick(random, 4 * frames_at, 4 * end_at - 1), test::pick(random, 0, 7));
    EXPECT_TRUE(take(bin)) << "as it was";
}

TEST(Bitstream, OtherDamageToTheFramesIsNoticed)
{
    const std::string whole = make_bin(test::compressed_plan());
    const std::size_t data = 4 * frames_at;
    ASSERT_TRUE(take(whole));
    std::string bytes = whole;
    auto random = test::seeded_random();
    for (std::size_t i = 0; i < 400; ++i)
        bytes[data + i] = static_cast<char>(test::pick(random, 0, 255));
    expect_refused(bytes, "is the check sequence of words that give");
    bytes = whole;
    std::swap(bytes[data + 40], bytes[data + 41]);
    EXPECT_FALSE(take(bytes)) << "two bytes swapped";
    bytes = whole;
    std::swap_ranges(bytes.begin() + data + 40, bytes.begin() + data + 44,
                     bytes.begin() + data + 80);
    EXPECT_FALSE(take(bytes)) << "two words swapped";
    bytes = whole;
    bytes.erase(data + 8, 4);
    EXPECT_FALSE(take(bytes)) << "a word is missing";
    bytes = whole;
    bytes.insert(data + 8, 4, '\0');
    EXPECT_FALSE(take(bytes)) << "a word too many";
}

/// They can be loaded, and nothing can say whether they are as they were made.
TEST(Bitstream, OneWithoutCheckSequencesIsTakenAndSaysSo)
{
    for (const Check check : {Check::Reset, Check::Constant}) {
        auto words = test::configuration_words({.check = check});
        EXPECT_EQ(4 * words.size(), zynq_7020.bitstream_bytes);
        words[frames_at + 5] ^= 1;
        const std::string bytes = test::bit_of(words, {.part = "xc7z020clg400-1"});
        const auto taken = take(bytes);
        ASSERT_TRUE(taken) << taken.error().message;
        EXPECT_FALSE(taken->checked);
    }
}

/// As after an edit by hand: the frames' check is gone, that of the words behind them is right.
TEST(Bitstream, ACheckOfOtherWordsIsNoneOfTheFrames)
{
    auto words = test::configuration_words(small);
    const std::size_t check = frames_at + words_a_frame;
    ASSERT_EQ(words[check], 0x3000'0001U);
    words[check] = 0x3000'8001;
    words[check + 1] = 7;
    const std::string bytes = test::bytes_of(words, BitstreamForm::Bin);
    const auto bitstream = parse(bytes);
    ASSERT_TRUE(bitstream) << bitstream.error().message;
    EXPECT_FALSE(bitstream->checked);
}

/// Nor does the end come too early, by a command that has become DESYNC.
TEST(Bitstream, NothingFollowsTheEnd)
{
    const std::string why = "follows the command that ends the configuration";
    const auto words = test::configuration_words({.frames = 1, .check = Check::Reset});
    auto longer = words;
    const auto second = test::configuration_words({.idcode = 0x0372'2093, .frames = 1});
    longer.insert(longer.end(), second.begin(), second.end());
    expect_refused(test::bytes_of(longer, BitstreamForm::Bin), why);
    auto shorter = words;
    const auto start = std::ranges::find(shorter, 5U); // CMD: START
    ASSERT_NE(start, shorter.end());
    *start = 13;
    expect_refused(test::bytes_of(shorter, BitstreamForm::Bin), why);
    auto padded = words;
    padded.insert(padded.end(), {0, 0xFFFF'FFFF, 0x2000'0000});
    EXPECT_TRUE(parse(test::bytes_of(padded, BitstreamForm::Bin)));
}

TEST(Bitstream, RefusalsSayWhy)
{
    expect_refused("", "no sync word");
    expect_refused(std::string(64, 'x'), "no sync word");
    expect_refused("abc", "whole words");
    const auto words = test::configuration_words(small);
    expect_refused(test::bytes_of(words, BitstreamForm::Bit), "not swapped");
    auto swapped = words;
    for (std::uint32_t& word : swapped)
        word = __builtin_bswap32(word);
    expect_refused(test::bit_of(swapped), "the bytes of its words are swapped");
    expect_refused(make_bin({.frames = 1, .names_device = false}), "IDCODE");
    expect_refused(make_bin({.frames = 1, .ends = false}), "cut");
    const std::string bit = make_bit(small);
    expect_refused(bit + "1234", "the header says 2736 bytes of data, and there are 2740");
    expect_refused(bit.substr(0, 40), "header");
    auto damaged = words;
    damaged[13] = 0x6000'0000;
    expect_refused(test::bytes_of(damaged, BitstreamForm::Bin), "60000000 at byte 52");
    damaged = words;
    damaged[frames_at] ^= 1;
    expect_refused(test::bytes_of(damaged, BitstreamForm::Bin),
                   fmt::format("damaged: {:08X} at byte {} of the data is the check sequence of "
                               "words that give ",
                               words[frames_at + words_a_frame + 1],
                               4 * (frames_at + words_a_frame + 1)));
}

// --- the check sequence ---

/// Values of Project X-Ray's crc_test.cc.
TEST(ConfigurationCrc, GivesThePublishedValues)
{
    struct Row
    {
        std::uint32_t address, word, result;
    };
    for (const auto& [address, word, result] :
         {Row{0, 0, 0}, Row{1 << 4, 0, 0x82F6'3B78}, Row{31, 0xFFFF'FFFF, 0xBF86'D4DF}}) {
        ConfigurationCrc crc;
        crc.add(address, word);
        EXPECT_EQ(crc.value(), result);
    }
}

/// Vivado ends each bitstream of the 7 series with the same words and this check of them.
TEST(ConfigurationCrc, GivesWhatVivadoWrites)
{
    ConfigurationCrc crc;
    crc.add(4, 10);          // CMD: GRESTORE
    crc.add(4, 3);           // CMD: LFRM
    crc.add(4, 5);           // CMD: START
    crc.add(1, 0x03BE'0000); // FAR
    crc.add(6, 0x501);       // MASK
    crc.add(5, 0x501);       // CTL0
    EXPECT_EQ(crc.value(), 0xE3AD'7EA5U);
}

TEST(ConfigurationCrc, IsTheSameBitByBit)
{
    auto random = test::seeded_random();
    ConfigurationCrc crc;
    std::uint32_t expected = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto address = test::pick<std::uint32_t>(random, 0, 31);
        const auto word = test::pick<std::uint32_t>(random, 0, 0xFFFF'FFFF);
        crc.add(address, word);
        expected = test::reference_crc(expected, address, word);
        ASSERT_EQ(crc.value(), expected) << i;
    }
}

} // namespace
} // namespace raymarch::board
