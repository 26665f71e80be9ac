// SPDX-License-Identifier: MIT
/// @file
/// The short way against the definition: whatever it takes, it reads as quantize() and the long way
/// do; and a frame gets the same answer whether it is tried or not.
#include "protocol/frame_lanes.hpp"

#include "protocol/assignments.hpp"
#include "protocol/quantizer.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

constexpr std::span<const Parameter> table = accelerator.parameters;
constexpr std::size_t size = marcher::parameters.size();
constexpr std::size_t numbers = marcher::OBJ;
constexpr std::string_view original =
    "FX=0.000,FY=0.000,FZ=1.000,RX=1.000,RY=0.000,RZ=0.000,UX=0.000,UY=1.000,UZ=0.000,"
    "ZM=3.00,LX=3.000,LY=2.000,LZ=5.000,R=1.000,G=1.000,B=1.000,OBJ=sphere";

using Values = std::vector<std::string>;

Values original_values()
{
    Values values;
    Text rest{.bytes = original};
    for (bool more = true; more;) {
        const Piece pair = take_until(rest, ',');
        more = pair.found;
        values.emplace_back(pair.text.bytes.substr(pair.text.bytes.find('=') + 1));
    }
    return values;
}

/// The pairs in the order of `indices`.
std::string line_of(const Values& values, const std::vector<std::size_t>& indices)
{
    std::string line;
    for (const std::size_t i : indices)
        line += (line.empty() ? "" : ",") + std::string(table[i].key) + "=" + values[i];
    return line;
}

std::vector<std::size_t> table_order()
{
    std::vector<std::size_t> indices(size);
    for (std::size_t i = 0; i < size; ++i)
        indices[i] = i;
    return indices;
}

/// In memory of its own, so that a sanitizer sees what is read beyond its ends.
bool by_lanes(const std::string& line, State& state)
{
    const auto copy = std::make_unique<char[]>(line.size()); // NOLINT(*-avoid-c-arrays)
    std::copy(line.begin(), line.end(), copy.get());
    return accelerator.read_frame_by_lanes({copy.get(), line.size()}, state);
}

/// Both ways, from the same state: the same fault or the same codes. Whether the short way took it.
bool expect_same_answer(const std::string& line)
{
    State by_pairs = initial_state(accelerator);
    State taken = by_pairs;
    State either = by_pairs;
    const auto fault = read_frame_by_pairs(accelerator, {.bytes = line}, by_pairs);
    const bool is_taken = by_lanes(line, taken);
    const auto answer = read_frame(accelerator, {.bytes = line}, either);
    EXPECT_EQ(fault.has_value(), answer.has_value()) << line;
    if (fault && answer) {
        EXPECT_FALSE(is_taken) << line;
        EXPECT_EQ(answer->code, fault->code) << line;
        EXPECT_EQ(answer->column, fault->column) << line;
        EXPECT_EQ(answer->parameter, fault->parameter) << line;
        EXPECT_EQ(answer->word, fault->word) << line;
        EXPECT_EQ(answer->missing, fault->missing) << line;
    } else {
        EXPECT_EQ(either, by_pairs) << line;
        EXPECT_TRUE(!is_taken || taken == by_pairs) << line;
    }
    return is_taken;
}

class FrameLanesOfTheMarcher : public testing::Test
{
  protected:
    void SetUp() override
    {
        if (!has_frame_lanes())
            GTEST_SKIP() << "this processor has no vectors for it";
    }
};

TEST(FrameLanesOfTables, AreThereWhereTheTableAllowsThem)
{
    EXPECT_NE(marcher::description.read_frame_by_lanes, nullptr);
    EXPECT_EQ(marcher::frame_lanes.size, size);
    EXPECT_EQ(marcher::frame_lanes.numbers, numbers);
    // Keys of more than seven letters, choices before numbers, numbers of more than 64 bits.
    EXPECT_EQ(frame_lanes_of(fractal::parameters).size, 0U);
    EXPECT_EQ(frame_lanes_of(sphere::parameters).size, 0U);
    EXPECT_EQ(frame_lanes_of(mandelbulb::parameters).size, 0U);
    EXPECT_EQ(frame_lanes_of(whitted::parameters).size, 0U);
}

TEST_F(FrameLanesOfTheMarcher, TakeTheOriginalFrame)
{
    EXPECT_TRUE(expect_same_answer(std::string(original)));
}

/// Sixteen numbers a frame, each anywhere from beyond one end of its range to beyond the other.
TEST_F(FrameLanesOfTheMarcher, ReadEveryNumberOfThreeDecimals)
{
    const auto expect_lanes = [](const Values& values, std::string_view what) {
        const std::string line = line_of(values, table_order());
        State state = initial_state(accelerator);
        ASSERT_TRUE(by_lanes(line, state)) << what << ": " << line;
        for (std::size_t i = 0; i < numbers; ++i)
            ASSERT_EQ(state.codes[i], *quantize(table[i], values[i])) << line;
    };
    Values values = original_values();
    for (int number = -64'000; number <= 63'875; ++number) {
        for (std::size_t i = 0; i < numbers; ++i) {
            const int least = static_cast<int>(table[i].min_scaled * 1000 /
                                               (std::int64_t{1} << table[i].format.fraction_bits));
            const int most = static_cast<int>(table[i].max_scaled * 1000 /
                                              (std::int64_t{1} << table[i].format.fraction_bits));
            const int own = least + (number + 64'000) % (most - least + 1);
            values[i] = fmt::format("{}{}.{:03}", own < 0 ? "-" : "", std::abs(own) / 1000,
                                    std::abs(own) % 1000);
        }
        expect_lanes(values, "three decimals");
        if (number % 10 != 0)
            continue;
        for (std::size_t i = 0; i < numbers; ++i)
            if (values[i].ends_with('0'))
                values[i].pop_back();
        expect_lanes(values, "two decimals");
    }
}

/// The thousandths around each end of each range, and every place that no number can fill.
TEST_F(FrameLanesOfTheMarcher, LeaveWhatIsOutOfRange)
{
    for (std::size_t i = 0; i < numbers; ++i) {
        for (const double end : {-1000.0, -64.0, -1.0, 0.0, 1.0, 10.0, 63.875, 64.0, 655.36, 1000.0,
                                 4294.967, 9999.0}) {
            for (int off = -3; off <= 3; ++off) {
                Values values = original_values();
                values[i] = fmt::format("{:.3f}", end + off / 1000.0);
                const bool taken = expect_same_answer(line_of(values, table_order()));
                EXPECT_EQ(taken, quantize(table[i], values[i]).has_value()) << values[i];
            }
        }
    }
}

/// All texts of up to five characters of these, as the value of one lane of each format.
TEST_F(FrameLanesOfTheMarcher, AgreeOnEveryShortSpelling)
{
    constexpr std::string_view alphabet = "019.-+=";
    std::vector<std::string> spellings = {""};
    for (std::size_t begin = 0, length = 1; length <= 5; ++length) {
        const std::size_t end = spellings.size();
        for (; begin < end; ++begin)
            for (const char c : alphabet)
                spellings.push_back(spellings[begin] + c);
    }
    std::size_t taken = 0;
    for (const marcher::Index lane : {marcher::FX, marcher::ZM, marcher::LZ, marcher::B}) {
        Values values = original_values();
        for (const std::string& spelling : spellings) {
            values[lane] = spelling;
            taken += expect_same_answer(line_of(values, table_order())) ? 1 : 0;
        }
    }
    EXPECT_GT(taken, 100U);
}

TEST_F(FrameLanesOfTheMarcher, TakePairsInAnyOrder)
{
    std::mt19937_64 random = test::seeded_random();
    std::vector<std::size_t> indices = table_order();
    for (int round = 0; round < 2000; ++round) {
        std::ranges::shuffle(indices, random);
        Values values = original_values();
        for (std::size_t i = 0; i < numbers; ++i)
            values[i] = fmt::format("{:.3f}", static_cast<double>(test::pick(random, 0, 1000)) /
                                                  (table[i].min_scaled < 0 ? -1000.0 : 1000.0));
        values[marcher::OBJ] = marcher::scenes[test::pick<std::size_t>(random, 0, 3)];
        EXPECT_TRUE(expect_same_answer(line_of(values, indices))) << line_of(values, indices);
    }
    // The two that are nearest to the ends of the text, each with the shortest value.
    Values values = original_values();
    for (std::size_t i = 0; i < numbers; ++i)
        values[i] = ".00";
    for (std::size_t first = 0; first < size; ++first) {
        for (std::size_t last = 0; last < size; ++last) {
            indices = table_order();
            std::swap(indices[0], indices[first]);
            std::swap(indices[size - 1], indices[last]);
            EXPECT_TRUE(expect_same_answer(line_of(values, indices))) << line_of(values, indices);
        }
    }
}

/// One to four bytes of a good frame changed, left out or put in; or two pairs the same.
TEST_F(FrameLanesOfTheMarcher, GiveTheSameAnswerToDamagedFrames)
{
    constexpr std::string_view alphabet =
        "0123456789.-+eE,= \tFXRGBOJobjspherecutnlif_\x7f\x01\xff*";
    std::mt19937_64 random = test::seeded_random();
    const auto any = [&](std::size_t below) {
        return test::pick<std::size_t>(random, 0, below - 1);
    };
    std::vector<std::size_t> indices = table_order();
    std::size_t taken = 0;
    for (int round = 0; round < 60'000; ++round) {
        if (round % 4 == 0)
            std::ranges::shuffle(indices, random);
        else if (round % 4 == 1)
            indices = table_order();
        else if (round % 64 == 2)
            indices[any(size)] = any(size);
        std::string line = line_of(original_values(), indices);
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
        taken += expect_same_answer(line) ? 1 : 0;
    }
    EXPECT_GT(taken, 1000U);
}

/// Lines as long as a line may be, and lines of nothing but commas.
TEST_F(FrameLanesOfTheMarcher, LeaveLinesOfOtherLengths)
{
    for (std::size_t length = 0; length <= 1024; ++length) {
        EXPECT_FALSE(expect_same_answer(std::string(length, ',')));
        EXPECT_FALSE(expect_same_answer(std::string(length, '0')));
        std::string line(original.substr(0, std::min(length, original.size())));
        line.resize(length, ' ');
        expect_same_answer(line);
    }
}

} // namespace
} // namespace raymarch::protocol
