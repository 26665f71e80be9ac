// SPDX-License-Identifier: MIT
#include "protocol/line_reader.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

using Lines = std::vector<std::string>;
const std::string too_long = "<too long>";

void feed(LineReader& reader, std::string_view bytes, Lines& lines)
{
    while (const auto line = reader.next(bytes))
        lines.push_back(line->too_long ? too_long : std::string(line->bytes));
    EXPECT_TRUE(bytes.empty());
}

Lines lines_of(std::string_view bytes)
{
    LineReader reader;
    Lines lines;
    feed(reader, bytes, lines);
    return lines;
}

Lines lines_of_chunks(std::string_view bytes, std::mt19937_64& random, std::size_t longest)
{
    LineReader reader;
    Lines lines;
    while (!bytes.empty()) {
        // A copy of its own for each chunk: a view that outlives its chunk is found by the
        // sanitizer.
        const std::string chunk(bytes.substr(0, test::pick(random, std::size_t{1}, longest)));
        bytes.remove_prefix(chunk.size());
        feed(reader, chunk, lines);
    }
    return lines;
}

/// The definition: LF, CR and CR LF end a line of at most 1024 bytes. An unfinished line is
/// reported as too long as soon as it is.
Lines reference(std::string_view bytes)
{
    Lines lines;
    std::string line;
    const auto shown = [&] { return line.size() > 1024 ? too_long : line; };
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] == '\n' && i > 0 && bytes[i - 1] == '\r')
            continue;
        if (bytes[i] != '\n' && bytes[i] != '\r') {
            line += bytes[i];
            continue;
        }
        lines.push_back(shown());
        line.clear();
    }
    if (line.size() > 1024)
        lines.push_back(too_long);
    return lines;
}

TEST(LineReader, LinesWithoutTheirEndings)
{
    EXPECT_EQ(lines_of("a\nb\r\nc\rd\n"), (Lines{"a", "b", "c", "d"}));
    EXPECT_EQ(lines_of("\n\r\n\r\r\r\n\n"), (Lines{"", "", "", "", "", ""}));
    EXPECT_EQ(lines_of("a\n\rb\r"), (Lines{"a", "", "b"}));
    EXPECT_EQ(lines_of("unfinished"), Lines{});
    EXPECT_EQ(lines_of(""), Lines{});
}

/// Enter of most terminal programs is a CR alone; it is not known yet whether an LF follows.
TEST(LineReader, ACarriageReturnEndsALineAtOnce)
{
    LineReader reader;
    Lines lines;
    feed(reader, "PING\r", lines);
    EXPECT_EQ(lines, Lines{"PING"});
    EXPECT_TRUE(reader.after_cr());
    feed(reader, "\n", lines);
    EXPECT_EQ(lines, Lines{"PING"});
    feed(reader, "\nPING\r", lines);
    EXPECT_EQ(lines, (Lines{"PING", "", "PING"}));
    feed(reader, "\r", lines);
    EXPECT_EQ(lines, (Lines{"PING", "", "PING", ""}));
}

TEST(LineReader, TheLongestLineHas1024Bytes)
{
    const std::string longest(1024, 'x');
    for (const std::string ending : {"\n", "\r\n", "\r"}) {
        EXPECT_EQ(lines_of(longest + ending), Lines{longest});
        EXPECT_EQ(lines_of(longest + ending + "b\n"), (Lines{longest, "b"}));
        EXPECT_EQ(lines_of(longest + "x" + ending + "b\n"), (Lines{too_long, "b"}));
        EXPECT_EQ(lines_of(longest + longest + ending + "b\n"), (Lines{too_long, "b"}));
    }
}

TEST(LineReader, AnOverlongLineIsReportedOnceAndAtOnce)
{
    LineReader reader;
    Lines lines;
    feed(reader, std::string(1024, 'x'), lines);
    EXPECT_EQ(lines, Lines{}); // an ending would still make it a line
    feed(reader, "x", lines);
    EXPECT_EQ(lines, Lines{too_long});
    feed(reader, std::string(100'000, 'x'), lines);
    EXPECT_EQ(lines, Lines{too_long});
    feed(reader, "\rPING\n", lines);
    EXPECT_EQ(lines, (Lines{too_long, "PING"}));
}

TEST(LineReader, AnOverlongLineKeepsItsFirstBytes)
{
    LineReader reader;
    const std::string text = "OK " + std::string(2000, 'x');
    std::string_view bytes = text;
    const auto line = reader.next(bytes);
    ASSERT_TRUE(line && line->too_long);
    EXPECT_EQ(line->bytes, text.substr(0, 1024));
}

TEST(LineReader, AnyChunkingGivesTheSameLines)
{
    auto random = test::seeded_random();
    for (int round = 0; round < 300; ++round) {
        std::string bytes;
        for (int i = test::pick(random, 1, 20); i > 0; --i) {
            // Lengths crowd around the limit; a byte is anything, endings and zeros included.
            const int length = test::pick(random, 0, 1) ? test::pick(random, 0, 12)
                                                        : test::pick(random, 1020, 1030);
            for (int j = 0; j < length; ++j)
                bytes += test::pick(random, 0, 200) == 0
                             ? "\r\n\0"[test::pick(random, 0, 2)]
                             : static_cast<char>(test::pick(random, 0, 255));
            bytes += std::array{"\n", "\r\n", "\r\r\n",
                                "\r"}[test::pick(random, std::size_t{0}, std::size_t{3})];
        }
        const Lines expected = reference(bytes);
        ASSERT_EQ(lines_of(bytes), expected);
        ASSERT_EQ(lines_of_chunks(bytes, random, 1), expected);
        ASSERT_EQ(lines_of_chunks(bytes, random, 7), expected);
        ASSERT_EQ(lines_of_chunks(bytes, random, 1100), expected);
    }
}

TEST(LineReader, TheEndOfAFileCompletesALine)
{
    LineReader reader;
    Lines lines;
    feed(reader, "a\nb", lines);
    const auto last = reader.finish();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->bytes, "b");
    EXPECT_FALSE(reader.finish());
}

TEST(LineReader, TheEndOfAFileEndsAnOverlongLineWithoutAnother)
{
    LineReader reader;
    Lines lines;
    feed(reader, std::string(2000, 'x'), lines);
    EXPECT_EQ(lines, Lines{too_long});
    EXPECT_FALSE(reader.finish());
    feed(reader, "PING\n", lines);
    EXPECT_EQ(lines, (Lines{too_long, "PING"}));
}

TEST(LineReader, ResettingForgetsAnUnfinishedLine)
{
    LineReader reader;
    Lines lines;
    feed(reader, "PI", lines);
    EXPECT_EQ(reader.pending(), 2U);
    reader.reset();
    EXPECT_EQ(reader.pending(), 0U);
    feed(reader, "NG\n", lines);
    feed(reader, std::string(2000, 'x'), lines);
    reader.reset();
    feed(reader, "PING\n", lines);
    EXPECT_EQ(lines, (Lines{"NG", too_long, "PING"}));
}

} // namespace
} // namespace raymarch::protocol
