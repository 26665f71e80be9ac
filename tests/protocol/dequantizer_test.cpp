// SPDX-License-Identifier: MIT
#include "protocol/dequantizer.hpp"

#include "protocol/quantizer.hpp"
#include "tests/fakes/descriptions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

struct TextRow
{
    marcher::Index parameter;
    std::int64_t code;
    std::string_view text;
    std::string_view why;
};

constexpr std::array rows = {
    TextRow{marcher::FX, 0, "0", "no sign, no point"},
    TextRow{marcher::FX, 131071, "0.99999", "1 would come back only because it is held"},
    TextRow{marcher::FX, -131072, "-1", "the lower end is exact"},
    TextRow{marcher::FX, 1, "0.00001", "2^-17 = 0.0000076..."},
    TextRow{marcher::FX, -1, "-0.00001", "the same below zero; never -0"},
    TextRow{marcher::FX, 65536, "0.5", "exact"},
    TextRow{marcher::FX, 2, "0.000015", "0.00002 would be 2.6 units"},
    TextRow{marcher::LX, 24, "3", "whole"},
    TextRow{marcher::LX, 1, "0.1", "0.125: 0.1 is 0.8 units"},
    TextRow{marcher::LX, 2, "0.3", "0.25: halfway, so away from zero"},
    TextRow{marcher::LX, -2, "-0.3", "the same below zero"},
    TextRow{marcher::LX, 511, "63.875", "63.9 and 63.88 are out of range"},
    TextRow{marcher::LX, 510, "63.8", "63.75: halfway, away from zero, 510.4 units"},
    TextRow{marcher::LX, -511, "-63.9", "in range on this side"},
    TextRow{marcher::LX, -512, "-64", "the lower end"},
    TextRow{marcher::R, 1023, "0.999", "0.99902"},
    TextRow{marcher::R, 1, "0.001", "0.00098"},
    TextRow{marcher::R, 64, "0.0625", "0.063 would be 64.5 units"},
    TextRow{marcher::ZM, 1, "0.00000006", "never an exponent"},
    TextRow{marcher::ZM, 167'772'160, "10", "the upper end"},
    TextRow{marcher::ZM, 167'772'159, "9.99999994", "one step below it"},
    TextRow{marcher::ZM, 52'707'179, "3.1415927", "seven places"},
    TextRow{marcher::OBJ, 0, "sphere", "a choice has a name"},
    TextRow{marcher::OBJ, 2, "infinite_cube", "a long one"},
};

TEST(Dequantizer, FewestPlacesThatComeBack)
{
    for (const TextRow& row : rows) {
        const Parameter& parameter = marcher::parameters[row.parameter];
        EXPECT_EQ(to_text(parameter, row.code).view(), row.text)
            << parameter.key << " code " << row.code << ": " << row.why;
    }
}

class Texts : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, Texts, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Texts, QuantiseBack)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 50; ++i) {
        const State state = test::random_state(accelerator, random);
        for (std::size_t p = 0; p < table.size(); ++p) {
            const Parameter& parameter = table[p];
            const std::int64_t code = state.codes[p];
            if (parameter.is_choice()) {
                EXPECT_EQ(find_choice(parameter, to_text(parameter, code).view()), code);
            } else if (parameter.tail_bits > 0) {
                const WideCode wide{.upper = code, .tail = state.codes[p + 1]};
                EXPECT_EQ(quantize_wide(parameter, to_text(parameter, code, wide.tail).view()),
                          wide)
                    << parameter.key << " code " << code << ' ' << wide.tail;
            } else if (!parameter.is_tail()) {
                EXPECT_EQ(quantize(parameter, to_text(parameter, code).view()), code)
                    << parameter.key;
            }
        }
    }
}

TEST_P(Texts, TheEndsOfARangeAreWrittenAsTheTableWritesThem)
{
    for (const Parameter& parameter : table) {
        if (parameter.is_choice() || parameter.is_tail())
            continue;
        EXPECT_EQ(to_text(parameter, parameter.min_scaled).view(), parameter.min) << parameter.key;
        if (parameter.max_scaled > parameter.largest_code) // no code has that value
            continue;
        const ValueText written = to_text(parameter, parameter.max_scaled);
        const std::string_view text = written.view();
        EXPECT_LE(text.size(), parameter.max.size()) << parameter.key;
        EXPECT_TRUE(parameter.tail_bits > 0 || quantize(parameter, text) == parameter.max_scaled)
            << parameter.key << '=' << text;
    }
}

#ifdef __SIZEOF_INT128__                  // an independent wide integer; 32-bit targets have none
__extension__ typedef __int128 Signed128; // NOLINT(modernize-use-using)

/// numerator / denominator, ties away from zero or to even; both positive.
Signed128 divide_to_nearest(Signed128 numerator, Signed128 denominator, bool ties_to_even)
{
    const Signed128 floor = numerator / denominator;
    const Signed128 doubled_rest = 2 * (numerator % denominator);
    if (doubled_rest == denominator)
        return floor + (ties_to_even ? floor & 1 : 1);
    return floor + (doubled_rest > denominator ? 1 : 0);
}

/// The places that the shortest text of `code` has, by integer arithmetic on the definition.
int fewest_places(const Parameter& parameter, std::int64_t code)
{
    const Signed128 one = Signed128{1} << parameter.format.fraction_bits;
    const Signed128 magnitude = code < 0 ? -code : code;
    const Signed128 limit = code < 0 ? -parameter.min_scaled : parameter.max_scaled;
    Signed128 tens = 1;
    for (int places = 0;; ++places, tens *= 10) {
        const Signed128 decimal = divide_to_nearest(magnitude * tens, one, false);
        if (decimal * one <= limit * tens &&
            divide_to_nearest(decimal * one, tens, true) == magnitude)
            return places;
    }
}

int places_of(std::string_view text)
{
    const std::size_t point = text.find('.');
    return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

void expect_fewest_places(const Parameter& parameter, std::int64_t code)
{
    const ValueText text = to_text(parameter, code);
    ASSERT_EQ(places_of(text.view()), fewest_places(parameter, code))
        << parameter.key << " code " << code << " as " << text.view();
}

TEST(Dequantizer, NoFewerPlacesWouldDo)
{
    for (std::int64_t code = -512; code <= 511; ++code)
        expect_fewest_places(marcher::parameters[marcher::LX], code);
    for (std::int64_t code = 0; code <= 1023; ++code)
        expect_fewest_places(marcher::parameters[marcher::R], code);
    for (std::int64_t code = -131072; code <= 131071; ++code)
        expect_fewest_places(marcher::parameters[marcher::FX], code);
    auto random = test::seeded_random();
    for (int i = 0; i < 50'000; ++i)
        expect_fewest_places(marcher::parameters[marcher::ZM],
                             test::pick<std::int64_t>(random, 0, 167'772'160));
}

TEST_P(Texts, NoFewerPlacesWouldDo)
{
    auto random = test::seeded_random();
    for (const Parameter& parameter : table) {
        if (parameter.is_choice() || parameter.is_tail() || parameter.tail_bits > 0)
            continue;
        for (int i = 0; i < 30; ++i)
            expect_fewest_places(parameter, test::pick(random, parameter.min_scaled,
                                                       test::largest_in_range(parameter)));
    }
}
#endif

TEST(Dequantizer, ACodeBeyondTheRangeIsShownAsIfTheRangeWereTheFormat)
{
    // A register may hold a zoom above 10; it is shown, though it cannot be sent back.
    const Parameter& zoom = marcher::parameters[marcher::ZM];
    EXPECT_EQ(to_text(zoom, 0xFFFF'FFFF).view(), "255.99999994"); // 256 - 2^-24
    EXPECT_EQ(to_text(zoom, std::int64_t{11} << 24).view(), "11");
}

TEST(Dequantizer, ANegativeNumberWithAnEmptyTail)
{
    const Parameter& position =
        mandelbulb::parameters[mandelbulb::Y]; // Q8.64, the tail has 32 bits
    EXPECT_EQ(to_text(position, -(std::int64_t{1} << 32), 0).view(), "-1");
    EXPECT_EQ(to_text(position, -1, 0).view(), "-0.00000000023283064365"); // 2^-32
    EXPECT_EQ(to_text(position, -1, 0xFFFF'FFFF).view(), "-0.00000000000000000005");
    EXPECT_EQ(to_text(position, -(std::int64_t{5} << 31), 0).view(), "-2.5");
}

} // namespace
} // namespace raymarch::protocol
