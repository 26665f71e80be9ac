// SPDX-License-Identifier: MIT
/// @file
/// CRC-32 as in Ethernet and PNG (polynomial 0x04C11DB7, reflected).
#pragma once

#include <cstdint>
#include <string_view>

namespace raymarch
{

/// This bit-by-bit loop is fast enough for the state file: it has a few hundred bytes, and is
/// written every two seconds at most.
[[nodiscard]] constexpr std::uint32_t crc32(std::string_view bytes) noexcept
{
    std::uint32_t crc = 0xFFFF'FFFF;
    for (const char c : bytes) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB8'8320 : 0);
    }
    return ~crc;
}
static_assert(crc32("123456789") == 0xCBF4'3926);

} // namespace raymarch
