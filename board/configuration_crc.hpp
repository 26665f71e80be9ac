// SPDX-License-Identifier: MIT
/// @file
/// The configuration logic of the 7 series computes this CRC over the words written to its
/// registers. It is a CRC-32C (polynomial 0x1EDC6F41, reflected). Its input is the 32 bits of a
/// word and then the 5 bits of the register's address, low bits first. It starts at 0 and is not
/// inverted at the end. (UG470; Project X-Ray, crc.h.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::board
{
namespace configuration_crc
{

/// Returns the CRC after `bits` more zero bits.
constexpr std::uint32_t shifted(std::uint32_t value, int bits) noexcept
{
    for (int bit = 0; bit < bits; ++bit)
        value = value >> 1 ^ ((value & 1) != 0 ? 0x82F6'3B78U : 0U);
    return value;
}

constexpr std::array<std::array<std::uint32_t, 256>, 4> make_words() noexcept
{
    std::array<std::array<std::uint32_t, 256>, 4> made{};
    for (std::size_t n = 0; n < made.size(); ++n)
        for (std::uint32_t byte = 0; byte < 256; ++byte)
            made[n][byte] = shifted(byte, 32 - 8 * static_cast<int>(n));
    return made;
}
/// words[n][byte] is the share of byte n in the CRC after a word. Byte 0 is the low byte. It comes
/// first, so it is shifted by 32 bits, and each higher byte by 8 bits less.
inline constexpr auto words = make_words();

constexpr std::array<std::uint32_t, 32> make_addresses() noexcept
{
    std::array<std::uint32_t, 32> made{};
    for (std::uint32_t address = 0; address < 32; ++address)
        made[address] = shifted(address, 5);
    return made;
}
/// addresses[bits] is the share of the low 5 bits of the CRC after their XOR with an address.
inline constexpr auto addresses = make_addresses();

} // namespace configuration_crc

/// The CRC uses tables, because a bitstream has a million words.
class ConfigurationCrc
{
  public:
    /// Precondition: `address` < 32.
    constexpr void add(std::uint32_t address, std::uint32_t word) noexcept
    {
        const std::uint32_t mixed = value_ ^ word;
        value_ = configuration_crc::words[0][mixed & 0xFF] ^
                 configuration_crc::words[1][mixed >> 8 & 0xFF] ^
                 configuration_crc::words[2][mixed >> 16 & 0xFF] ^
                 configuration_crc::words[3][mixed >> 24];
        value_ = value_ >> 5 ^ configuration_crc::addresses[(value_ ^ address) & 0x1F];
    }
    constexpr void reset() noexcept { value_ = 0; }
    [[nodiscard]] constexpr std::uint32_t value() const noexcept { return value_; }

  private:
    std::uint32_t value_ = 0;
};

} // namespace raymarch::board
