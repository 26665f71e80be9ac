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

/// The definition: split at LF, drop one CR, at most 1024 bytes. An unfinished line is reported as
/// too long as soon as no ending can save it.
Lines reference(std::string_view bytes)
{
    Lines lines;
    for (std::size_t end = 0; (end = bytes.find('\n')) != std::string_view::npos;) {
        std::string_view line = bytes.substr(0, end);
        bytes.remove_prefix(end + 1);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        lines.push_back(line.size() > 1024 ? too_long : std::string(line));
    }
    if (bytes.size() > 1025 || (bytes.size() == 1025 && bytes.back() != '\r'))
        lines.push_back(too_long);
    return lines;
}

TEST(LineReader, LinesWithoutTheirEndings)
{
    EXPECT_EQ(lines_of("a\nb\r\n\n\r\nc\r\r\n\rd\n"), (Lines{"a", "b", "", "", "c\r", "\rd"}));
    EXPECT_EQ(lines_of("unfinished"), Lines{});
    EXPECT_EQ(lines_of(""), Lines{});
}

TEST(LineReader, TheLongestLineHas1024Bytes)
{
    const std::string longest(1024, 'x');
    EXPECT_EQ(lines_of(longest + "\n"), Lines{longest});
    EXPECT_EQ(lines_of(longest + "\r\n"), Lines{longest});
    EXPECT_EQ(lines_of(longest + "x\nb\n"), (Lines{too_long, "b"}));
    EXPECT_EQ(lines_of(longest + "x\r\nb\n"), (Lines{too_long, "b"}));
    EXPECT_EQ(lines_of(longest + "\r\r\nb\n"), (Lines{too_long, "b"}));
    EXPECT_EQ(lines_of(longest + "\rx\nb\n"), (Lines{too_long, "b"}));
}

TEST(LineReader, AnOverlongLineIsReportedOnceAndAtOnce)
{
    LineReader reader;
    Lines lines;
    feed(reader, std::string(1024, 'x') + "\r", lines);
    EXPECT_EQ(lines, Lines{}); // an LF would still make it a line
    feed(reader, "x", lines);
    EXPECT_EQ(lines, Lines{too_long});
    feed(reader, std::string(100'000, 'x'), lines);
    EXPECT_EQ(lines, Lines{too_long});
    feed(reader, "\nPING\n", lines);
    EXPECT_EQ(lines, (Lines{too_long, "PING"}));
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
    feed(reader, "a\nb\r", lines);
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
