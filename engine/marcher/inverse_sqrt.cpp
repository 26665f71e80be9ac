// SPDX-License-Identifier: MIT
#include "engine/marcher/inverse_sqrt.hpp"

#include <array>
#include <bit>

namespace raymarch::engine::marcher
{
namespace
{

constexpr int index_bits = 12;
constexpr int step_bits = 14; ///< bits below the index that interpolate
constexpr std::size_t entries = std::size_t{1} << index_bits;

/// round(2^30 / sqrt(1/2 + i/8192)), from the exact floor of twice that.
consteval std::uint32_t entry(std::uint32_t i)
{
    // (2^31 / sqrt(1/2 + i/8192))^2 = 2^75 / (4096 + i): 2^63 first, then the 12 bits left.
    const std::uint64_t divisor = entries + i;
    std::uint64_t quotient = (std::uint64_t{1} << 63) / divisor;
    const std::uint64_t rest = (std::uint64_t{1} << 63) % divisor;
    quotient = (quotient << 12) + (rest << 12) / divisor;
    std::uint64_t root = 0; // floor(sqrt(quotient)) = floor(2^31 / sqrt(1/2 + i/8192))
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= quotient)
            root += bit;
    return static_cast<std::uint32_t>((root + 1) >> 1);
}

/// One entry more than the source's, 1.0, so that the last step has an end.
consteval std::array<std::uint32_t, entries + 1> make_table()
{
    std::array<std::uint32_t, entries + 1> table{};
    for (std::uint32_t i = 0; i <= entries; ++i)
        table[i] = entry(i);
    return table;
}

constexpr auto table = make_table();

/// round(2^32 / sqrt(2)).
constexpr std::uint64_t half_root = 3'037'000'500;

} // namespace

InverseSqrt inverse_sqrt(std::uint64_t squared) noexcept
{
    const int zeros = std::countl_zero(squared);
    const std::uint64_t normalised = squared << zeros; // 1/2 to 1
    const auto index = static_cast<std::size_t>(normalised >> (63 - index_bits)) & (entries - 1);
    const std::uint32_t step =
        static_cast<std::uint32_t>(normalised >> (63 - index_bits - step_bits)) &
        ((std::uint32_t{1} << step_bits) - 1);

    const std::uint32_t fall = table[index] - table[index + 1];
    std::uint32_t mantissa = table[index] - ((fall * step) >> step_bits);
    if (zeros % 2 != 0) // S is an odd power of two times the normalised value
        mantissa = static_cast<std::uint32_t>((mantissa * half_root) >> 32);
    return {mantissa, 30 - ((zeros - 15) >> 1)};
}

std::uint64_t squared_length(const RawVector& v) noexcept
{
    const auto square = [](std::int32_t a) {
        return static_cast<std::uint64_t>(std::int64_t{a} * a);
    };
    return square(v.x) + square(v.y) + square(v.z);
}

Point normalise(const RawVector& v) noexcept
{
    const std::uint64_t squared = squared_length(v);
    if (squared == 0)
        return {};
    const InverseSqrt inverse = inverse_sqrt(squared);
    return map(v, [&](std::int32_t a) {
        return Coordinate::from_raw((std::int64_t{a} * inverse.mantissa) >> inverse.shift);
    });
}

Coordinate length(const Point& p) noexcept
{
    const std::uint64_t squared = squared_length(raw(p));
    if (squared == 0)
        return {};
    // |p| = S / sqrt(S), with the upper 32 bits of the normalised S.
    const InverseSqrt inverse = inverse_sqrt(squared);
    const int zeros = std::countl_zero(squared);
    const std::uint64_t upper = (squared << zeros) >> 32;
    return Coordinate::from_raw((upper * inverse.mantissa) >> (inverse.shift + zeros - 8));
}

} // namespace raymarch::engine::marcher
