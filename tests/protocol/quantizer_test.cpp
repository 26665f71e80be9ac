// SPDX-License-Identifier: MIT
/// @file
/// Expected codes are worked out by hand: half a unit is 2^-(f+1), and its odd multiples are the
/// ties.
#include "protocol/quantizer.hpp"

#include "protocol/dequantizer.hpp"
#include "protocol/plain_number.hpp"
#include "tests/fakes/descriptions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

constexpr const Parameter& direction = marcher::parameters[marcher::FX]; // Q1.17
constexpr const Parameter& light = marcher::parameters[marcher::LX];     // Q7.3
constexpr const Parameter& colour = marcher::parameters[marcher::R];     // UQ0.10
constexpr const Parameter& zoom = marcher::parameters[marcher::ZM];      // UQ8.24

struct CodeRow
{
    const Parameter* parameter;
    std::string_view text;
    std::int64_t code;
    std::string_view why;
};

constexpr std::array code_rows = {
    CodeRow{&direction, "0", 0, "zero"},
    CodeRow{&direction, "-0.0", 0, "every zero is the same zero"},
    CodeRow{&direction, "0.00000762939453125", 1, "2^-17"},
    CodeRow{&direction, "0.000003814697265625", 0, "2^-18: tie, to the even 0"},
    CodeRow{&direction, "-0.000003814697265625", 0, "the same below zero"},
    CodeRow{&direction, "0.0000038146972656250000001", 1, "a little more than the tie"},
    CodeRow{&direction, "0.0000038146972656249999999", 0, "a little less"},
    CodeRow{&direction, "0.000011444091796875", 2, "3 * 2^-18: tie, to the even 2"},
    CodeRow{&direction, "-0.000011444091796875", -2, "the same below zero"},
    CodeRow{&direction, "0.000019073486328125", 2, "5 * 2^-18: tie, to the even 2"},
    CodeRow{&direction, "0.342", 44827, "0.342 * 131072 = 44826.6"},
    CodeRow{&direction, "0.940", 123208, "123207.7"},
    CodeRow{&direction, "-0.5", -65536, "exact"},
    CodeRow{&direction, "1", 131071, "held at the largest code"},
    CodeRow{&direction, "0.999992370605468750", 131071, "1 - 2^-17: exact"},
    CodeRow{&direction, "0.999996185302734375", 131071, "a tie towards 131072, and held"},
    CodeRow{&direction, "-1", -131072, "the lower end is a code"},
    CodeRow{&direction, "-0.999996185302734375", -131072, "a tie, to the even -131072"},
    CodeRow{&direction, "1e-999", 0, "too small for any unit"},
    CodeRow{&direction, "-1e-999", 0, "and below zero"},

    CodeRow{&light, "0.0625", 0, "half a unit: tie, to 0"},
    CodeRow{&light, "-0.0625", 0, "the same below zero"},
    CodeRow{&light, "0.0625000001", 1, "a little more"},
    CodeRow{&light, "0.1875", 2, "1.5 units: tie, to 2"},
    CodeRow{&light, "0.3125", 2, "2.5 units: tie, to 2"},
    CodeRow{&light, "-0.3125", -2, "the same below zero"},
    CodeRow{&light, "0.4375", 4, "3.5 units: tie, to 4"},
    CodeRow{&light, "63.875", 511, "the upper end"},
    CodeRow{&light, "63.8125", 510, "510.5: tie, to the even 510"},
    CodeRow{&light, "63.813", 511, "a little more"},
    CodeRow{&light, "-64", -512, "the lower end"},
    CodeRow{&light, "-63.9375", -512, "511.5: tie, to the even 512"},
    CodeRow{&light, "-63.9374", -511, "a little nearer to zero"},

    CodeRow{&colour, "0.00048828125", 0, "2^-11: tie, to 0"},
    CodeRow{&colour, "0.00146484375", 2, "3 * 2^-11: tie, to 2"},
    CodeRow{&colour, "0.5", 512, "exact"},
    CodeRow{&colour, "0.498", 510, "509.95"},
    CodeRow{&colour, "1", 1023, "held"},
    CodeRow{&colour, "1.000", 1023, "held, with zeros"},
    CodeRow{&colour, "0.99951171875", 1023, "1023.5: a tie towards 1024, and held"},
    CodeRow{&colour, "0.9990234375", 1023, "exact"},
    CodeRow{&colour, "-0.000", 0, "a negative zero is zero"},

    CodeRow{&zoom, "3", 50331648, "3 * 2^24"},
    CodeRow{&zoom, "2.50", 41943040, "2.5 * 2^24"},
    CodeRow{&zoom, "10", 167772160, "the upper end"},
    CodeRow{&zoom, "1e1", 167772160, "the same with an exponent"},
    CodeRow{&zoom, "0.0000000298023223876953125", 0, "2^-25: tie, to 0"},
    CodeRow{&zoom, "0.00000002980232238769531250001", 1, "a little more, in the 29th place"},
    CodeRow{&zoom, "0.0000000894069671630859375", 2, "3 * 2^-25: tie, to 2"},
    CodeRow{&zoom, "9.9999999701976776123046875", 167772160, "10 - 2^-25: tie, to the even code"},
    CodeRow{&zoom, "9.99999997019767761230468749", 167772159, "a little less"},
    CodeRow{&zoom, "3.14159265358979", 52707179, "52707178.5..."},
};

TEST(Quantizer, TiesAndEnds)
{
    for (const CodeRow& row : code_rows) {
        const auto code = quantize(*row.parameter, row.text);
        ASSERT_TRUE(code) << row.parameter->key << '=' << row.text << ": " << row.why;
        EXPECT_EQ(*code, row.code) << row.parameter->key << '=' << row.text << ": " << row.why;
    }
}

struct BadValue
{
    const Parameter* parameter;
    std::string_view text;
    ErrorCode error;
};

constexpr std::array bad_values = {
    BadValue{&direction, "1.0000000000000000000000000001", ErrorCode::Range},
    BadValue{&direction, "-1.0000000000000000000000000001", ErrorCode::Range},
    BadValue{&direction, "1.000001", ErrorCode::Range},
    BadValue{&direction, "2", ErrorCode::Range},
    BadValue{&direction, "1e999", ErrorCode::Range},
    BadValue{&direction, "-1e999", ErrorCode::Range},
    BadValue{&light, "63.8750000000000000001", ErrorCode::Range},
    BadValue{&light, "63.88", ErrorCode::Range}, // would round to a code that is in range
    BadValue{&light, "64", ErrorCode::Range},
    BadValue{&light, "-64.00000000000000000000000001", ErrorCode::Range},
    BadValue{&colour, "1.0000000000000000000001", ErrorCode::Range},
    BadValue{&colour, "-0.00000000000000000000000001", ErrorCode::Range},
    BadValue{&colour, "-1e-999", ErrorCode::Range},
    BadValue{&zoom, "10.00000000000000000000000001", ErrorCode::Range},
    BadValue{&zoom, "10.1", ErrorCode::Range},
    BadValue{&zoom, "-1", ErrorCode::Range},
    BadValue{&zoom, "18446744073709551616", ErrorCode::Range},
    BadValue{&zoom, "99999999999999999999999999999999", ErrorCode::Range},
    BadValue{&zoom, "", ErrorCode::Number},
    BadValue{&zoom, ".", ErrorCode::Number},
    BadValue{&zoom, "-", ErrorCode::Number},
    BadValue{&zoom, "1e", ErrorCode::Number},
    BadValue{&zoom, "0x1", ErrorCode::Number},
    BadValue{&zoom, "inf", ErrorCode::Number},
    BadValue{&zoom, "0.0000000000000000000000000000000", ErrorCode::Number}, // 33 characters
};

TEST(Quantizer, FaultsAreJudgedOnTheDecimalAsWritten)
{
    for (const BadValue& row : bad_values) {
        const auto code = quantize(*row.parameter, row.text);
        ASSERT_FALSE(code) << row.parameter->key << '=' << row.text;
        EXPECT_EQ(code.error(), row.error) << row.parameter->key << '=' << row.text;
    }
}

/// code -> text -> code, every `stride`-th code from `first` to `last`.
void expect_codes_to_come_back(const Parameter& parameter, std::int64_t first, std::int64_t last,
                               std::int64_t stride)
{
    for (std::int64_t code = first; code <= last; code += stride) {
        const ValueText text = to_text(parameter, code);
        const auto back = quantize(parameter, text.view());
        ASSERT_TRUE(back) << parameter.key << " code " << code << " as " << text.view();
        ASSERT_EQ(*back, code) << parameter.key << " as " << text.view();
    }
}

TEST(Quantizer, EveryCodeComesBackFromItsText)
{
    expect_codes_to_come_back(direction, -131072, 131071, 1);
    expect_codes_to_come_back(light, -512, 511, 1);
    expect_codes_to_come_back(colour, 0, 1023, 1);
}

TEST(Quantizer, ZoomCodesComeBackFromTheirText)
{
    constexpr std::int64_t largest = 167'772'160;
    expect_codes_to_come_back(zoom, 0, largest, 1009); // a prime: no low bit is left out
    expect_codes_to_come_back(zoom, 0, 4096, 1);
    expect_codes_to_come_back(zoom, largest - 4096, largest, 1);
    for (int bit = 0; bit < 28; ++bit)
        expect_codes_to_come_back(zoom, (std::int64_t{1} << bit) - 1, (std::int64_t{1} << bit) + 1,
                                  1);
}

std::string random_number(std::mt19937_64& random)
{
    constexpr std::string_view alphabet = "0123456789012345678901234567890123456789.....+-eE x";
    std::string text;
    if (test::pick(random, 0, 9) == 0) { // anything, mostly no number
        for (int i = test::pick(random, 0, 34); i > 0; --i)
            text += alphabet[test::pick(random, std::size_t{0}, alphabet.size() - 1)];
        return text;
    }
    text = std::array{"", "", "-", "+"}[test::pick(random, std::size_t{0}, std::size_t{3})];
    for (int i = test::pick(random, 0, 3); i > 0; --i)
        text += static_cast<char>('0' + test::pick(random, 0, 9));
    if (test::pick(random, 0, 3) > 0)
        text += '.';
    for (int i = test::pick(random, 0, 19); i > 0; --i)
        text += static_cast<char>('0' + test::pick(random, 0, 9));
    return text;
}

TEST(Quantizer, TheFastPathAgreesWithTheGeneralOne)
{
    auto random = test::seeded_random();
    int taken = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::string text = random_number(random);
        const std::string line = text + ",OBJ=sphere"; // as it stands in a frame
        for (const Parameter* parameter : {&direction, &light, &colour, &zoom}) {
            std::int64_t code = 0;
            const std::size_t length = quantize_plain(*parameter, line, code);
            if (length == 0 || line[length] != ',')
                continue; // left to quantize()
            const auto general = quantize(*parameter, text);
            ASSERT_TRUE(general) << parameter->key << '=' << text;
            ASSERT_EQ(code, *general) << parameter->key << '=' << text;
            ++taken;
        }
    }
    EXPECT_GT(taken, 10'000); // or the texts have become useless
}

class Numbers : public test::EveryAccelerator
{
  protected:
    /// Code of a number, or why it has none; the tail is left out.
    [[nodiscard]] static tl::expected<std::int64_t, ErrorCode> general(const Parameter& parameter,
                                                                       std::string_view text)
    {
        if (parameter.tail_bits > 0)
            return quantize_wide(parameter, text).map([](WideCode code) { return code.upper; });
        return quantize(parameter, text);
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, Numbers, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Numbers, TheFastPathAgreesWithTheGeneralOne)
{
    auto random = test::seeded_random();
    int taken = 0;
    for (int i = 0; i < 10'000; ++i) {
        const std::string text = random_number(random);
        const std::string line = text + ",A=b"; // as it stands in a frame
        for (const Parameter& parameter : table) {
            std::int64_t code = 0;
            const std::size_t length = parameter.is_choice() || parameter.is_tail()
                                           ? 0
                                           : quantize_plain(parameter, line, code);
            if (length == 0 || line[length] != ',')
                continue; // left to quantize()
            ASSERT_EQ(general(parameter, text), code) << parameter.key << '=' << text;
            ASSERT_EQ(parameter.tail_bits, 0) << parameter.key;
            ++taken;
        }
    }
    EXPECT_GT(taken, 200); // or the texts have become useless
}

TEST_P(Numbers, EnormousOnesAreOutOfRange)
{
    for (const std::string text :
         {"9007199254740992", "9223372036854775808.5", "18446744073709551615.99999",
          "18446744073709551616", "36893488147419103232", "1e20", "1e999"})
        for (const Parameter& parameter : table) {
            if (parameter.is_choice() || parameter.is_tail())
                continue;
            EXPECT_EQ(general(parameter, text), tl::unexpected(ErrorCode::Range))
                << parameter.key << '=' << text;
            EXPECT_EQ(general(parameter, "-" + text), tl::unexpected(ErrorCode::Range))
                << parameter.key << "=-" << text;
        }
}

TEST_P(Numbers, ATieGoesToTheEvenCode)
{
    for (const Parameter& parameter : table) {
        if (parameter.is_choice() || parameter.is_tail() || parameter.tail_bits > 0)
            continue;
        const int bits = parameter.format.fraction_bits;
        if (bits > 30) // half a unit would need more than 32 characters
            continue;
        // From the middle of the range on: odd multiples of half a unit, written out in full.
        const std::int64_t middle = (parameter.min_scaled + parameter.max_scaled) / 2;
        for (std::int64_t below = middle; below < std::min(middle + 8, parameter.max_scaled);
             ++below) {
            const bool negative = below < 0; // between `below` and `below` + 1, which may be 0
            const std::uint64_t halves =
                static_cast<std::uint64_t>(negative ? -2 * below - 1 : 2 * below + 1);
            std::string text = (negative ? "-" : "") + std::to_string(halves >> (bits + 1)) + ".";
            std::uint64_t rest = halves & ((std::uint64_t{2} << bits) - 1);
            for (int place = 0; place <= bits; ++place) {
                rest *= 10;
                text += static_cast<char>('0' + (rest >> (bits + 1)));
                rest &= (std::uint64_t{2} << bits) - 1;
            }
            const std::int64_t even = below + (below & 1);
            EXPECT_EQ(quantize(parameter, text), std::min(even, parameter.largest_code))
                << parameter.key << '=' << text;
        }
    }
}

/// Numbers whose half codes fill 64 bits, or just do not: nothing may wrap around into the range.
TEST(Quantizer, EnormousNumbersAreOutOfRange)
{
    for (const std::string text :
         {"9007199254740991.99999", "9007199254740992", "9223372036854775807.9",
          "18446744073709551615.99999", "18446744073709551616", "1e20"}) {
        for (const Parameter* parameter : {&direction, &light, &colour, &zoom}) {
            EXPECT_EQ(quantize(*parameter, text).error(), ErrorCode::Range) << text;
            EXPECT_EQ(quantize(*parameter, "-" + text).error(), ErrorCode::Range) << text;
        }
    }
}

/// Every code of Q7.3 and the ties between them, written with three decimals as hosts write them.
TEST(Quantizer, TheFastPathTakesWhatHostsWrite)
{
    for (int sixteenths = -64 * 16; sixteenths <= 63 * 16 + 14; ++sixteenths) {
        const std::string text = fmt::format("{:.4f}", sixteenths / 16.0);
        std::int64_t code = 0;
        ASSERT_EQ(quantize_plain(light, text + ",OBJ=sphere", code), text.size()) << text;
        EXPECT_EQ(code, *quantize(light, text)) << text;
    }
}

/// The product by a factor against the quotient: every number of decimals and of fraction bits;
/// values that are divided exactly, their neighbours, and the largest of nine digits.
TEST(Quantizer, MultiplyingByAFactorIsDividing)
{
    const auto check = [](std::uint64_t value, unsigned bits, unsigned decimals) {
        std::uint64_t power = 1;
        for (unsigned i = 0; i < decimals; ++i)
            power *= 10;
        // In two steps: value * 2^27 would not leave room for ten digits more.
        const std::uint64_t whole = value / power;
        const std::uint64_t rest = (value % power) << bits;
        const Scaled scaled =
            detail::scale_plain(static_cast<std::uint32_t>(value), bits, decimals);
        ASSERT_EQ(scaled.floor, (whole << bits) + rest / power)
            << value << ' ' << bits << ' ' << decimals;
        ASSERT_EQ(scaled.inexact, rest % power != 0) << value << ' ' << bits << ' ' << decimals;
    };
    constexpr std::uint64_t largest = 999'999'999;
    auto random = test::seeded_random();
    for (unsigned bits = 0; bits <= detail::max_plain_bits; ++bits)
        for (unsigned decimals = 0; decimals <= detail::max_plain_decimals; ++decimals) {
            // 5^decimals times an odd number, and its doubles, are what comes out without a rest.
            std::uint64_t five = 1;
            for (unsigned i = 0; i < decimals; ++i)
                five *= 5;
            for (int i = 0; i < 300; ++i) {
                const std::uint64_t exact =
                    test::pick<std::uint64_t>(random, 0, largest / five) * five;
                check(exact, bits, decimals);
                check(std::min(exact + 1, largest), bits, decimals);
                check(exact > 0 ? exact - 1 : 0, bits, decimals);
                check(test::pick<std::uint64_t>(random, 0, largest), bits, decimals);
                check(largest - static_cast<std::uint64_t>(i), bits, decimals);
                check(static_cast<std::uint64_t>(i), bits, decimals);
            }
        }
}

} // namespace
} // namespace raymarch::protocol
