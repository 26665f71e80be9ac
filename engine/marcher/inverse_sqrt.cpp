// SPDX-License-Identifier: MIT
#include "engine/marcher/inverse_sqrt.hpp"

#include "engine/marcher/inverse_sqrt_table.hpp"

#include <bit>

namespace raymarch::engine::marcher
{
using namespace inverse_sqrt_table;

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
