// SPDX-License-Identifier: MIT
#include "drivers/pcap_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace raymarch::drivers
{
namespace
{

using Bytes = std::vector<std::uint8_t>;
using namespace std::chrono_literals;

/// The header after the magic: version 2.4, frames of up to 65535 bytes, Ethernet.
const Bytes low_header = {2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 1, 0, 0, 0};
const Bytes high_header = {0, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 1};

Bytes joined(std::initializer_list<Bytes> parts)
{
    Bytes all;
    for (const Bytes& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::string why_not(const Bytes& bytes)
{
    const auto reader = PcapReader::open(bytes, "some.pcap");
    if (reader)
        return "";
    EXPECT_EQ(reader.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(reader.error().message.starts_with("some.pcap "));
    return reader.error().message.substr(10);
}

TEST(PcapWriter, ToTheByte)
{
    PcapWriter writer;
    writer.add(Bytes{0xAA, 0xBB, 0xCC}, 7s + 19'620ns);
    const Bytes wanted = joined({
        {0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 0, 0},
        {7, 0, 0, 0, 19, 0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 0xAA, 0xBB, 0xCC},
    });
    EXPECT_TRUE(std::ranges::equal(writer.bytes(), wanted));
}

TEST(PcapReader, ReadsWhatIsWritten)
{
    PcapWriter writer;
    for (std::uint8_t i = 0; i < 5; ++i)
        writer.add(Bytes(i, i), i * 1us);
    auto reader = PcapReader::open(writer.bytes(), "some.pcap");
    ASSERT_TRUE(reader) << reader.error().message;
    for (std::uint8_t i = 0; i < 5; ++i) {
        const auto record = reader->next();
        ASSERT_TRUE(record && *record);
        EXPECT_TRUE(std::ranges::equal((*record)->frame, Bytes(i, i)));
        EXPECT_EQ((*record)->time, i * 1us);
    }
    EXPECT_EQ(reader->next().value().has_value(), false);
    EXPECT_EQ(reader->next().value().has_value(), false);
}

TEST(PcapReader, BothByteOrdersAndBothUnitsOfTime)
{
    struct Case
    {
        const char* what;
        Bytes magic;
        bool high_byte_first;
        std::chrono::nanoseconds time;
    };
    const std::vector<Case> cases = {
        {"low, micro", {0xD4, 0xC3, 0xB2, 0xA1}, false, 1s + 2us},
        {"high, micro", {0xA1, 0xB2, 0xC3, 0xD4}, true, 1s + 2us},
        {"low, nano", {0x4D, 0x3C, 0xB2, 0xA1}, false, 1s + 2ns},
        {"high, nano", {0xA1, 0xB2, 0x3C, 0x4D}, true, 1s + 2ns},
    };
    for (const Case& row : cases) {
        const Bytes low = {1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 99, 0, 0, 0}; // 3 of 99 bytes
        const Bytes high = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 99};
        const Bytes file = joined({row.magic,
                                   row.high_byte_first ? high_header : low_header,
                                   row.high_byte_first ? high : low,
                                   {7, 8, 9}});
        auto reader = PcapReader::open(file, "some.pcap");
        ASSERT_TRUE(reader) << row.what << ": " << reader.error().message;
        const auto record = reader->next();
        ASSERT_TRUE(record && *record) << row.what;
        EXPECT_TRUE(std::ranges::equal((*record)->frame, Bytes{7, 8, 9})) << row.what;
        EXPECT_EQ((*record)->time, row.time) << row.what;
    }
}

TEST(PcapReader, LateTimesDoNotWrap)
{
    const Bytes record(16, 0xFF); // 2^32 - 1 seconds; the lengths are wrong, too
    auto file = joined({{0xD4, 0xC3, 0xB2, 0xA1}, low_header, record});
    std::fill(file.begin() + 32, file.end(), std::uint8_t{0});
    auto reader = PcapReader::open(file, "some.pcap");
    ASSERT_TRUE(reader);
    const auto read = reader->next();
    ASSERT_TRUE(read && *read);
    EXPECT_EQ((*read)->time, 4'294'967'295s + 4'294'967'295us);
}

/// `tcpdump -s 96` writes such records.
TEST(PcapReader, TellsOfFramesThatWereCaughtInPart)
{
    const Bytes file = joined({{0xA1, 0xB2, 0xC3, 0xD4},
                               high_header,
                               {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 7, 8, 9},
                               {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 3, 7, 8, 9}});
    auto reader = PcapReader::open(file, "some.pcap");
    ASSERT_TRUE(reader);
    for (const bool cut : {true, false}) {
        const auto record = reader->next();
        ASSERT_TRUE(record && *record);
        EXPECT_EQ((*record)->cut, cut);
        EXPECT_TRUE(std::ranges::equal((*record)->frame, Bytes{7, 8, 9}));
    }
}

TEST(PcapReader, RefusesOtherFiles)
{
    const Bytes magic = {0xD4, 0xC3, 0xB2, 0xA1};
    EXPECT_EQ(why_not(joined({magic, low_header})), "");
    EXPECT_EQ(why_not({}), "is not a pcap file");
    EXPECT_EQ(why_not(magic), "is not a pcap file");
    EXPECT_EQ(why_not(Bytes(24, 'x')), "is not a pcap file");
    EXPECT_EQ(why_not({0x0A, 0x0D, 0x0D, 0x0A}),
              "is a pcapng file; editcap -F pcap makes a pcap file of it");
    Bytes wireless = joined({magic, low_header});
    wireless[20] = 105;
    EXPECT_EQ(why_not(wireless), "has frames of link type 105; Ethernet, which is 1, is needed");
    Bytes newer = joined({magic, low_header});
    newer[6] = 5;
    EXPECT_EQ(why_not(newer), "is a pcap file, but its version is not 2.4");
    EXPECT_EQ(why_not(joined({magic, high_header})), "is a pcap file, but its version is not 2.4");
}

/// The link type's upper half tells how long the check sequences are.
TEST(PcapReader, CheckSequencesMayBeAnnounced)
{
    Bytes file = joined({{0xD4, 0xC3, 0xB2, 0xA1}, low_header});
    file[23] = 0x44;
    EXPECT_EQ(why_not(file), "");
}

TEST(PcapReader, ACutOrDamagedRecordIsAnErrorAndTheEnd)
{
    PcapWriter writer;
    writer.add(Bytes(10, 1), 0ns);
    writer.add(Bytes(10, 2), 0ns);
    const Bytes whole(writer.bytes().begin(), writer.bytes().end());
    for (std::size_t size = 24 + 26 + 1; size < whole.size(); ++size) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        auto reader = PcapReader::open(cut, "some.pcap");
        ASSERT_TRUE(reader);
        EXPECT_TRUE(reader->next()) << "the first is whole";
        const auto second = reader->next();
        ASSERT_FALSE(second) << size;
        EXPECT_EQ(second.error().message, "some.pcap: the record at byte 50 is cut off");
        EXPECT_EQ(reader->next().value().has_value(), false);
    }
    Bytes damaged = whole;
    damaged[50 + 11] = 0x80; // the length's high byte
    auto reader = PcapReader::open(damaged, "some.pcap");
    ASSERT_TRUE(reader);
    EXPECT_TRUE(reader->next());
    const auto second = reader->next();
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("claims 2147483658 bytes"), std::string::npos);
}

} // namespace
} // namespace raymarch::drivers
