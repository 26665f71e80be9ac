// SPDX-License-Identifier: MIT
#include "protocol/decimal.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

struct ParseRow
{
    std::string_view text;
    std::string_view value; ///< [-]0.DIGITS * 10^point as "-DIGITSePOINT"; empty: no number
};

constexpr std::array parse_rows = {
    ParseRow{"0", "0"},
    ParseRow{"00", "0"},
    ParseRow{"-0", "0"}, // every zero is the same zero
    ParseRow{"-0.000e5", "0"},
    ParseRow{"+0.", "0"},
    ParseRow{".0", "0"},
    ParseRow{"0e999", "0"},
    ParseRow{"1", "1e1"}, // 0.1 * 10^1
    ParseRow{"+1", "1e1"},
    ParseRow{"-1", "-1e1"},
    ParseRow{"001", "1e1"},
    ParseRow{"1.", "1e1"},
    ParseRow{"1.000", "1e1"},
    ParseRow{"100", "1e3"},
    ParseRow{"0.5", "5e0"},
    ParseRow{".5", "5e0"},
    ParseRow{"-.5", "-5e0"},
    ParseRow{"0.05", "5e-1"},
    ParseRow{"0.0500", "5e-1"},
    ParseRow{"12.034", "12034e2"},
    ParseRow{"1e3", "1e4"},
    ParseRow{"1E+3", "1e4"},
    ParseRow{"1e-3", "1e-2"},
    ParseRow{"1.e1", "1e2"},
    ParseRow{".1e001", "1e1"},
    ParseRow{"1e999", "1e1000"},
    ParseRow{"1e-999", "1e-998"},
    ParseRow{"12345678901234567890123456789012", "12345678901234567890123456789012e32"},
    ParseRow{"123456789012345678901234567890123", ""}, // 33 characters
    ParseRow{"0.0000000000000000000000000000001", ""}, // 33 characters
    ParseRow{"0.000000000000000000000000000001", "1e-29"},
    ParseRow{"", ""},
    ParseRow{"+", ""},
    ParseRow{"-", ""},
    ParseRow{".", ""},
    ParseRow{"-.", ""},
    ParseRow{"e1", ""},
    ParseRow{".e1", ""},
    ParseRow{"1e", ""},
    ParseRow{"1e+", ""},
    ParseRow{"1e-", ""},
    ParseRow{"1e0001", ""}, // at most three digits
    ParseRow{"1e1.0", ""},
    ParseRow{"1ee1", ""},
    ParseRow{"1..0", ""},
    ParseRow{"1.0.", ""},
    ParseRow{"--1", ""},
    ParseRow{"+-1", ""},
    ParseRow{"1-", ""},
    ParseRow{" 1", ""},
    ParseRow{"1 ", ""},
    ParseRow{"1 0", ""},
    ParseRow{"0x1", ""},
    ParseRow{"1f", ""},
    ParseRow{"1_000", ""},
    ParseRow{"1,5", ""},
    ParseRow{"inf", ""},
    ParseRow{"nan", ""},
    ParseRow{"1\xC2\xA0", ""},
};

std::string describe(const Decimal& value)
{
    if (value.count == 0)
        return value.negative ? "-0" : "0";
    std::string text = value.negative ? "-" : "";
    for (std::size_t i = 0; i < value.count; ++i)
        text += static_cast<char>('0' + value.digits[i]);
    return text + "e" + std::to_string(value.point);
}

TEST(Decimal, TheGrammar)
{
    for (const ParseRow& row : parse_rows) {
        const auto value = parse_decimal(row.text);
        ASSERT_EQ(value.has_value(), !row.value.empty()) << "'" << row.text << "'";
        if (value) {
            EXPECT_EQ(describe(*value), row.value) << "'" << row.text << "'";
        }
    }
}

TEST(Decimal, AnEmbeddedZeroByteIsNoNumber)
{
    EXPECT_FALSE(parse_decimal(std::string_view("1\0", 2)));
}

/// In rising order.
constexpr std::array<std::string_view, 17> rising = {"-1e999",  "-10",
                                                     "-9.9999", "-1.0000000000000000000000000001",
                                                     "-1",      "-0.9",
                                                     "-1e-999", "0",
                                                     "1e-999",  "0.09",
                                                     "0.1",     "0.10000000000000000000000000001",
                                                     "1",       "1.0000000000000000000000000001",
                                                     "9",       "10",
                                                     "1e999"};

TEST(Decimal, ComparesExactly)
{
    for (std::size_t i = 0; i < rising.size(); ++i) {
        for (std::size_t j = 0; j < rising.size(); ++j) {
            const int sign = compare(*parse_decimal(rising[i]), *parse_decimal(rising[j]));
            EXPECT_EQ(sign < 0, i < j) << rising[i] << " and " << rising[j];
            EXPECT_EQ(sign > 0, i > j) << rising[i] << " and " << rising[j];
        }
    }
}

TEST(Decimal, DifferentSpellingsAreEqual)
{
    const Decimal half = *parse_decimal("0.5");
    for (const std::string_view text : {".5", "+0.50", "5e-1", "500E-3", "0.0005e3"})
        EXPECT_EQ(compare(half, *parse_decimal(text)), 0) << text;
    EXPECT_EQ(compare(*parse_decimal("-0"), *parse_decimal("0")), 0);
}

struct ScaleRow
{
    std::string_view text;
    int bits;
    std::uint64_t floor;
    bool inexact;
};

constexpr std::array scale_rows = {
    ScaleRow{"0", 65, 0, false},
    ScaleRow{"1", 0, 1, false},
    ScaleRow{"1", 63, std::uint64_t{1} << 63, false},
    ScaleRow{"-1", 4, 16, false}, // the magnitude
    ScaleRow{"0.5", 0, 0, true},
    ScaleRow{"0.5", 1, 1, false},
    ScaleRow{"0.1", 4, 1, true},                             // 1.6
    ScaleRow{"63.875", 4, 1022, false},                      // 63.875 * 16
    ScaleRow{"63.8750000000000000000000001", 4, 1022, true}, // a little more
    ScaleRow{"18446744073709551615", 0, UINT64_MAX, false},  // 2^64 - 1
    ScaleRow{"18446744073709551615.5", 0, UINT64_MAX, true},
    ScaleRow{"18446744073709551616", 0, UINT64_MAX, true}, // 2^64: too large
    ScaleRow{"1", 64, UINT64_MAX, true},
    ScaleRow{"0.5", 65, UINT64_MAX, true},
    ScaleRow{"0.25", 65, std::uint64_t{1} << 63, false},
    ScaleRow{"99999999999999999999999999999999", 65, UINT64_MAX, true},
    ScaleRow{"1e999", 0, UINT64_MAX, true},
    ScaleRow{"1e-999", 65, 0, true},
    ScaleRow{"0.00000000000000000001", 65, 0, true},       // 10^-20 * 2^65 = 0.37
    ScaleRow{"0.0000000000000000001", 65, 3, true},        // 10^-19 * 2^65 = 3.69
    ScaleRow{"99999999999999999999", 0, UINT64_MAX, true}, // 20 digits, above 2^64
    ScaleRow{"1e19", 0, 10'000'000'000'000'000'000ULL, false},
};

TEST(Decimal, ScalesByPowersOfTwo)
{
    for (const ScaleRow& row : scale_rows) {
        const Scaled scaled = scale(*parse_decimal(row.text), row.bits);
        EXPECT_EQ(scaled.floor, row.floor) << row.text << " * 2^" << row.bits;
        EXPECT_EQ(scaled.inexact, row.inexact) << row.text << " * 2^" << row.bits;
    }
}

#ifdef __SIZEOF_INT128__ // an independent wide integer; 32-bit targets have none
__extension__ typedef unsigned __int128 Exact; // NOLINT(modernize-use-using)

TEST(Decimal, ScalesAsWideIntegersDo)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 100'000; ++i) {
        const auto significand = random() >> test::pick(random, 24, 63); // below 2^40
        const int places = test::pick(random, 0, 18);
        const int bits = test::pick(random, 0, 65);
        const std::string text = std::to_string(significand) + "e-" + std::to_string(places);

        Exact divisor = 1;
        for (int place = 0; place < places; ++place)
            divisor *= 10;
        const Exact dividend = Exact{significand} << bits; // at most 105 bits
        const Exact floor = dividend / divisor;
        const bool fits = floor >> 64 == 0;
        const Scaled scaled = scale(*parse_decimal(text), bits);
        ASSERT_EQ(scaled.floor, fits ? static_cast<std::uint64_t>(floor) : UINT64_MAX)
            << text << " * 2^" << bits;
        ASSERT_EQ(scaled.inexact, !fits || dividend % divisor != 0) << text << " * 2^" << bits;
    }
}
#endif

} // namespace
} // namespace raymarch::protocol
