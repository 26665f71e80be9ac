// SPDX-License-Identifier: MIT
/// @file
/// Plays the table files against a session, in whole rows and byte by byte: a failing row prints
/// its file and line.
#include "conformance/description_rows.hpp"
#include "conformance/table.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/service.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch
{
namespace
{

using conformance::Row;
using conformance::WordsCheck;

std::vector<std::string> split_replies(std::string_view text)
{
    std::vector<std::string> replies;
    while (!text.empty()) {
        const std::size_t end = text.find("\r\n");
        if (end == std::string_view::npos) {
            replies.push_back("without its ending: " + std::string(text));
            break;
        }
        replies.emplace_back(text.substr(0, end));
        text.remove_prefix(end + 2);
    }
    return replies;
}

std::string play(test::Service& service, const Row& row, std::size_t chunk)
{
    std::string replies;
    for (std::size_t at = 0; at < row.send.size(); at += chunk) {
        const std::string part = row.send.substr(at, chunk); // its own memory, gone after the call
        replies += service.say(part);
    }
    return replies;
}

void expect_replies(const Row& row, const std::string& text)
{
    const auto replies = split_replies(text);
    ASSERT_EQ(replies.size(), row.replies.size()) << "got: " << text;
    for (std::size_t i = 0; i < replies.size(); ++i)
        EXPECT_TRUE(conformance::match(row.replies[i], replies[i]))
            << "expected: " << row.replies[i] << "\n     got: " << replies[i];
}

void expect_words(const Row& row, const protocol::Words& before, const protocol::Words& after)
{
    if (row.words_check == WordsCheck::Same) {
        EXPECT_EQ(after, before) << "the words have changed";
    }
    if (row.words_check != WordsCheck::Exact)
        return;
    ASSERT_EQ(row.words.size(), after.size());
    EXPECT_TRUE(std::equal(row.words.begin(), row.words.end(), after.begin()))
        << "the words differ: " << testing::PrintToString(after);
}

void play_table(const std::string& name, std::size_t chunk)
{
    const std::string path = std::string(RAYMARCH_TEST_DATA "/data/") + name;
    const auto rows = conformance::parse_table(test::read_text(path));
    ASSERT_TRUE(rows) << path << ": " << rows.error().message;
    ASSERT_FALSE(rows->empty()) << path;

    test::Service service;
    service.controller.board_is_back(protocol::default_accelerator); // the board gets the defaults
    for (const Row& row : *rows) {
        const testing::ScopedTrace trace(path.c_str(), static_cast<int>(row.line), row.why);
        const protocol::Words before = service.board.words;
        const std::string replies = play(service, row, chunk);
        expect_replies(row, replies);
        expect_words(row, before, service.board.words);
    }
}

constexpr std::size_t whole = SIZE_MAX / 2;

class Tables : public testing::TestWithParam<std::string>
{};

TEST_P(Tables, RowByRow)
{
    play_table(GetParam(), whole);
}

TEST_P(Tables, ByteByByte)
{
    play_table(GetParam(), 1);
}

/// The name of the file, without its ending.
std::string name_of(const testing::TestParamInfo<std::string>& row)
{
    return row.param.substr(0, row.param.find('.'));
}

INSTANTIATE_TEST_SUITE_P(Protocol, Tables,
                         testing::Values("frames.tsv", "lines.tsv", "commands.tsv"), name_of);

class DescriptionRows : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, DescriptionRows, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(DescriptionRows, AreWhatTheServiceDoes)
{
    test::Service service({}, accelerator);
    service.controller.board_is_back(accelerator);
    const std::vector<Row> rows = conformance::description_rows(accelerator);
    ASSERT_GT(rows.size(), 4 * table.size());
    for (const Row& row : rows) {
        const testing::ScopedTrace trace(__FILE__, __LINE__, row.send + row.why);
        const protocol::Words before = service.board.words;
        expect_replies(row, play(service, row, whole));
        expect_words(row, before, service.board.words);
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
}

} // namespace
} // namespace raymarch
