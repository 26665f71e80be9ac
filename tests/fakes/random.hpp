// SPDX-License-Identifier: MIT
/// @file
/// The seed of the random tests: printed, and taken from RAYMARCH_SEED where that is set.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace raymarch::test
{

[[nodiscard]] inline std::mt19937_64 seeded_random()
{
    const char* const text = std::getenv("RAYMARCH_SEED"); // NOLINT(concurrency-mt-unsafe)
    const std::uint64_t seed = text == nullptr ? 1 : std::stoull(text);
    std::cout << "RAYMARCH_SEED=" << seed << '\n';
    return std::mt19937_64(seed);
}

/// Evenly from `low` to `high`, both included.
template <typename Integer>
[[nodiscard]] Integer pick(std::mt19937_64& random, Integer low, Integer high)
{
    return std::uniform_int_distribution<Integer>(low, high)(random);
}

} // namespace raymarch::test
