// SPDX-License-Identifier: MIT
/// @file
/// Compares with published check values of CRC-32/ISO-HDLC.
#include "base/crc32.hpp"

#include <gtest/gtest.h>

#include <string>

namespace raymarch
{
namespace
{

TEST(Crc32, PublishedValues)
{
    EXPECT_EQ(crc32(""), 0x0000'0000U);
    EXPECT_EQ(crc32("a"), 0xE8B7'BE43U);
    EXPECT_EQ(crc32("abc"), 0x3524'41C2U);
    EXPECT_EQ(crc32("123456789"), 0xCBF4'3926U);
    EXPECT_EQ(crc32(std::string(32, '\0')), 0x190A'55ADU);
    EXPECT_EQ(crc32(std::string(32, '\xFF')), 0xFF6C'AB0BU); // bytes above 0x7F are unsigned
}

TEST(Crc32, EveryBitCounts)
{
    const std::string text = "last marcher FX=0";
    for (std::size_t at = 0; at < text.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = text;
            other[at] = static_cast<char>(other[at] ^ (1 << bit));
            EXPECT_NE(crc32(other), crc32(text)) << "byte " << at << " bit " << bit;
        }
    }
}

} // namespace
} // namespace raymarch
