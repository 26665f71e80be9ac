// SPDX-License-Identifier: MIT
#include "engine/mandelbulb/int128.hpp"

#include <gtest/gtest.h>

#include <random>

namespace raymarch::engine::mandelbulb
{
namespace
{

TEST(Int128, LimitsByHand)
{
    const PortableInt128 one = 1;
    const PortableInt128 minus_one = -1;
    EXPECT_TRUE(minus_one < one && minus_one < 0 && one > 0);
    EXPECT_TRUE(minus_one + one == 0);
    EXPECT_TRUE((minus_one >> 127) == minus_one); // floors
    EXPECT_TRUE((one << 64) - 1 == PortableInt128(~std::uint64_t{0}));
    EXPECT_TRUE(minus_one * minus_one == one);
    EXPECT_EQ(static_cast<std::uint64_t>((one << 100) >> 40), std::uint64_t{1} << 60);
    EXPECT_EQ(high_product(~std::uint64_t{0}, ~std::uint64_t{0}), ~std::uint64_t{1});
    EXPECT_EQ(leading_one(one << 64), 64);
    EXPECT_EQ(leading_one((one << 64) - one), 63);
    EXPECT_EQ(leading_one(std::uint64_t{1}), 0);
}

#ifdef __SIZEOF_INT128__ // 32-bit targets have only ours

NativeInt128 native(PortableInt128 a)
{
    return (NativeInt128(static_cast<std::int64_t>(a >> 64)) << 64) +
           NativeInt128(static_cast<std::uint64_t>(a));
}

/// 128 bits; every length is as likely as any other.
PortableInt128 any(std::mt19937_64& random)
{
    return ((PortableInt128(random()) << 64) ^ PortableInt128(random())) >>
           static_cast<int>(random() % 128);
}

TEST(Int128, OwnTypeAgreesWithTheCompilersType)
{
    std::mt19937_64 random(128);
    for (int i = 0; i < 20'000; ++i) {
        const PortableInt128 a = any(random);
        const PortableInt128 b = any(random);
        const auto by = static_cast<int>(random() % 128);
        ASSERT_TRUE(native(a >> by) == native(a) >> by);
        ASSERT_TRUE(native(a << by) == native(a) << by);
        ASSERT_TRUE(native(a ^ b) == (native(a) ^ native(b)));
        ASSERT_EQ(a < b, native(a) < native(b));
        ASSERT_EQ(a == b, native(a) == native(b));
        const PortableInt128 c = a >> 2; // their sums do not overflow
        const PortableInt128 d = b >> 2;
        ASSERT_TRUE(native(c + d) == native(c) + native(d));
        ASSERT_TRUE(native(c - d) == native(c) - native(d));
        const PortableInt128 e = a >> 65; // nor this product
        const PortableInt128 f = b >> 65;
        ASSERT_TRUE(native(e * f) == native(e) * native(f));
        if (a > 0) {
            ASSERT_EQ(leading_one(a), leading_one(native(a)));
        }
    }
}

#endif

} // namespace
} // namespace raymarch::engine::mandelbulb
