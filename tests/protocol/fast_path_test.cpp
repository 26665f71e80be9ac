// SPDX-License-Identifier: MIT
/// @file
/// The fast path of pairs against the rules: a frame gets the same answer whether the fast path
/// takes its pairs or a blank before each of them, which the fast path does not take, leaves them
/// to the rules.
#include "protocol/assignments.hpp"
#include "protocol/reply.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

using Pairs = std::vector<std::string>;

std::string joined_pairs(const Pairs& pairs)
{
    std::string line;
    for (const std::string& pair : pairs)
        line += (line.empty() ? "" : ",") + pair;
    return line;
}

std::string with_blanks(std::string_view line)
{
    std::string result = " ";
    for (const char c : line) {
        result += c;
        if (c == ',')
            result += ' ';
    }
    return result;
}

class FastPath : public test::EveryAccelerator
{
  protected:
    /// Reads `line` from memory of its own, so that a sanitizer sees what is read beyond its end.
    [[nodiscard]] std::optional<Fault> read(std::string_view line, State& state) const
    {
        const auto copy = std::make_unique<char[]>(line.size()); // NOLINT(*-avoid-c-arrays)
        std::copy(line.begin(), line.end(), copy.get());
        auto fault = read_frame(accelerator, {.bytes = {copy.get(), line.size()}}, state);
        if (fault)
            fault->word = {}; // it points into the copy
        return fault;
    }

    /// Returns whether the frame was accepted, which it is both times or never.
    bool expect_same_answer(const std::string& line) const
    {
        State fast = initial_state(accelerator);
        State by_rules = fast;
        const auto fault = read(line, fast);
        const auto fault_by_rules = read(with_blanks(line), by_rules);
        EXPECT_EQ(fault.has_value(), fault_by_rules.has_value()) << line;
        if (fault && fault_by_rules) {
            EXPECT_EQ(fault->code, fault_by_rules->code) << line;
            EXPECT_EQ(fault->parameter, fault_by_rules->parameter) << line;
            EXPECT_EQ(fault->missing, fault_by_rules->missing) << line;
            // Each comma before the fault has brought one blank more, and so has the first pair.
            const auto end = line.begin() + static_cast<std::ptrdiff_t>(
                                                std::min(fault->column, line.size() + 1) - 1);
            const auto commas = static_cast<std::size_t>(std::count(line.begin(), end, ','));
            EXPECT_EQ(fault->column == 0 ? 0 : fault->column + commas + 1, fault_by_rules->column)
                << line;
        } else {
            EXPECT_EQ(fast, by_rules) << line;
        }
        return !fault;
    }

    /// The pairs of a whole frame of the defaults, as GET writes them.
    [[nodiscard]] Pairs default_pairs() const
    {
        ReplyWriter reply;
        write_state(reply, accelerator, initial_state(accelerator));
        Pairs pairs;
        Text rest{.bytes = reply.text()};
        for (bool more = true; more;) {
            const Piece piece = take_until(rest, ',');
            more = piece.found;
            pairs.emplace_back(piece.text.bytes);
        }
        return pairs;
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, FastPath, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(FastPath, ReadsPairsInAnyOrder)
{
    auto random = test::seeded_random();
    Pairs pairs = default_pairs();
    EXPECT_TRUE(expect_same_answer(joined_pairs(pairs)));
    for (int round = 0; round < 200; ++round) {
        std::ranges::shuffle(pairs, random);
        EXPECT_TRUE(expect_same_answer(joined_pairs(pairs)));
    }
}

/// All texts of up to four of these characters, as the value of each of the first parameters, in
/// the middle of a line and at its end.
TEST_P(FastPath, ReadsEveryShortSpelling)
{
    std::vector<std::string> spellings = {""};
    for (std::size_t begin = 0, length = 1; length <= 4; ++length)
        for (const std::size_t end = spellings.size(); begin < end; ++begin)
            for (const char c : std::string_view("019.-+="))
                spellings.push_back(spellings[begin] + c);
    const Pairs defaults = default_pairs();
    std::size_t accepted = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(defaults.size(), 20); ++i) {
        const std::string key = defaults[i].substr(0, defaults[i].find('=') + 1);
        for (const std::string& spelling : spellings) {
            Pairs pairs = defaults;
            pairs[i] = key + spelling;
            if (spelling.size() == 2)
                std::swap(pairs[i], pairs.back());
            accepted += expect_same_answer(joined_pairs(pairs)) ? 1 : 0;
        }
    }
    EXPECT_GT(accepted, 100U);
}

/// Up to four bytes of a good frame are changed, left out or put in; or two pairs are the same.
TEST_P(FastPath, GivesTheSameAnswerToDamagedFrames)
{
    constexpr std::string_view alphabet = "0123456789.-+eE,=FXRGBOJobjspherecutnlif_\x7f\x01\xff*";
    auto random = test::seeded_random();
    const auto any = [&](std::size_t below) {
        return test::pick<std::size_t>(random, 0, below - 1);
    };
    const Pairs defaults = default_pairs();
    Pairs pairs = defaults;
    std::size_t accepted = 0;
    for (int round = 0; round < 4'000; ++round) {
        if (round % 4 == 0)
            std::ranges::shuffle(pairs, random);
        else if (round % 4 == 1)
            pairs = defaults;
        else if (round % 64 == 2)
            pairs[any(pairs.size())] = pairs[any(pairs.size())];
        std::string line = joined_pairs(pairs);
        for (std::size_t changes = any(4); changes > 0; --changes) {
            const std::size_t at = any(line.size());
            switch (any(3)) {
            case 0:
                line[at] = alphabet[any(alphabet.size())];
                break;
            case 1:
                line.erase(at, 1);
                break;
            default:
                line.insert(at, 1, alphabet[any(alphabet.size())]);
            }
        }
        accepted += expect_same_answer(line) ? 1 : 0;
    }
    EXPECT_GT(accepted, 100U);
}

} // namespace
} // namespace raymarch::protocol
