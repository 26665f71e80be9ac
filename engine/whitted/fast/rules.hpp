// SPDX-License-Identifier: MIT
/// @file
/// A kernel is compiled for the defects of a profile, and with or without a count of costs.
#pragma once

#include "engine/whitted/profile.hpp"

namespace raymarch::engine::whitted::fast
{

enum class Counting : bool { Off, On };

template <Profile P, Counting C>
struct Rules
{
    static constexpr Profile profile = P;
    static constexpr bool counts = C == Counting::On;
    static constexpr bool has(Defect defect) noexcept { return Defects(P).has(defect); }
};

/// Primary rays start from the eye, which is in no sphere; reflected ones from what they left.
enum class Generation : bool { Primary, Reflected };

} // namespace raymarch::engine::whitted::fast
