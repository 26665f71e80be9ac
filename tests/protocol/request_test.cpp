// SPDX-License-Identifier: MIT
#include "protocol/request.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

using Kind = Request::Kind;

struct KindRow
{
    std::string_view line;
    Kind kind;
    std::string_view text; ///< of the frame, or the words of the command
};

constexpr std::array kind_rows = {
    KindRow{"", Kind::Blank, ""},
    KindRow{" \t ", Kind::Blank, " \t "},
    KindRow{"FX=0,FY=1", Kind::Frame, "FX=0,FY=1"},
    KindRow{"  FX \t= 0 ", Kind::Frame, "FX \t= 0"},
    KindRow{"PING=1", Kind::Frame, "PING=1"}, // a key, whatever it says
    KindRow{"=1", Kind::Frame, "=1"},
    KindRow{",FX=0", Kind::Frame, ",FX=0"},
    KindRow{"PING", Kind::Command, ""},
    KindRow{" ping ", Kind::Command, ""},
    KindRow{"SET FX=0", Kind::Command, "FX=0"},
    KindRow{"SET,FX=0", Kind::Command, ",FX=0"},
    KindRow{"GET  fx , fy ", Kind::Command, "fx , fy"},
    KindRow{"GET", Kind::Command, ""},
};

TEST(Request, FramesAndCommandsAreToldApart)
{
    for (const KindRow& row : kind_rows) {
        const Request request = read_request({.bytes = row.line}, false);
        EXPECT_EQ(request.kind, row.kind) << "'" << row.line << "'";
        EXPECT_EQ(request.text.bytes, row.text) << "'" << row.line << "'";
        EXPECT_FALSE(request.checksummed) << "'" << row.line << "'";
    }
}

struct BadLine
{
    std::string_view line;
    ErrorCode code;
    std::size_t column;
};

constexpr std::array bad_lines = {
    BadLine{"NOPE", ErrorCode::UnknownCommand, 1},
    BadLine{"  nope 1", ErrorCode::UnknownCommand, 3},
    BadLine{"PI\x01NG", ErrorCode::BadByte, 3},
    BadLine{"PING\x7F", ErrorCode::BadByte, 5},
    BadLine{"\x80", ErrorCode::BadByte, 1},
    BadLine{"  \r", ErrorCode::BadByte, 3}, // not blank
    BadLine{"PING*11", ErrorCode::Checksum, 6},
    BadLine{"PING*1g", ErrorCode::Checksum, 6},
    BadLine{"PING*1G \t", ErrorCode::Checksum, 6}, // blanks behind the mark are dropped
    BadLine{"PI\x01NG*00", ErrorCode::BadByte, 3}, // judged before the checksum
    BadLine{"NOPE*00", ErrorCode::Checksum, 6},    // judged before the word
};

TEST(Request, TheFirstFaultWins)
{
    for (const BadLine& row : bad_lines) {
        const Request request = read_request({.bytes = row.line}, false);
        ASSERT_EQ(request.kind, Kind::Faulty) << row.line;
        EXPECT_EQ(request.fault.code, row.code) << row.line;
        EXPECT_EQ(request.fault.column, row.column) << row.line;
    }
}

TEST(Request, AnOverlongLineIsJudgedBeforeAnythingElse)
{
    const Request request = read_request({.bytes = {}, .too_long = true}, true);
    EXPECT_EQ(request.kind, Kind::Faulty);
    EXPECT_EQ(request.fault.code, ErrorCode::TooLong);
    EXPECT_FALSE(request.checksummed);
}

TEST(Request, EveryByteIsAllowedOrNot)
{
    for (int byte = 0; byte < 256; ++byte) {
        const std::string line = {'P', static_cast<char>(byte)};
        const Request request = read_request({.bytes = line}, false);
        const bool allowed = byte == '\t' || (byte >= 0x20 && byte <= 0x7E);
        EXPECT_EQ(request.fault.code == ErrorCode::BadByte, !allowed) << byte;
    }
}

TEST(Request, AMarkIsCutOffAndRemembered)
{
    for (const std::string_view line :
         {"PING*10", "PING*10 \t", "ping*10", " PING*30", "PING *30"}) {
        const Request request = read_request({.bytes = line}, true);
        EXPECT_EQ(request.kind, Kind::Command) << "'" << line << "'";
        EXPECT_TRUE(request.checksummed) << "'" << line << "'";
        EXPECT_TRUE(request.text.empty()) << "'" << line << "'";
    }
}

TEST(Request, HexDigitsOfAMarkHaveEitherCase)
{
    // 56 45 52 53 49 4F 4E xored
    EXPECT_EQ(read_request({.bytes = "VERSION*5A"}, false).kind, Kind::Command);
    EXPECT_EQ(read_request({.bytes = "VERSION*5a"}, false).kind, Kind::Command);
}

TEST(Request, AStarElsewhereIsAnOrdinaryCharacter)
{
    const Request request = read_request({.bytes = "GET*FX"}, false);
    EXPECT_EQ(request.kind, Kind::Faulty); // third byte from the end: a mark, and no hex
    EXPECT_EQ(request.fault.code, ErrorCode::Checksum);
    EXPECT_EQ(read_request({.bytes = "GET*FX,FY"}, false).fault.code, ErrorCode::UnknownCommand);
}

TEST(Request, AChecksumCanBeRequired)
{
    const Request without = read_request({.bytes = "PING"}, true);
    EXPECT_EQ(without.kind, Kind::Faulty);
    EXPECT_EQ(without.fault.code, ErrorCode::Checksum);
    EXPECT_EQ(read_request({.bytes = "PING*10"}, true).kind, Kind::Command);
    EXPECT_EQ(read_request({.bytes = "   "}, true).kind, Kind::Blank);
}

TEST(Request, CommandsHaveNamesOfTheirOwn)
{
    std::set<std::string_view> names;
    for (const CommandRow& row : commands) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(find_command(row.name), &row);
        EXPECT_FALSE(row.summary.empty()) << row.name;
    }
    for (const ErrorRow& row : errors)
        EXPECT_TRUE(names.insert(row.name).second) << row.name; // HELP finds both by name
}

} // namespace
} // namespace raymarch::protocol
