// SPDX-License-Identifier: MIT
/// @file
/// The values of a STATUS reply are written by the table, in whatever order they are put.
#include "protocol/status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace raymarch::protocol
{
namespace
{

std::string written(const StatusValues& values)
{
    ReplyWriter reply;
    reply.begin(false);
    values.write(reply);
    return std::string(reply.text());
}

TEST(Status, TheOrderIsThatOfTheTable)
{
    StatusValues values;
    values.put(StatusKey::Applied, 18'446'744'073'709'551'615U);
    values.put(StatusKey::Fps, Tenths{248});
    values.put(StatusKey::Serial, "down");
    values.put(StatusKey::Logic, "");
    values.put(StatusKey::Accelerator, "marcher");
    EXPECT_EQ(written(values), " accelerator=marcher serial=down fps=24.8 logic="
                               " applied=18446744073709551615");
    EXPECT_EQ(written({}), "");
}

TEST(Status, CodesThatDidNotOccurAreLeftOut)
{
    std::array<std::uint64_t, error_count> counts{};
    StatusValues none;
    none.put_rejected(counts);
    EXPECT_EQ(written(none), " rejected=0");

    counts[static_cast<std::size_t>(ErrorCode::Range)] = 2;
    counts[static_cast<std::size_t>(ErrorCode::TooLong)] = 1;
    StatusValues some;
    some.put(StatusKey::Echoed, 7);
    some.put_rejected(counts);
    EXPECT_EQ(written(some), " rejected=3 echoed=7 rejected.TOO_LONG=1 rejected.RANGE=2");
}

TEST(Status, EachNameLeadsToItsRow)
{
    std::set<std::string_view> names;
    for (const StatusRow& row : status_rows) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
        EXPECT_EQ(find_status_row(row.name), &row);
    }
    EXPECT_EQ(find_status_row("rejected.SYNTAX"), &status_row(StatusKey::RejectedCode));
    EXPECT_EQ(find_status_row("reject"), nullptr);
    EXPECT_EQ(find_status_row(""), nullptr);
}

#ifndef NDEBUG
TEST(StatusDeathTest, AKeyIsPutOnceWithAValueOfItsRow)
{
    StatusValues values;
    values.put(StatusKey::Locked, "on");
    EXPECT_DEATH(values.put(StatusKey::Locked, "off"), "");
    EXPECT_DEATH(values.put(StatusKey::Serial, "sideways"), "");
    EXPECT_DEATH(values.put(StatusKey::Uptime, "long"), "");
}
#endif

} // namespace
} // namespace raymarch::protocol
