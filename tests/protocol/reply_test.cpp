// SPDX-License-Identifier: MIT
#include "protocol/reply.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/checksum.hpp"
#include "protocol/commands.hpp"
#include "protocol/help.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

/// The lines of a reply; fails when one does not end in CR LF.
std::vector<std::string> lines_of(const ReplyWriter& reply)
{
    EXPECT_FALSE(reply.overflowed());
    std::vector<std::string> lines;
    std::string_view rest = reply.text();
    while (!rest.empty()) {
        const std::size_t end = rest.find("\r\n");
        if (end == std::string_view::npos) {
            ADD_FAILURE() << "a line without its ending: " << rest;
            break;
        }
        lines.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end + 2);
    }
    return lines;
}

std::string fault_text(const Fault& fault)
{
    ReplyWriter reply;
    write_fault(reply, accelerator, fault);
    const auto lines = lines_of(reply);
    return lines.size() == 1 ? lines.front() : "not one line";
}

TEST(Reply, LinesEndInCrLf)
{
    ReplyWriter reply;
    reply.begin(false);
    reply << "OK seq=" << std::uint64_t{18446744073709551615U} << ' ';
    reply.hex(0x0012ABCF);
    reply.end_line();
    EXPECT_EQ(reply.text(), "OK seq=18446744073709551615 0012ABCF\r\n");
}

TEST(Reply, EachLineOfAChecksummedReplyHasItsOwnMark)
{
    ReplyWriter reply;
    reply.begin(true);
    reply << "# a";
    reply.end_line();
    reply << "OK";
    reply.end_line();
    EXPECT_EQ(reply.text(), "# a*62\r\nOK*04\r\n"); // 23 xor 20 xor 61; 4F xor 4B
}

TEST(Reply, BeginningAgainForgetsEverything)
{
    ReplyWriter reply;
    reply.begin(true);
    reply << std::string(10'000, 'x');
    EXPECT_TRUE(reply.overflowed());
    reply.begin(false);
    EXPECT_FALSE(reply.overflowed());
    reply << "OK";
    reply.end_line();
    EXPECT_EQ(reply.text(), "OK\r\n");
}

TEST(Reply, TextBeyondTheBufferIsCutOff)
{
    ReplyWriter reply;
    reply.begin(false);
    for (int i = 0; i < 1000; ++i)
        reply << "0123456789";
    EXPECT_TRUE(reply.overflowed());
    EXPECT_TRUE(std::string(10'000, ' ').size() > reply.text().size());
    EXPECT_TRUE(reply.text().starts_with("01234567890123456789"));
}

TEST(Reply, AFaultSaysCodeColumnKeyAndWhatIsAllowed)
{
    EXPECT_EQ(fault_text({.code = ErrorCode::Range, .column = 4, .parameter = marcher::ZM}),
              "ERR RANGE col=4 key=ZM : ZM is a number 0 to 10 units");
    EXPECT_EQ(fault_text({.code = ErrorCode::Number, .column = 12, .parameter = marcher::FX}),
              "ERR NUMBER col=12 key=FX : FX is a number -1 to 1");
    EXPECT_EQ(fault_text({.code = ErrorCode::Object, .column = 5, .parameter = marcher::OBJ}),
              "ERR OBJECT col=5 key=OBJ : OBJ is sphere, cube, infinite_cube, tunnel or 0 to 3");
    EXPECT_TRUE(fault_text({.code = ErrorCode::UnknownKey, .column = 1, .word = "qx"})
                    .starts_with("ERR UNKNOWN_KEY col=1 key=QX : "));
    EXPECT_TRUE(fault_text({.code = ErrorCode::DuplicateKey, .column = 9, .parameter = marcher::R})
                    .starts_with("ERR DUPLICATE_KEY col=9 key=R : "));
    EXPECT_TRUE(fault_text({.code = ErrorCode::UnknownCommand, .column = 3, .word = "nope"})
                    .starts_with("ERR UNKNOWN_COMMAND col=3 : "));
    EXPECT_TRUE(fault_text({.code = ErrorCode::Hardware}).starts_with("ERR HARDWARE : "));
    EXPECT_EQ(fault_text({.code = ErrorCode::Argument, .column = 6, .allowed = "one word"}),
              "ERR ARGUMENT col=6 : one word");
}

TEST(Reply, AnUnknownWordIsRepeatedUpTo32Bytes)
{
    const std::string longest(32, 'q');
    EXPECT_NE(fault_text({.code = ErrorCode::UnknownKey, .column = 1, .word = longest})
                  .find("key=" + std::string(32, 'Q') + " : "),
              std::string::npos);
    const std::string longer(33, 'q');
    EXPECT_EQ(fault_text({.code = ErrorCode::UnknownKey, .column = 1, .word = longer}).find("key="),
              std::string::npos);
}

TEST(Reply, MissingKeysAreNamedInTableOrder)
{
    Fault fault{.code = ErrorCode::MissingKey};
    fault.missing.set(marcher::OBJ).set(marcher::FY);
    EXPECT_TRUE(fault_text(fault).starts_with("ERR MISSING_KEY key=FY,OBJ : "))
        << fault_text(fault);
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        fault.missing.set(i);
    EXPECT_TRUE(fault_text(fault).starts_with(
        "ERR MISSING_KEY key=FX,FY,FZ,RX,RY,RZ,UX,UY,UZ,ZM,LX,LY,LZ,R,G,B,OBJ : "))
        << fault_text(fault);
}

TEST(Reply, EveryCodeHasASentence)
{
    for (const ErrorRow& row : errors) {
        const std::string text = fault_text({.code = row.code});
        EXPECT_TRUE(text.starts_with("ERR " + std::string(row.name) + " : ")) << text;
        EXPECT_GT(text.size(), row.name.size() + 10) << text;
    }
}

TEST(Reply, TheStateIsAFrame)
{
    ReplyWriter reply;
    reply.begin(false);
    write_state(reply, accelerator, initial_state(accelerator));
    EXPECT_EQ(reply.text(), "FX=0,FY=0,FZ=0.99999,RX=0.99999,RY=0,RZ=0,UX=0,UY=0.99999,UZ=0,ZM=3,"
                            "LX=3,LY=2,LZ=5,R=0.999,G=0.999,B=0.999,OBJ=sphere");
    State back;
    EXPECT_FALSE(read_frame(accelerator, {.bytes = reply.text()}, back));
    EXPECT_EQ(back, initial_state(accelerator));
}

TEST(Reply, TheWordsAreEightHexDigitsEach)
{
    ReplyWriter reply;
    reply.begin(false);
    reply << "OK";
    write_words(reply, accelerator, pack(accelerator, initial_state(accelerator)));
    EXPECT_EQ(reply.text(),
              "OK 01804028 03000000 00000000 07FFFFFF 7FFFC000 000003FF 00001FFF F00003FF");
}

class Replies : public test::EveryAccelerator
{
  protected:
    /// The lines that HELP says about `word`, all of them fit for a terminal.
    void expect_help_lines(std::string_view word) const
    {
        ReplyWriter reply;
        reply.begin(true);
        EXPECT_TRUE(write_help(reply, accelerator, word)) << word;
        const auto lines = lines_of(reply);
        EXPECT_FALSE(lines.empty()) << word;
        for (const std::string& line : lines) {
            EXPECT_TRUE(line.starts_with("# ")) << line;
            EXPECT_TRUE(std::ranges::all_of(line, [](char c) { return c >= 0x20 && c <= 0x7E; }))
                << line;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, Replies, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Replies, HelpFitsTheBuffer)
{
    ReplyWriter reply;
    reply.begin(true);
    ASSERT_TRUE(write_help(reply, accelerator, ""));
    reply << "OK";
    reply.end_line();
    EXPECT_FALSE(reply.overflowed());
}

TEST_P(Replies, HelpKnowsEveryCommandParameterAndCode)
{
    expect_help_lines("");
    for (const CommandRow& row : commands)
        expect_help_lines(row.name);
    for (const Parameter& parameter : table) {
        if (!parameter.is_tail())
            expect_help_lines(parameter.key);
    }
    for (const ErrorRow& row : errors)
        expect_help_lines(row.name);
    expect_help_lines("view"); // any case
}

TEST_P(Replies, HelpNamesEachGroupOnce)
{
    ReplyWriter reply;
    reply.begin(false);
    ASSERT_TRUE(write_help(reply, accelerator, "RESET"));
    std::string line = lines_of(reply).back() + " ";
    ASSERT_TRUE(line.starts_with("# GROUP is ")) << line;
    std::set<std::string_view> groups;
    for (const Parameter& parameter : table)
        groups.insert(parameter.group);
    std::size_t length = std::string_view("# GROUP is ").size();
    for (const std::string_view group : groups) {
        EXPECT_NE(line.find(" " + std::string(group) + " "), std::string::npos) << group;
        length += group.size() + 1;
    }
    EXPECT_EQ(line.size(), length) << line;
}

TEST_P(Replies, HelpNamesEachKeyOfAFrame)
{
    ReplyWriter reply;
    reply.begin(false);
    ASSERT_TRUE(write_help(reply, accelerator, ""));
    std::string first = lines_of(reply).front();
    std::ranges::replace(first, ';', ' ');
    for (const Parameter& parameter : table) {
        if (!parameter.is_row() && !parameter.is_tail()) {
            EXPECT_NE(first.find(" " + std::string(parameter.key) + " "), std::string::npos)
                << parameter.key;
        }
    }
}

/// The most characters that a value of `parameter` has.
std::size_t longest_value(const Parameter& parameter)
{
    if (parameter.is_choice())
        return std::ranges::max(parameter.choices, {}, &std::string_view::size).size();
    const auto whole = [](std::string_view text) { return text.substr(0, text.find('.')).size(); };
    const std::size_t places = parameter.format.fraction_bits * 3U / 10 + 2; // log10(2) is 0.301
    return std::max(whole(parameter.min), whole(parameter.max)) + 1 +
           (parameter.format.fraction_bits == 0 ? 0 : places);
}

TEST_P(Replies, TheLongestStateFitsTheBuffer)
{
    std::size_t longest = std::string_view("OK *00\r\n").size();
    for (const Parameter& parameter : table) {
        if (parameter.is_tail())
            continue;
        EXPECT_LE(longest_value(parameter), max_number_length) << parameter.key;
        longest += parameter.key.size() + 1 + longest_value(parameter) + 1; // KEY=VALUE,
    }
    ReplyWriter reply;
    reply.begin(true);
    reply << std::string(longest, 'x');
    EXPECT_FALSE(reply.overflowed()) << longest;
}

TEST_P(Replies, FaultsFitTheBuffer)
{
    ReplyWriter reply;
    reply.begin(true);
    Fault everything{.code = ErrorCode::MissingKey};
    for (std::size_t i = 0; i < table.size(); ++i)
        everything.missing.set(i, accelerator.frame[i]);
    write_fault(reply, accelerator, everything);
    write_fault(reply, accelerator,
                {.code = ErrorCode::UnknownKey, .column = 1000, .word = std::string(32, 'q')});
    EXPECT_EQ(lines_of(reply).size(), 2U);
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_tail())
            continue;
        reply.begin(true);
        const auto code = table[i].is_choice() ? ErrorCode::Object : ErrorCode::Range;
        write_fault(reply, accelerator,
                    {.code = code, .column = 5, .parameter = static_cast<ParameterIndex>(i)});
        const auto lines = lines_of(reply);
        ASSERT_EQ(lines.size(), 1U);
        const std::string key(table[i].key);
        EXPECT_NE(lines[0].find(" col=5 key=" + key + " : " + key + " is "), std::string::npos)
            << lines[0];
    }
}

TEST_P(Replies, MissingKeysAreThoseOfTheFrame)
{
    State state = initial_state(accelerator);
    const auto fault = read_frame(accelerator, {.bytes = test::default_pair(table[0])}, state);
    ASSERT_TRUE(fault);
    ReplyWriter reply;
    reply.begin(false);
    write_fault(reply, accelerator, *fault);
    std::string expected = "ERR MISSING_KEY";
    std::string_view separator = " key=";
    for (std::size_t i = 1; i < table.size(); ++i) {
        if (!accelerator.frame[i])
            continue;
        expected += std::string(separator) + std::string(table[i].key);
        separator = ",";
    }
    EXPECT_TRUE(reply.text().starts_with(expected + " : ")) << reply.text();
}

TEST_P(Replies, AsManyWordsAsTheAcceleratorHas)
{
    ReplyWriter reply;
    reply.begin(false);
    write_words(reply, accelerator, pack(accelerator, initial_state(accelerator)));
    EXPECT_FALSE(reply.overflowed());
    EXPECT_EQ(reply.text().size(), std::size_t{9} * accelerator.word_count);
}

TEST(Help, SaysNothingOfOtherWords)
{
    ReplyWriter reply;
    reply.begin(false);
    EXPECT_FALSE(write_help(reply, accelerator, "nothing"));
    EXPECT_TRUE(reply.text().empty());
}

TEST(Help, AllOfItNamesEachCommandAndKey)
{
    ReplyWriter reply;
    reply.begin(false);
    ASSERT_TRUE(write_help(reply, accelerator, ""));
    for (const CommandRow& row : commands)
        EXPECT_NE(reply.text().find("# " + std::string(row.name)), std::string_view::npos)
            << row.name;
    EXPECT_NE(reply.text().find("FX FY FZ RX RY RZ UX UY UZ ZM LX LY LZ R G B OBJ"),
              std::string_view::npos);
    EXPECT_NE(reply.text().find("# GROUP is camera light colour object\r\n"),
              std::string_view::npos);
}

} // namespace
} // namespace raymarch::protocol
