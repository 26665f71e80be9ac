// SPDX-License-Identifier: MIT
/// @file
/// The arithmetic of the ray tracer's kernels against the scalar model's: every square root, and
/// divisions at and beside each border. Compiled once for each instruction set.
#include "engine/whitted/arithmetic.hpp"

#include "engine/fast/targets.hpp"

#include "tests/engine/whitted/report.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/identity/whitted_arithmetic_test.cpp"
#include <hwy/foreach_target.h>

#include "engine/fast/compress-inl.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// Calls `function` on the vectors of n and d.
template <typename Function>
void for_vectors(const std::int32_t* n, const std::int32_t* d, std::int32_t* to, std::size_t count,
                 Function function)
{
    for (std::size_t i = 0; i < count; i += lanes<I32>)
        hn::StoreU(function(hn::LoadU(I32(), n + i), hn::LoadU(I32(), d + i)), I32(), to + i);
}

void roots(const std::int32_t* v, const std::int32_t*, std::int32_t* to, std::size_t count)
{
    for_vectors(v, v, to, count, [](Vec<I32> a, Vec<I32>) { return square_root(a); });
}

void quotients(const std::int32_t* n, const std::int32_t* d, std::int32_t* to, std::size_t count)
{
    for_vectors(n, d, to, count, [](Vec<I32> a, Vec<I32> b) {
        return divide(a, b, hn::Div(Set<F32>(4096.0F), real(b)));
    });
}

void quotients_of_negated(const std::int32_t* n, const std::int32_t* d, std::int32_t* to,
                          std::size_t count)
{
    for_vectors(n, d, to, count, [](Vec<I32> a, Vec<I32> b) { return divide_by_negated(a, b); });
}

void products(const std::int32_t* n, const std::int32_t* d, std::int32_t* to, std::size_t count)
{
    for_vectors(n, d, to, count, [](Vec<I32> a, Vec<I32> b) { return scaled({a, a, a}, b).y; });
}

/// The lanes of n where d is not 0, one behind the other from `to` on.
void packed(const std::int32_t* n, const std::int32_t* d, std::int32_t* to, std::size_t count)
{
    for (std::size_t i = 0; i < count; i += lanes<I32>) {
        const Compress<I32> compress(hn::Ne(hn::LoadU(I32(), d + i), hn::Zero(I32())));
        compress.store(hn::LoadU(I32(), n + i), to);
        to += compress.count();
    }
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raymarch::engine::whitted::fast
{
namespace
{

HWY_EXPORT(roots);
HWY_EXPORT(quotients);
HWY_EXPORT(quotients_of_negated);
HWY_EXPORT(products);
HWY_EXPORT(packed);

constexpr bool optimised = test::optimised;
constexpr std::size_t block = 4096;
using Numbers = std::array<std::int32_t, block>;

/// Each set of instructions that this machine has takes its turn.
class WhittedLanes : public testing::TestWithParam<std::int64_t>
{
  protected:
    void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};

TEST_P(WhittedLanes, RootsOfAllArguments)
{
    constexpr std::size_t stride = optimised ? 1 : 61;
    Numbers v{};
    Numbers roots{};
    for (std::size_t first = 0; first < 1U << 24; first += block * stride) {
        for (std::size_t i = 0; i < block; ++i)
            v[i] = static_cast<std::int32_t>((first + i * stride) & ((1U << 24) - 1));
        HWY_DYNAMIC_DISPATCH(roots)(v.data(), v.data(), roots.data(), block);
        for (std::size_t i = 0; i < block; ++i)
            ASSERT_EQ(roots[i], square_root(static_cast<std::uint32_t>(v[i])).raw()) << v[i];
    }
}

using Operation = void (*)(const std::int32_t*, const std::int32_t*, std::int32_t*, std::size_t);

/// Fills n and d until `more` has no more of them, and compares what becomes of them.
template <typename More, typename Expected>
void expect_same(Operation operation, More more, Expected expected)
{
    Numbers n{};
    Numbers d{};
    Numbers result{};
    bool left = true;
    while (left) {
        for (std::size_t i = 0; i < block; ++i)
            left = more(n[i], d[i]) && left;
        operation(n.data(), d.data(), result.data(), block);
        for (std::size_t i = 0; i < block; ++i)
            ASSERT_EQ(result[i], expected(n[i], d[i])) << n[i] << " and " << d[i];
    }
}

std::int32_t divided(std::int32_t n, std::int32_t d)
{
    return divide(Word::from_raw(n), Word::from_raw(d)).raw();
}

TEST_P(WhittedLanes, QuotientsAroundWholeNumbers)
{
    // For each length: numerators whose quotient is at or just beside each of some whole numbers.
    std::int32_t length = bounds::least_length;
    std::int32_t step = 0;
    const auto more = [&](std::int32_t& n, std::int32_t& d) {
        constexpr std::int32_t steps = optimised ? 1060 : 106; // up to bounds::direction
        constexpr std::int32_t between = 2 * bounds::direction / steps;
        const std::int32_t whole = step / 3 * between - bounds::direction;
        d = length;
        n = static_cast<std::int32_t>(std::int64_t{whole} * d / 4096) + step % 3 - 1;
        if (++step > 3 * steps) {
            step = 0;
            length += optimised ? 1 + length / 256 : 1 + length / 16;
        }
        return length < 1 << 18;
    };
    expect_same(HWY_DYNAMIC_DISPATCH(quotients), more, divided);
}

TEST_P(WhittedLanes, QuotientsOfAReflection)
{
    // What is normalised after a reflection is short: all lengths, numerators up to them.
    std::int32_t length = bounds::least_length;
    std::int32_t n_now = -2 * length;
    const auto more = [&](std::int32_t& n, std::int32_t& d) {
        d = length;
        n = n_now;
        if (++n_now > d + d / 16) {
            length += optimised ? 1 : 401;
            n_now = -(length + length / 16);
        }
        return length < (optimised ? 6200 : 8192);
    };
    expect_same(HWY_DYNAMIC_DISPATCH(quotients), more, divided);
}

TEST_P(WhittedLanes, RandomQuotientsByTheDistanceToThePlane)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    int left = optimised ? 20'000'000 : 200'000;
    const auto more = [&](std::int32_t& n, std::int32_t& d) {
        d = 1 << raymarch::test::pick(random, 0, 13);
        d = raymarch::test::pick(random, (d + 1) / 2, d);
        n = raymarch::test::pick(random, -(1 << 23), (1 << 23) - 1);
        switch (raymarch::test::pick(random, 0, 3)) {
        case 0: // a multiple, or beside one
            n = std::clamp(n / d * d + raymarch::test::pick(random, -1, 1), -(1 << 23),
                           (1 << 23) - 1);
            break;
        case 1: // an end of the range
            n = n < 0 ? -(1 << 23) : (1 << 23) - 1;
            break;
        case 2: // a small one
            n >>= raymarch::test::pick(random, 0, 23);
            break;
        default:
            break;
        }
        return --left > 0;
    };
    expect_same(HWY_DYNAMIC_DISPATCH(quotients_of_negated), more,
                [](std::int32_t n, std::int32_t d) { return divided(n, -d); });
}

TEST_P(WhittedLanes, ProductsOfDirectionsAndWords)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    int left = optimised ? 5'000'000 : 200'000;
    const auto more = [&](std::int32_t& n, std::int32_t& d) {
        n = raymarch::test::pick(random, -bounds::direction, bounds::direction);
        d = raymarch::test::pick(random, -(1 << 23), (1 << 23) - 1) >>
            raymarch::test::pick(random, 0, 23);
        return --left > 0;
    };
    expect_same(HWY_DYNAMIC_DISPATCH(products), more, [](std::int32_t n, std::int32_t d) {
        return static_cast<std::int32_t>((std::int64_t{n} * d) >> fraction_bits);
    });
}

TEST_P(WhittedLanes, PackingKeepsTheOrder)
{
    // All sets of eight lanes, and vectors of others as they come.
    Numbers n{};
    Numbers chosen{};
    std::array<std::int32_t, block + 16> to{};
    std::size_t count = 0;
    Numbers expected{};
    for (std::size_t i = 0; i < block; ++i) {
        n[i] = static_cast<std::int32_t>(i);
        chosen[i] = static_cast<std::int32_t>(i / 8 >> i % 8 & 1);
        if (chosen[i] != 0)
            expected[count++] = n[i];
    }
    HWY_DYNAMIC_DISPATCH(packed)(n.data(), chosen.data(), to.data(), block);
    EXPECT_TRUE(std::equal(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count),
                           to.begin()));
}

INSTANTIATE_TEST_SUITE_P(Identity, WhittedLanes,
                         testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& of) { return std::string(hwy::TargetName(of.param)); });

} // namespace
} // namespace raymarch::engine::whitted::fast
#endif
