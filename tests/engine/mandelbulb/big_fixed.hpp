// SPDX-License-Identifier: MIT
/// @file
/// Unsigned fixed point with 64 integer and 256 fraction bits, by schoolbook arithmetic: what the
/// tables are computed with again.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::mandelbulb
{

class BigFixed
{
  public:
    static constexpr std::size_t fraction_limbs = 8;

    explicit BigFixed(std::uint64_t integer)
    {
        limbs_[fraction_limbs] = static_cast<std::uint32_t>(integer);
        limbs_[fraction_limbs + 1] = static_cast<std::uint32_t>(integer >> 32);
    }

    friend BigFixed operator+(BigFixed a, const BigFixed& b)
    {
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
            carry += std::uint64_t{a.limbs_[i]} + b.limbs_[i];
            a.limbs_[i] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        return a;
    }
    friend BigFixed operator-(BigFixed a, const BigFixed& b)
    {
        for (std::size_t i = 0; i < a.limbs_.size(); ++i)
            a.limbs_[i] ^= ~std::uint32_t{0}; // -(-a - 1 + b) - 1 = a - b
        a = a + b;
        for (std::size_t i = 0; i < a.limbs_.size(); ++i)
            a.limbs_[i] ^= ~std::uint32_t{0};
        return a;
    }
    friend BigFixed operator*(BigFixed a, std::uint32_t factor)
    {
        std::uint64_t carry = 0;
        for (std::uint32_t& limb : a.limbs_) {
            carry += std::uint64_t{limb} * factor;
            limb = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        return a;
    }
    friend BigFixed operator/(BigFixed a, std::uint32_t divisor)
    {
        std::uint64_t rest = 0;
        for (std::size_t i = a.limbs_.size(); i-- > 0;) {
            rest = rest << 32 | a.limbs_[i];
            a.limbs_[i] = static_cast<std::uint32_t>(rest / divisor);
            rest %= divisor;
        }
        return a;
    }
    friend BigFixed operator>>(BigFixed a, int bits)
    {
        for (; bits >= 31; bits -= 31)
            a = a / (std::uint32_t{1} << 31);
        return a / (std::uint32_t{1} << bits);
    }
    /// By an integer of 64 bits.
    friend BigFixed times(const BigFixed& a, std::uint64_t factor)
    {
        BigFixed upper = a * static_cast<std::uint32_t>(factor >> 32);
        for (std::size_t i = upper.limbs_.size(); i-- > 1;)
            upper.limbs_[i] = upper.limbs_[i - 1];
        upper.limbs_[0] = 0;
        return upper + a * static_cast<std::uint32_t>(factor);
    }
    friend std::strong_ordering operator<=>(const BigFixed& a, const BigFixed& b)
    {
        for (std::size_t i = a.limbs_.size(); i-- > 0;)
            if (a.limbs_[i] != b.limbs_[i])
                return a.limbs_[i] <=> b.limbs_[i];
        return std::strong_ordering::equal;
    }
    friend bool operator==(const BigFixed&, const BigFixed&) = default;

  private:
    std::array<std::uint32_t, fraction_limbs + 2> limbs_{}; // the lowest first
};

} // namespace raymarch::engine::mandelbulb
