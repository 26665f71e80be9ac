// SPDX-License-Identifier: MIT
#include "drivers/bitstream.hpp"

#include "drivers/atomic_file.hpp"
#include "tests/fakes/bitstreams.hpp"

#include <gtest/gtest.h>

#include <string>

namespace raymarch::drivers
{
namespace
{

using test::BitstreamPlan;
using test::make_bin;
using test::make_bit;

/// Small ones, which only the length check tells from whole ones.
constexpr std::size_t small = 512;

Result<Bitstream> parse(const std::string& bytes)
{
    return parse_bitstream(as_bytes(bytes), "FILE");
}

void expect_refused(const std::string& bytes, const std::string& part)
{
    const auto bitstream = parse(bytes);
    ASSERT_FALSE(bitstream) << part;
    EXPECT_EQ(bitstream.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(bitstream.error().message.starts_with("FILE: ")) << bitstream.error().message;
    EXPECT_NE(bitstream.error().message.find(part), std::string::npos) << bitstream.error().message;
}

void expect_unfit(const BitstreamPlan& plan, const std::string& part)
{
    const std::string bytes = make_bit(plan);
    const auto bitstream = parse(bytes);
    ASSERT_TRUE(bitstream) << bitstream.error().message;
    const auto fits = check_bitstream(*bitstream, zynq_7020, "FILE");
    ASSERT_FALSE(fits) << part;
    EXPECT_EQ(fits.error().kind, ErrorKind::BadData);
    EXPECT_NE(fits.error().message.find(part), std::string::npos) << fits.error().message;
}

TEST(Bitstream, ABitSaysWhatItIs)
{
    const std::string bytes = make_bit();
    const auto bitstream = parse(bytes);
    ASSERT_TRUE(bitstream) << bitstream.error().message;
    EXPECT_EQ(bitstream->form, BitstreamForm::Bit);
    EXPECT_EQ(bitstream->design, "top;UserID=0XFFFFFFFF;Version=2020.1");
    EXPECT_EQ(bitstream->part, "7z020clg400");
    EXPECT_EQ(bitstream->date, "2025/06/01");
    EXPECT_EQ(bitstream->time, "12:34:56");
    EXPECT_EQ(bitstream->idcode, 0x0372'7093U);
    EXPECT_FALSE(bitstream->compressed);
    EXPECT_EQ(bitstream->data.size(), 4'045'564U);
    EXPECT_TRUE(check_bitstream(*bitstream, zynq_7020, "FILE"));
}

TEST(Bitstream, ABinIsTheSameWithoutTheHeader)
{
    const std::string bit = make_bit();
    const std::string bin = make_bin();
    const auto from_bit = parse(bit);
    const auto from_bin = parse(bin);
    ASSERT_TRUE(from_bit && from_bin);
    EXPECT_EQ(from_bin->form, BitstreamForm::Bin);
    EXPECT_EQ(from_bin->idcode, from_bit->idcode);
    EXPECT_TRUE(check_bitstream(*from_bin, zynq_7020, "FILE"));
    const auto converted = bin_of(*from_bit);
    EXPECT_EQ(std::string(converted.begin(), converted.end()), bin);
    const auto unchanged = bin_of(*from_bin);
    EXPECT_EQ(std::string(unchanged.begin(), unchanged.end()), bin);
}

/// What the kernel's driver looks for before it takes a file.
TEST(Bitstream, AConvertedBitHasTheSyncWordThatTheKernelWants)
{
    const std::string bit = make_bit({.bytes = small});
    const auto bin = bin_of(*parse(bit));
    const std::string text(bin.begin(), bin.end());
    const std::size_t at = text.find("\x66\x55\x99\xAA");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(at % 4, 0U);
}

TEST(Bitstream, TheRevisionOfTheDeviceDoesNotCount)
{
    const std::string bytes = make_bin({.idcode = 0x2372'7093, .bytes = small});
    EXPECT_EQ(parse(bytes)->idcode, 0x0372'7093U);
}

TEST(Bitstream, ACompressedOneMayBeShort)
{
    const std::string bytes = make_bit({.bytes = small, .compressed = true});
    const auto bitstream = parse(bytes);
    ASSERT_TRUE(bitstream);
    EXPECT_TRUE(bitstream->compressed);
    EXPECT_TRUE(check_bitstream(*bitstream, zynq_7020, "FILE"));
}

TEST(Bitstream, OneForAnotherDeviceDoesNotFit)
{
    expect_unfit({.part = "7z010clg400"}, "7z010clg400");
    expect_unfit({.idcode = 0x0372'2093}, "03722093");
    expect_unfit({.design = "top;PARTIAL=TRUE"}, "only a part");
    expect_unfit({.bytes = small}, "a whole bitstream of 7z020clg400 has 4045564");
    expect_unfit({.bytes = 4'100'000, .compressed = true}, "4045564 at most");
}

TEST(Bitstream, EveryCutOfABitIsNoticed)
{
    const std::string whole = make_bit({.bytes = small});
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(parse(whole.substr(0, size))) << size;
}

TEST(Bitstream, EveryCutOfABinBeforeItsEndIsNoticed)
{
    const std::string whole = make_bin({.bytes = small});
    constexpr std::size_t idle_words = 2; // after DESYNC nothing counts
    for (std::size_t size = 0; size < whole.size() - 4 * idle_words; ++size)
        EXPECT_FALSE(parse(whole.substr(0, size))) << size;
}

TEST(Bitstream, RefusalsSayWhy)
{
    expect_refused("", "no sync word");
    expect_refused(std::string(64, 'x'), "no sync word");
    expect_refused("abc", "whole words");
    const std::string swapped =
        test::bytes_of(test::configuration_words({.bytes = small}), BitstreamForm::Bit);
    expect_refused(swapped, "not swapped");
    expect_refused(make_bin({.bytes = small, .names_device = false}), "IDCODE");
    expect_refused(make_bin({.bytes = small, .ends = false}), "cut");
    const std::string bit = make_bit({.bytes = small});
    expect_refused(bit + "1234", "the header says 512 bytes of data, and there are 516");
    expect_refused(bit.substr(0, 40), "header");
    auto words = test::configuration_words({.bytes = small});
    words[13] = 0x6000'0000;
    expect_refused(test::bytes_of(words, BitstreamForm::Bin), "60000000 at byte 52");
}

} // namespace
} // namespace raymarch::drivers
