// SPDX-License-Identifier: MIT
#include "protocol/picture_frames.hpp"

#include "base/crc32.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace raymarch::protocol
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const EthernetFrame& frame)
{
    return {frame.bytes().begin(), frame.bytes().end()};
}

/// Pixel (x, y) has the level (x + 299 - y) mod 16, so row 299 begins with 0, 1, 2.
const GreyPicture& ramp()
{
    static const GreyPicture made = [] {
        GreyPicture picture;
        for (std::size_t y = 0; y < export_size.height; ++y)
            for (std::size_t x = 0; x < export_size.width; ++x)
                picture.row(y)[x] = static_cast<std::uint8_t>((x + 299 - y) % 16);
        return picture;
    }();
    return made;
}

GreyPicture random_picture(std::mt19937_64& random)
{
    GreyPicture picture;
    for (std::uint8_t& level : picture.levels)
        level = static_cast<std::uint8_t>(random() % 16);
    return picture;
}

std::vector<Bytes> all_frames(const GreyPicture& picture, Fcs fcs = Fcs::Without)
{
    std::vector<Bytes> frames;
    for (std::size_t i = 0; i < export_frames; ++i)
        frames.push_back(bytes_of(frame_of(picture, i, fcs)));
    return frames;
}

void take_all(PictureAssembler& assembler, const std::vector<Bytes>& frames)
{
    for (const Bytes& frame : frames)
        assembler.take(frame);
}

const Bytes head = {0x88, 0x66, 0x5A, 0x03, 0x48, 0xB0, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x00};

TEST(PictureFrames, TheStartFrameToTheByte)
{
    Bytes wanted = head;
    wanted.insert(wanted.end(), 50, 0xFF);
    EXPECT_EQ(bytes_of(frame_of(ramp(), 0)), wanted);
    // zlib.crc32 of these 63 bytes is 0x4E3907E3.
    wanted.insert(wanted.end(), {0xE3, 0x07, 0x39, 0x4E});
    EXPECT_EQ(bytes_of(frame_of(ramp(), 0, Fcs::With)), wanted);
}

TEST(PictureFrames, ARowToTheByte)
{
    Bytes wanted = head;
    wanted.insert(wanted.end(), {0x00, 0x00, 0x01, 0x2B});
    for (int i = 0; i < 25; ++i)
        wanted.insert(wanted.end(), {0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF});
    EXPECT_EQ(bytes_of(frame_of(ramp(), 300)), wanted);
    // zlib.crc32 of these 217 bytes is 0xC3A10394.
    wanted.insert(wanted.end(), {0x94, 0x03, 0xA1, 0xC3});
    EXPECT_EQ(bytes_of(frame_of(ramp(), 300, Fcs::With)), wanted);
}

TEST(PictureFrames, RowsThatDoNotExistAreBlack)
{
    Bytes wanted = head;
    wanted.insert(wanted.end(), {0x00, 0x00, 0x01, 0x8F});
    wanted.insert(wanted.end(), 200, 0x00);
    wanted.insert(wanted.end(), {0xDF, 0x24, 0x69, 0xEE}); // by zlib
    EXPECT_EQ(bytes_of(frame_of(ramp(), 400, Fcs::With)), wanted);
}

/// Preamble, frame and check sequence at four clocks a byte, then the gap: what the first clocks
/// leave room for.
TEST(PictureFrames, TheTimesOfTheSource)
{
    const auto clocks = [](std::size_t frame_bytes) { return 4 * (8 + frame_bytes + fcs_bytes); };
    EXPECT_EQ(clocks(start_frame_bytes), 300U);
    EXPECT_EQ(clocks(row_frame_bytes), 916U);
    EXPECT_EQ(first_clock(0), 5U);
    EXPECT_EQ(first_clock(1), 370U);
    EXPECT_EQ(first_clock(2) - first_clock(1), clocks_a_row);
    EXPECT_EQ(first_clock(400) + clocks(row_frame_bytes), 392'705U);
}

TEST(PictureAssembler, PicturesComeBack)
{
    auto random = test::seeded_random();
    for (const Fcs fcs : {Fcs::Without, Fcs::With, Fcs::Without}) {
        const GreyPicture picture = random_picture(random);
        PictureAssembler assembler;
        take_all(assembler, all_frames(picture, fcs));
        EXPECT_TRUE(assembler.settled());
        EXPECT_TRUE(assembler.complete());
        EXPECT_EQ(assembler.picture(), picture);
        EXPECT_EQ(assembler.count(FrameFate::Start), 1U);
        EXPECT_EQ(assembler.count(FrameFate::Row), 300U);
        EXPECT_EQ(assembler.count(FrameFate::Beyond), 100U);
        EXPECT_TRUE(assembler.missing_rows().empty());
    }
}

TEST(PictureAssembler, IsSettledWithTheLastRowAndNotBefore)
{
    PictureAssembler assembler;
    for (std::size_t i = 0; i < 300; ++i)
        assembler.take(frame_of(ramp(), i).bytes());
    EXPECT_FALSE(assembler.complete());
    EXPECT_EQ(assembler.missing_rows(), std::vector<std::size_t>{299});
    EXPECT_EQ(assembler.take(frame_of(ramp(), 300).bytes()), FrameFate::Row);
    EXPECT_TRUE(assembler.settled());
}

TEST(PictureAssembler, NamesWhatIsLostAndLeavesItBlack)
{
    auto random = test::seeded_random();
    const GreyPicture picture = random_picture(random);
    std::vector<std::size_t> lost;
    GreyPicture wanted = picture;
    PictureAssembler assembler;
    for (std::size_t i = 0; i < export_frames; ++i) {
        const bool row = i > 0 && i <= export_size.height;
        if (row && random() % 4 == 0) {
            lost.push_back(i - 1);
            std::ranges::fill(wanted.row(i - 1), std::uint8_t{0});
            continue;
        }
        assembler.take(frame_of(picture, i).bytes());
    }
    EXPECT_FALSE(assembler.complete());
    EXPECT_EQ(assembler.missing_rows(), lost);
    EXPECT_EQ(assembler.picture(), wanted);
}

TEST(PictureAssembler, WithoutTheStartFrameThePictureIsThere)
{
    PictureAssembler assembler;
    for (std::size_t i = 1; i < export_frames; ++i)
        assembler.take(frame_of(ramp(), i).bytes());
    EXPECT_TRUE(assembler.settled());
    EXPECT_EQ(assembler.picture(), ramp());
}

TEST(PictureAssembler, DoubledRowsAreCountedAndDoNoHarm)
{
    PictureAssembler assembler;
    for (std::size_t i = 0; i < export_frames; ++i)
        for (std::size_t copies = i > 0 && i <= 7 ? 2 : 1; copies > 0; --copies)
            assembler.take(frame_of(ramp(), i).bytes());
    EXPECT_EQ(assembler.count(FrameFate::Doubled), 7U);
    EXPECT_EQ(assembler.count(FrameFate::Row), 300U);
    EXPECT_TRUE(assembler.settled());
    EXPECT_EQ(assembler.picture(), ramp());
}

TEST(PictureAssembler, TheOrderDoesNotMatter)
{
    auto random = test::seeded_random();
    std::vector<Bytes> frames = all_frames(ramp());
    for (int i = 0; i < 5; ++i) {
        std::ranges::shuffle(frames, random);
        PictureAssembler assembler;
        take_all(assembler, frames);
        EXPECT_TRUE(assembler.complete());
        EXPECT_EQ(assembler.picture(), ramp());
    }
}

/// One joins in the middle of an export, and it is repeated: the first half is of the second one.
TEST(PictureAssembler, APictureOfTwoIsNotSettled)
{
    auto random = test::seeded_random();
    const GreyPicture first = random_picture(random);
    const GreyPicture second = random_picture(random);
    PictureAssembler assembler;
    for (std::size_t i = 200; i < export_frames; ++i)
        assembler.take(frame_of(first, i).bytes());
    for (std::size_t i = 0; i < 200; ++i)
        assembler.take(frame_of(second, i).bytes());
    EXPECT_TRUE(assembler.complete());
    EXPECT_FALSE(assembler.settled());
    assembler.take(frame_of(second, 200).bytes()); // it came before the start, and now again
    EXPECT_EQ(assembler.missing_rows().size(), 100U);
    for (std::size_t i = 201; i < export_frames; ++i)
        assembler.take(frame_of(second, i).bytes());
    EXPECT_TRUE(assembler.settled());
    EXPECT_EQ(assembler.picture(), second);
}

TEST(PictureAssembler, AnIncompleteExportGivesWayToTheNext)
{
    auto random = test::seeded_random();
    const GreyPicture first = random_picture(random);
    const GreyPicture second = random_picture(random);
    PictureAssembler assembler;
    for (std::size_t i = 0; i < export_frames; ++i)
        if (i != 150)
            assembler.take(frame_of(first, i).bytes());
    EXPECT_FALSE(assembler.complete());
    take_all(assembler, all_frames(second));
    EXPECT_TRUE(assembler.settled());
    EXPECT_EQ(assembler.picture(), second);
}

TEST(PictureAssembler, ForeignFramesAreIgnored)
{
    PictureAssembler assembler;
    Bytes frame = bytes_of(frame_of(ramp(), 5));
    for (std::size_t i = 0; i < 12; ++i) {
        Bytes other = frame;
        other[i] ^= 0x01;
        EXPECT_EQ(assembler.take(other), FrameFate::Foreign) << "address byte " << i;
    }
    EXPECT_EQ(assembler.take({}), FrameFate::Foreign);
    EXPECT_EQ(assembler.take(std::span(frame).first(11)), FrameFate::Foreign);
    EXPECT_EQ(assembler.count(FrameFate::Foreign), 14U);
    EXPECT_EQ(assembler.missing_rows().size(), 300U);
}

/// As a switch puts it behind the addresses; a check sequence then covers it, too.
Bytes tagged(Bytes frame, const Bytes& tags, Fcs fcs = Fcs::Without)
{
    frame.insert(frame.begin() + 12, tags.begin(), tags.end());
    if (fcs == Fcs::With) {
        const std::uint32_t sequence =
            crc32({reinterpret_cast<const char*>(frame.data()), frame.size()});
        for (int shift = 0; shift < 32; shift += 8)
            frame.push_back(static_cast<std::uint8_t>(sequence >> shift));
    }
    return frame;
}

const std::vector<Bytes> tag_cases = {
    {0x81, 0x00, 0x00, 0x05},                         // 802.1Q
    {0x81, 0x00, 0xEF, 0xFF},                         // priority 7, network 4095
    {0x88, 0xA8, 0x00, 0x64},                         // 802.1ad
    {0x88, 0xA8, 0x00, 0x64, 0x81, 0x00, 0x00, 0x05}, // both
    {0x81, 0x00, 0x00, 0x01, 0x81, 0x00, 0x00, 0x02},
    {0x91, 0x00, 0x00, 0x01, 0x81, 0x00, 0x00, 0x02},
    {0x81, 0x00, 0x81, 0x00}, // the tag's number looks like a tag
};

TEST(PictureAssembler, TagsOfVirtualNetworksArePassedOver)
{
    for (const Bytes& tags : tag_cases)
        for (const Fcs fcs : {Fcs::Without, Fcs::With}) {
            PictureAssembler assembler;
            for (const Bytes& frame : all_frames(ramp()))
                assembler.take(tagged(frame, tags, fcs));
            EXPECT_TRUE(assembler.settled());
            EXPECT_EQ(assembler.picture(), ramp());
            EXPECT_EQ(assembler.count(FrameFate::Damaged), 0U);
        }
}

TEST(PictureAssembler, DamageBehindATagIsNoticed)
{
    for (const Bytes& tags : tag_cases) {
        PictureAssembler assembler;
        const Bytes good = tagged(bytes_of(frame_of(ramp(), 42)), tags, Fcs::With);
        for (std::size_t at = 12 + tags.size(); at < good.size(); ++at) {
            Bytes frame = good;
            frame[at] ^= 0x04;
            EXPECT_EQ(assembler.take(frame), FrameFate::Damaged) << at;
        }
        Bytes other = good;
        other[14] ^= 0x04; // of the tag itself
        EXPECT_EQ(assembler.take(other), FrameFate::Damaged);
        const Bytes plain = tagged(bytes_of(frame_of(ramp(), 42)), tags);
        for (std::size_t size = 14 + tags.size(); size < plain.size(); ++size)
            EXPECT_EQ(assembler.take(std::span(plain).first(size)), FrameFate::Damaged) << size;
        EXPECT_EQ(assembler.missing_rows().size(), 300U);
    }
}

/// Another protocol between the same addresses is no damage; a type that is one bit off is.
TEST(PictureAssembler, FramesOfOtherProtocolsAreForeign)
{
    PictureAssembler assembler;
    for (const Bytes& type : {Bytes{0x08, 0x00}, Bytes{0x08, 0x06}, Bytes{0x86, 0xDD},
                              Bytes{0x88, 0xCC}, Bytes{0x06, 0x00}})
        for (const std::size_t size : {60U, 64U, 128U, 1514U})
            for (const Bytes& tags : {Bytes{}, tag_cases.front(), tag_cases[3]}) {
                Bytes frame(head.begin(), head.begin() + 12);
                frame.insert(frame.end(), type.begin(), type.end());
                frame.resize(size);
                EXPECT_EQ(assembler.take(tagged(frame, tags)), FrameFate::Foreign);
            }
    EXPECT_EQ(assembler.count(FrameFate::Damaged), 0U);
    for (const std::size_t size : {13U, 14U, 15U, 16U}) { // cut within a tag
        Bytes frame = tagged(bytes_of(frame_of(ramp(), 1)), tag_cases.front());
        frame.resize(size);
        EXPECT_NE(assembler.take(frame), FrameFate::Row) << size;
    }
}

TEST(PictureAssembler, OnlyTheLengthsOfTheFormatAreTaken)
{
    for (const std::size_t index : {0U, 5U}) {
        Bytes frame = bytes_of(frame_of(ramp(), index));
        const std::size_t right = frame.size();
        frame.resize(1600);
        PictureAssembler assembler;
        for (std::size_t size = 12; size < frame.size(); ++size) {
            const FrameFate fate = assembler.take(std::span(frame).first(size));
            EXPECT_EQ(fate == FrameFate::Damaged, size != right) << size;
        }
    }
}

TEST(PictureAssembler, DamagedFramesAreRefused)
{
    PictureAssembler assembler;
    for (std::size_t at = 12; at < start_frame_bytes; ++at) { // type and data of a start frame
        Bytes frame = bytes_of(frame_of(ramp(), 0));
        frame[at] ^= 0x10;
        EXPECT_EQ(assembler.take(frame), FrameFate::Damaged) << at;
    }
    for (std::size_t at = 12; at < 16; ++at) { // type, and three bytes of a row's number
        Bytes frame = bytes_of(frame_of(ramp(), 5));
        frame[at] ^= 0x80;
        EXPECT_EQ(assembler.take(frame), FrameFate::Damaged) << at;
    }
    Bytes row = bytes_of(frame_of(ramp(), 400)); // row 399, the last there is
    EXPECT_EQ(assembler.take(row), FrameFate::Beyond);
    ++row[16]; // 400
    EXPECT_EQ(assembler.take(row), FrameFate::Damaged);
    EXPECT_EQ(assembler.missing_rows().size(), 300U);
}

TEST(PictureAssembler, AWrongCheckSequenceIsDamage)
{
    const Bytes good = bytes_of(frame_of(ramp(), 42, Fcs::With));
    PictureAssembler assembler;
    for (std::size_t at = 12; at < good.size(); ++at) {
        Bytes frame = good;
        frame[at] ^= 0x04;
        EXPECT_EQ(assembler.take(frame), FrameFate::Damaged) << at;
    }
    EXPECT_EQ(assembler.take(good), FrameFate::Row);
}

} // namespace
} // namespace raymarch::protocol
