// SPDX-License-Identifier: MIT
#include "cli/reply_lines.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::cli
{
namespace
{

TEST(ReplyLines, AReplyBeginsWithAWordOfItsOwn)
{
    for (const std::string_view line : {"OK", "OK ZM=3", "OK*04", "ERR RANGE : x", "ERR"})
        EXPECT_TRUE(ends_reply(line)) << line;
    for (const std::string_view line :
         {"", "OKAY", "ok", " OK", "ERROR", "# OK", "PING", "K seq=1"})
        EXPECT_FALSE(ends_reply(line)) << line;
    EXPECT_TRUE(is_reply("# HELP"));
    EXPECT_FALSE(is_reply("HELP"));
    EXPECT_TRUE(is_err("ERR RANGE : x"));
    EXPECT_FALSE(is_err("OK"));
}

struct DueRow
{
    std::string_view bytes;
    std::size_t due;
};
using namespace std::string_view_literals;
constexpr std::array due_rows = {
    DueRow{"", 0},
    DueRow{"\r", 0},
    DueRow{" \t\r", 0},
    DueRow{"PING", 1},
    DueRow{"PING\r", 1},
    DueRow{"\0"sv, 1},
    DueRow{"# a comment", 0},
    DueRow{"OK", 0},
    DueRow{" ERR", 0},
    DueRow{"PING\rGET", 2},
    DueRow{"PING\r\nGET\r\n", 2},
    DueRow{"\r\r\rPING\r\r", 1},
};

TEST(ReplyLines, CountsTheRepliesThatAreDue)
{
    for (const DueRow& row : due_rows)
        EXPECT_EQ(replies_due(row.bytes), row.due) << testing::PrintToString(row.bytes);
}

TEST(ReplyLines, MarksAreWrittenAndTakenOff)
{
    EXPECT_EQ(with_mark("PING"), "PING*10");
    EXPECT_EQ(with_mark("OK"), "OK*04");
    EXPECT_EQ(without_mark("OK*04"), "OK");
    EXPECT_EQ(without_mark("OK*05"), "OK*05");
    EXPECT_EQ(without_mark("OK"), "OK");
    EXPECT_EQ(without_mark("*00"), "");
    EXPECT_TRUE(has_mark("PING*11  \t"));
    EXPECT_TRUE(has_right_mark("PING*10 "));
    EXPECT_FALSE(has_right_mark("PING*1G"));
    EXPECT_FALSE(has_mark("*0"));
    EXPECT_FALSE(has_mark(""));
}

TEST(ReplyLines, BytesOfAnyKindCanBeRead)
{
    EXPECT_EQ(visible("OK\xFF\0"sv), "OK\\xFF\\x00");
    EXPECT_EQ(visible(std::string(201, 'x')), std::string(200, 'x') + "... (201 bytes)");
}

} // namespace
} // namespace raymarch::cli
