// SPDX-License-Identifier: MIT
#include "engine/fractal/inverse_sqrt.hpp"

#include <bit>

namespace raymarch::engine::fractal
{
namespace
{

constexpr Number root_two = word(92681);
constexpr Number half_root = word(46340); ///< 1 / sqrt(2)
constexpr Number slope = word(54291);     ///< 2 * (sqrt(2) - 1): from sqrt(2) at 1/2 to 1 at 1
constexpr int rounds = 2;

} // namespace

Number inverse_sqrt(Number a) noexcept
{
    // 2^k is the power of two that brings `a` to between 1/2 and 1; none above 1 for smaller words.
    const auto integer = static_cast<std::uint32_t>(shift_right(a, Number::fraction_bits).raw());
    const auto k = static_cast<unsigned>(std::bit_width(integer));
    const Number mantissa = shift_right(a, k);

    Number root = root_two - multiply(slope, mantissa - half);
    const Number halved = shift_right(mantissa, 1); // loses a bit before the product, not after it
    for (int round = 0; round < rounds; ++round) {
        const Number square = multiply(root, root);
        root = multiply(root, three_halves - multiply(halved, square));
    }
    root = shift_right(root, k / 2);
    return k % 2 != 0 ? multiply(root, half_root) : root;
}

} // namespace raymarch::engine::fractal
