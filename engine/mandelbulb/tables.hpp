// SPDX-License-Identifier: MIT
/// @file
/// TABLE: what the hardware keeps in ROM: the angles and gains of CORDIC, the logarithms of BKM.
/// The tests compute every entry again (docs/engine/mandelbulb.md, "Tables").
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::mandelbulb
{

inline constexpr int min_steps = 8; ///< of CORDIC, BKM and division
inline constexpr int max_steps = 64;

// One angle, one logarithm, one gain a step: four a line.
// clang-format off
/// round(atan(2^-i) / (2 pi) * 2^64): one turn is 2^64.
inline constexpr std::array<std::uint64_t, max_steps> angles = {
    0x2000'0000'0000'0000, 0x12E4'051D'9DF3'0866, 0x09FB'385B'5EE3'9E8E, 0x0511'11D4'1DDD'9A1B,
    0x028B'0D43'0E58'9AED, 0x0145'D7E1'5904'6278, 0x00A2'F61E'5C28'262A, 0x0051'7C55'11D4'42AF,
    0x0028'BE53'46D0'C337, 0x0014'5F2E'BB30'AB38, 0x000A'2F98'0091'BA7B, 0x0005'17CC'14A8'0CB7,
    0x0002'8BE6'0CDF'EC62, 0x0001'45F3'06C1'72F2, 0x0000'A2F9'836A'E911, 0x0000'517C'C1B6'BA7C,
    0x0000'28BE'60DB'85FC, 0x0000'145F'306D'C816, 0x0000'0A2F'9836'E4AE, 0x0000'0517'CC1B'726B,
    0x0000'028B'E60D'B938, 0x0000'0145'F306'DC9C, 0x0000'00A2'F983'6E4E, 0x0000'0051'7CC1'B727,
    0x0000'0028'BE60'DB94, 0x0000'0014'5F30'6DCA, 0x0000'000A'2F98'36E5, 0x0000'0005'17CC'1B72,
    0x0000'0002'8BE6'0DB9, 0x0000'0001'45F3'06DD, 0x0000'0000'A2F9'836E, 0x0000'0000'517C'C1B7,
    0x0000'0000'28BE'60DC, 0x0000'0000'145F'306E, 0x0000'0000'0A2F'9837, 0x0000'0000'0517'CC1B,
    0x0000'0000'028B'E60E, 0x0000'0000'0145'F307, 0x0000'0000'00A2'F983, 0x0000'0000'0051'7CC2,
    0x0000'0000'0028'BE61, 0x0000'0000'0014'5F30, 0x0000'0000'000A'2F98, 0x0000'0000'0005'17CC,
    0x0000'0000'0002'8BE6, 0x0000'0000'0001'45F3, 0x0000'0000'0000'A2FA, 0x0000'0000'0000'517D,
    0x0000'0000'0000'28BE, 0x0000'0000'0000'145F, 0x0000'0000'0000'0A30, 0x0000'0000'0000'0518,
    0x0000'0000'0000'028C, 0x0000'0000'0000'0146, 0x0000'0000'0000'00A3, 0x0000'0000'0000'0051,
    0x0000'0000'0000'0029, 0x0000'0000'0000'0014, 0x0000'0000'0000'000A, 0x0000'0000'0000'0005,
    0x0000'0000'0000'0003, 0x0000'0000'0000'0001, 0x0000'0000'0000'0001, 0x0000'0000'0000'0000,
};

/// round(ln(1 + 2^-i) * 2^64).
inline constexpr std::array<std::uint64_t, max_steps> logarithms = {
    0xB172'17F7'D1CF'79AC, 0x67CC'8FB2'FE61'2FCB, 0x391F'EF8F'3534'4358, 0x1E27'076E'2AF2'E5EA,
    0x0F85'1860'08B1'5331, 0x07E0'A6C3'9E0C'C013, 0x03F8'1516'1F80'7C7A, 0x01FE'02A6'B106'7890,
    0x00FF'8055'1588'5E02, 0x007F'E00A'A6AC'439A, 0x003F'F801'5515'621F, 0x001F'FE00'2AA6'AB11,
    0x000F'FF80'0555'1559, 0x0007'FFE0'00AA'A6AB, 0x0003'FFF8'0015'5515, 0x0001'FFFE'0002'AAA7,
    0x0000'FFFF'8000'5555, 0x0000'7FFF'E000'0AAB, 0x0000'3FFF'F800'0155, 0x0000'1FFF'FE00'002B,
    0x0000'0FFF'FF80'0005, 0x0000'07FF'FFE0'0001, 0x0000'03FF'FFF8'0000, 0x0000'01FF'FFFE'0000,
    0x0000'00FF'FFFF'8000, 0x0000'007F'FFFF'E000, 0x0000'003F'FFFF'F800, 0x0000'001F'FFFF'FE00,
    0x0000'000F'FFFF'FF80, 0x0000'0007'FFFF'FFE0, 0x0000'0003'FFFF'FFF8, 0x0000'0001'FFFF'FFFE,
    0x0000'0001'0000'0000, 0x0000'0000'8000'0000, 0x0000'0000'4000'0000, 0x0000'0000'2000'0000,
    0x0000'0000'1000'0000, 0x0000'0000'0800'0000, 0x0000'0000'0400'0000, 0x0000'0000'0200'0000,
    0x0000'0000'0100'0000, 0x0000'0000'0080'0000, 0x0000'0000'0040'0000, 0x0000'0000'0020'0000,
    0x0000'0000'0010'0000, 0x0000'0000'0008'0000, 0x0000'0000'0004'0000, 0x0000'0000'0002'0000,
    0x0000'0000'0001'0000, 0x0000'0000'0000'8000, 0x0000'0000'0000'4000, 0x0000'0000'0000'2000,
    0x0000'0000'0000'1000, 0x0000'0000'0000'0800, 0x0000'0000'0000'0400, 0x0000'0000'0000'0200,
    0x0000'0000'0000'0100, 0x0000'0000'0000'0080, 0x0000'0000'0000'0040, 0x0000'0000'0000'0020,
    0x0000'0000'0000'0010, 0x0000'0000'0000'0008, 0x0000'0000'0000'0004, 0x0000'0000'0000'0002,
};

/// round(2^63 / product of sqrt(1 + 4^-i), i < N) for N = 8 to 32; from there on it stays.
inline constexpr std::array<std::int64_t, 25> gains = {
    0x4DBA'AAA5'C2C8'3BDF, 0x4DBA'83C8'8A9B'422E, 0x4DBA'7A11'3BF4'8F91, 0x4DBA'77A3'6841'2B9D,
    0x4DBA'7707'F353'B72B, 0x4DBA'76E1'1618'5058, 0x4DBA'76D7'5EC9'7607, 0x4DBA'76D4'F0F5'BF69,
    0x4DBA'76D4'5580'D1C1, 0x4DBA'76D4'2EA3'9657, 0x4DBA'76D4'24EC'477D, 0x4DBA'76D4'227E'73C6,
    0x4DBA'76D4'21E2'FED9, 0x4DBA'76D4'21BC'219D, 0x4DBA'76D4'21B2'6A4E, 0x4DBA'76D4'21AF'FC7B,
    0x4DBA'76D4'21AF'6106, 0x4DBA'76D4'21AF'3A28, 0x4DBA'76D4'21AF'3071, 0x4DBA'76D4'21AF'2E03,
    0x4DBA'76D4'21AF'2D68, 0x4DBA'76D4'21AF'2D41, 0x4DBA'76D4'21AF'2D37, 0x4DBA'76D4'21AF'2D35,
    0x4DBA'76D4'21AF'2D34,
};
// clang-format on

/// N rotations are to be multiplied by this; it is times 2^63.
[[nodiscard]] constexpr std::int64_t gain_of(int steps) noexcept
{
    const std::size_t last = gains.size() - 1;
    return gains[std::min(static_cast<std::size_t>(steps - min_steps), last)];
}

/// The logarithms with fewer fraction bits. To the nearest, and every tie downwards: ln(1 + x) lies
/// below the x that 64 bits take it for.
template <int FractionBits>
[[nodiscard]] consteval std::array<std::uint64_t, max_steps> logarithms_in()
{
    std::array<std::uint64_t, max_steps> table = logarithms;
    if constexpr (FractionBits < 64)
        for (std::uint64_t& entry : table)
            entry = (entry + (std::uint64_t{1} << (63 - FractionBits)) - 1) >> (64 - FractionBits);
    return table;
}

} // namespace raymarch::engine::mandelbulb
