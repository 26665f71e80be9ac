// SPDX-License-Identifier: MIT
#include "protocol/echo_editor.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

/// What a person sees and what the service gets.
struct Typing
{
    std::string screen;
    std::vector<std::string> lines;
};

Typing type(EchoEditor& editor, std::string_view keys)
{
    Typing result;
    for (const char key : keys) {
        const Typed typed = editor.type(key);
        result.screen += typed.echo;
        if (typed.line_ended)
            result.lines.emplace_back(editor.line());
    }
    return result;
}

Typing type(std::string_view keys)
{
    EchoEditor editor;
    return type(editor, keys);
}

using Lines = std::vector<std::string>;

TEST(EchoEditor, EchoesAndEndsLines)
{
    const Typing typing = type("PING\rGET\n");
    EXPECT_EQ(typing.screen, "PING\r\nGET\r\n");
    EXPECT_EQ(typing.lines, (Lines{"PING", "GET"}));
}

TEST(EchoEditor, CrLfIsOneEnter)
{
    EXPECT_EQ(type("A\r\nB\r\n").lines, (Lines{"A", "B"}));
    EXPECT_EQ(type("A\r\n\n").lines, (Lines{"A", ""}));
    EXPECT_EQ(type("A\r\rB\n\r").lines, (Lines{"A", "", "B", ""}));
}

TEST(EchoEditor, BackspaceAndDeleteTakeBack)
{
    const Typing typing = type("PIX\bNH\x7FG\r");
    EXPECT_EQ(typing.screen, "PIX\b \bNH\b \bG\r\n");
    EXPECT_EQ(typing.lines, Lines{"PING"});
}

TEST(EchoEditor, NothingIsTakenBackFromAnEmptyLine)
{
    const Typing typing = type("\b\x7F"
                               "A\b\b\bB\r");
    EXPECT_EQ(typing.screen, "A\b \bB\r\n");
    EXPECT_EQ(typing.lines, Lines{"B"});
}

TEST(EchoEditor, WhatIsNotVisibleIsNotEchoedButStays)
{
    const Typing typing = type("A\x1B[\xC3\t\r");
    EXPECT_EQ(typing.screen, "A[\r\n");
    EXPECT_EQ(typing.lines, Lines{"A\x1B[\xC3\t"}); // the protocol says what is wrong with it
}

TEST(EchoEditor, TakingBackWhatIsNotVisibleMovesNothing)
{
    const Typing typing = type("A\x1B\b\bB\r");
    EXPECT_EQ(typing.screen, "A\b \bB\r\n"); // only the A was on the screen
    EXPECT_EQ(typing.lines, Lines{"B"});
}

TEST(EchoEditor, AnOverlongLineStaysOverlong)
{
    const Typing typing = type(std::string(3000, 'x') + "\r");
    ASSERT_EQ(typing.lines.size(), 1U);
    EXPECT_EQ(typing.lines[0].size(), max_line_length + 1);
    EXPECT_EQ(typing.screen.size(), max_line_length + 1 + 2); // the rest is dropped unseen
    EXPECT_EQ(type(std::string(1024, 'x') + "\r").lines[0].size(), 1024U);
}

TEST(EchoEditor, ResettingForgetsTheLine)
{
    EchoEditor editor;
    static_cast<void>(type(editor, "PI"));
    editor.reset();
    EXPECT_EQ(type(editor, "NG\r").lines, Lines{"NG"});
}

} // namespace
} // namespace raymarch::protocol
