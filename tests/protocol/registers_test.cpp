// SPDX-License-Identifier: MIT
#include "protocol/registers.hpp"

#include "protocol/accelerators.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <bitset>
#include <set>
#include <string>
#include <utility>

namespace raymarch::protocol
{
namespace
{

/// The words as one string of bits, word 0 first, each from bit 31 down.
std::string bits_of(const Words& words)
{
    std::string bits;
    for (std::size_t i = 0; i < accelerator.word_count; ++i)
        bits += std::bitset<32>(words[i]).to_string();
    return bits;
}

// The fields of the eight words in their order, by hand; an 18-bit Y runs over the border of two
// words.
const std::string object_sphere = "00";
const std::string light_3_2_5 = "0000011000"  // 3 * 8 = 24
                                "0000010000"  // 2 * 8 = 16
                                "0000101000"; // 5 * 8 = 40
const std::string zoom_3 = "00000011"
                           "000000000000000000000000";
const std::string zero = "000000000000000000";
const std::string largest = "011111111111111111"; // 1 is held at 1 - 2^-17
const std::string full = "1111111111";

TEST(Registers, TheWordsOfTheDefaultsBitByBit)
{
    const std::string expected = object_sphere + light_3_2_5 + zoom_3 + //
                                 zero + zero + largest + full +         // forward 0 0 1, red
                                 largest + zero + zero + full +         // right 1 0 0, green
                                 zero + largest + zero + full;          // up 0 1 0, blue
    EXPECT_EQ(expected.size(), 256U);
    EXPECT_EQ(bits_of(pack(accelerator, initial_state(accelerator))), expected);
}

TEST(Registers, TheWordsOfTheDefaultsInHex)
{
    const Words words = pack(accelerator, initial_state(accelerator));
    const std::array<std::uint32_t, 8> expected = {0x0180'4028, 0x0300'0000, 0x0000'0000,
                                                   0x07FF'FFFF, 0x7FFF'C000, 0x0000'03FF,
                                                   0x0000'1FFF, 0xF000'03FF};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(words[i], expected[i]) << "word " << i;
}

TEST(Registers, NegativeFieldsAreTwosComplementInTheirWidth)
{
    State state;
    state.codes[marcher::FX] = -1;
    state.codes[marcher::FY] = -131072; // only its sign bit
    state.codes[marcher::LX] = -512;
    const Words words = pack(accelerator, state);
    EXPECT_EQ(words[0], 0x2000'0000U);
    EXPECT_EQ(words[2], 0xFFFF'E000U); // eighteen ones, then the sign bit in bit 13
    EXPECT_EQ(words[3], 0U);
}

class ParameterWords : public test::EveryAccelerator
{
  protected:
    /// The bits that some parameter owns.
    [[nodiscard]] Words owned() const
    {
        State ones(table.size());
        std::ranges::fill(ones.codes, -1);
        return pack(accelerator, ones);
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, ParameterWords, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(ParameterWords, EachBitOfEachParameterHasItsOwnPlace)
{
    std::set<std::pair<std::size_t, int>> taken;
    int placed = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (int bit = 0; bit < table[i].code_width(); ++bit) {
            State state(table.size());
            state.codes[i] = static_cast<std::int64_t>(std::uint64_t{1} << bit);
            const Words words = pack(accelerator, state);
            ASSERT_EQ(words.size(), accelerator.word_count);
            int found = 0;
            for (std::size_t word = 0; word < words.size(); ++word) {
                found += std::popcount(words[word]);
                if (words[word] != 0) {
                    EXPECT_TRUE(taken.emplace(word, std::countr_zero(words[word])).second)
                        << table[i].key << " bit " << bit << " in word " << word;
                }
            }
            ASSERT_EQ(found, table[i].slice_count == 0 ? 0 : 1) << table[i].key << " bit " << bit;
            placed += found;
        }
    }
    int bits = 0;
    for (const std::uint32_t word : owned())
        bits += std::popcount(word);
    EXPECT_EQ(bits, placed);
}

/// pack() is code made of whole pieces; this is what the slices say, one by one.
TEST_P(ParameterWords, AreWhatTheSlicesSay)
{
    std::mt19937_64 random = test::seeded_random();
    for (int round = 0; round < 200; ++round) {
        const State state = test::random_state(accelerator, random);
        Words expected(accelerator.word_count);
        for (std::size_t i = 0; i < table.size(); ++i)
            for (const Slice& slice : table[i].placement())
                expected[slice.word] |=
                    (static_cast<std::uint32_t>(static_cast<std::uint64_t>(state.codes[i]) >>
                                                slice.shift) &
                     slice.mask)
                    << slice.lsb;
        ASSERT_EQ(pack(accelerator, state), expected);
    }
}

TEST_P(ParameterWords, LieInsideTheirPartOfThePage)
{
    std::size_t last = 0;
    for (const Parameter& parameter : table)
        for (const Slice& slice : parameter.placement())
            last = std::max<std::size_t>(last, slice.word);
    EXPECT_EQ(last + 1, accelerator.word_count);
    if (accelerator.kind == 0) { // the source's own layout, below the extended registers
        EXPECT_EQ(accelerator.first_word_offset, 0);
        return;
    }
    EXPECT_EQ(accelerator.first_word_offset, 0x100);
    EXPECT_LE(accelerator.first_word_offset + 4 * accelerator.word_count, 0x800);
}

TEST_P(ParameterWords, UnpackingIsTheInverseOfPacking)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 2000; ++i) {
        State state = initial_state(accelerator);
        for (std::size_t p = 0; p < table.size(); ++p) {
            if (table[p].slice_count == 0) // in no register: it comes back as the default
                continue;
            const std::int64_t most = table[p].largest_code;
            const std::int64_t least = table[p].format.is_signed ? -most - 1 : 0;
            state.codes[p] = test::pick(random, least, most);
        }
        ASSERT_EQ(unpack(accelerator, pack(accelerator, state)), state);
    }
}

TEST_P(ParameterWords, PackingIsTheInverseOfUnpackingOnTheBitsThatAreOwned)
{
    auto random = test::seeded_random();
    const Words mask = owned();
    for (int i = 0; i < 2000; ++i) {
        Words words(accelerator.word_count);
        Words expected(accelerator.word_count);
        for (std::size_t w = 0; w < words.size(); ++w) {
            words[w] = static_cast<std::uint32_t>(random());
            expected[w] = words[w] & mask[w];
        }
        ASSERT_EQ(pack(accelerator, unpack(accelerator, {words.data(), words.size()})), expected);
    }
}

TEST_P(ParameterWords, TheBlockIsDescribed)
{
    EXPECT_EQ(find_accelerator(capability_kind(capability_word(accelerator))), &accelerator);
    EXPECT_EQ(geometry_size(geometry_word(accelerator.size)), accelerator.size);
}

TEST(Registers, TheMarcherOwnsEveryBit) // source 000: 256 bits in eight registers
{
    State ones(accelerator.parameters.size());
    std::ranges::fill(ones.codes, -1);
    for (const std::uint32_t word : pack(accelerator, ones))
        EXPECT_EQ(word, 0xFFFF'FFFFU);
}

TEST(Registers, TheExtendedOnesStandBehindTheWords)
{
    int offset = accelerator.first_word_offset + 4 * accelerator.word_count;
    for (const RegisterRow& row : extended_registers) {
        EXPECT_EQ(static_cast<int>(row.at), offset) << row.name;
        offset += 4;
    }
    EXPECT_LE(static_cast<std::size_t>(offset), register_page_bytes);
}

/// The contract once more by hand.
TEST(Registers, FieldsHaveTheBitsOfTheContract)
{
    EXPECT_EQ(control::enable, 0x1U);
    EXPECT_EQ(control::interrupt_enable, 0x2U);
    EXPECT_EQ(control::shadow, 0x4U);
    EXPECT_EQ(control::soft_reset, 0x8U);
    EXPECT_EQ(status::busy, 0x1U);
    EXPECT_EQ(status::commit_pending, 0x2U);
    EXPECT_EQ(status::frame_done, 0x4U);
    EXPECT_EQ(status::fault, 0x8U);
    EXPECT_EQ(version_value, 0x0001'0000U);
    EXPECT_EQ(field_mask(Register::Capability, "KIND"), 0xFF00'0000U);
    EXPECT_EQ(field_mask(Register::Geometry, "HEIGHT"), 0x0000'FFFFU);
}

TEST(Registers, FieldsOfARegisterShareNoBit)
{
    for (const RegisterRow& row : extended_registers) {
        std::uint64_t used = 0;
        for (const RegisterField& field : register_fields) {
            if (field.at != row.at)
                continue;
            ASSERT_LE(field.lsb, field.msb) << field.name;
            ASSERT_LT(field.msb, 32) << field.name;
            const std::uint64_t mask = ((std::uint64_t{2} << (field.msb - field.lsb)) - 1)
                                       << field.lsb;
            EXPECT_EQ(used & mask, 0U) << row.name << '.' << field.name;
            used |= mask;
        }
    }
}

TEST(Registers, WordsThatDescribeTheBlock)
{
    EXPECT_EQ(id_value, 0x524D'4152U);                     // "RMAR"
    EXPECT_EQ(capability_word(accelerator), 0x0004'0000U); // kind 0, four ray units
    EXPECT_EQ(capability_kind(0x1204'0000), 0x12);
    EXPECT_EQ(geometry_word({640, 480}), 0x0280'01E0U);
    EXPECT_EQ(geometry_size(0x0280'01E0), (PictureSize{640, 480}));
}

TEST(Registers, AcceleratorsAreFoundByNameAndKind)
{
    EXPECT_EQ(find_accelerator("Marcher"), &accelerator);
    EXPECT_EQ(find_accelerator("march"), nullptr);
    EXPECT_EQ(find_accelerator(std::uint8_t{0}), &accelerator);
    EXPECT_EQ(find_accelerator(std::uint8_t{255}), nullptr);
    std::set<int> kinds;
    for (const Accelerator* each : accelerators)
        EXPECT_TRUE(kinds.insert(each->kind).second) << each->name;
}

} // namespace
} // namespace raymarch::protocol
