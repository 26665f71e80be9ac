// SPDX-License-Identifier: MIT
#include "protocol/unanswered.hpp"

#include <gtest/gtest.h>

namespace raymarch::protocol
{
namespace
{

TEST(Unanswered, BlankLinesAreNotAnswered)
{
    for (const std::string_view line : {"", " ", "\t", " \t \t "})
        EXPECT_FALSE(is_answered(line)) << '"' << line << '"';
}

TEST(Unanswered, LinesThatBeginLikeAReplyAreNotAnswered)
{
    for (const std::string_view line :
         {"OK", "OK*04", "OK seq=1 changed=7", "OKAY", "ERR", "ERR RANGE col=4 key=FX : allowed",
          "ERR TOO_LONG", "ERROR", "#", "# FX camera basis", "#FX=1", "  OK", "\tERR x", " # x",
          "OK \xFF"})
        EXPECT_FALSE(is_answered(line)) << '"' << line << '"';
}

TEST(Unanswered, AllOtherLinesAreAnswered)
{
    for (const std::string_view line :
         {"PING", "ok", "Ok", "err", "Err x", "O", "E", "ER", "FX=1", "*00", "x OK", "xOK",
          "PING # OK", "\r", "\x01", "1", "=", ","})
        EXPECT_TRUE(is_answered(line)) << '"' << line << '"';
}

} // namespace
} // namespace raymarch::protocol
