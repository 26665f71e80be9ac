// SPDX-License-Identifier: MIT
#include "cli/typed_bytes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace raymarch::cli
{
namespace
{

/// Converts the bytes as the editor does.
std::string utf8(char32_t code)
{
    const auto byte = [code](int shift, char32_t front) {
        return static_cast<char>(front | (code >> shift & (front == 0 ? 0x7F : 0x3F)));
    };
    if (code < 0x80)
        return {byte(0, 0)};
    if (code < 0x800)
        return {byte(6, 0xC0), byte(0, 0x80)};
    if (code < 0x10000)
        return {byte(12, 0xE0), byte(6, 0x80), byte(0, 0x80)};
    return {byte(18, 0xF0), byte(12, 0x80), byte(6, 0x80), byte(0, 0x80)};
}

std::string kept(std::string_view bytes)
{
    std::string line;
    while (!bytes.empty()) {
        const TypedCharacter typed = typed_character(bytes, true);
        EXPECT_GT(typed.size, 0U);
        EXPECT_NE(typed.code, 0U);
        EXPECT_FALSE(typed.code >= 0x80 && typed.code <= 0x9F) << "libedit reads it as a command";
        line += utf8(typed.code);
        bytes.remove_prefix(typed.size);
    }
    return line;
}

TEST(TypedBytes, CharactersStayCharacters)
{
    for (const std::string_view text : {"PING", "\xE2\x88\x92", "\xC2\xA0", "\xF0\x9F\x98\x80"})
        EXPECT_EQ(kept(text), text);
    EXPECT_EQ(typed_character("\xE2\x88\x92", false).code, U'\u2212');
}

TEST(TypedBytes, ACharacterThatOnlyBeginsWaitsForItsEnd)
{
    EXPECT_EQ(typed_character("\xE2\x88", false).size, 0U);
    EXPECT_EQ(typed_character("\xE2\x88", true).size, 1U);
    EXPECT_EQ(typed_character("\xE2"
                              "x",
                              false)
                  .size,
              1U);
}

TEST(TypedBytes, EveryByteComesBack)
{
    for (unsigned first = 0; first < 256; ++first)
        for (unsigned second = 0; second < 256; ++second) {
            const std::string bytes = {static_cast<char>(first), static_cast<char>(second)};
            EXPECT_EQ(typed_bytes(kept(bytes)), bytes);
        }
    std::mt19937 random(1); // a fixed seed
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes;
        for (int j = 0; j < 8; ++j) // many bytes with a meaning in UTF-8
            bytes += static_cast<char>(random() % 2 == 0 ? random() % 256 : 0x80 + random() % 0x80);
        EXPECT_EQ(typed_bytes(kept(bytes)), bytes);
    }
    const std::string own = "\xF4\x8F\x80\x80\xF4\x8F\x83\xBF"; // the private characters themselves
    EXPECT_EQ(typed_bytes(kept(own)), own);
}

} // namespace
} // namespace raymarch::cli
