// SPDX-License-Identifier: MIT
/// @file
/// The inputs of one step of a movement. They come from keys, from buttons, from WALK and TURN, or
/// from the timer of ANIMATE.
#pragma once

#include <cstdint>

namespace raymarch::motion
{

enum class Input : std::uint8_t {
    Forward,
    Back,
    StrafeLeft,
    StrafeRight,
    Up,
    Down,
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
    RollLeft,
    RollRight,
    Widen, ///< makes the field of view wider
    Narrow,
    Animate, ///< the movement that the accelerator's scene makes by itself
};

/// A set of inputs.
class Inputs
{
  public:
    constexpr Inputs() noexcept = default;
    constexpr Inputs(Input input) noexcept
        : bits_(bit(input)) {} // NOLINT(*-explicit-*): one input is a set

    [[nodiscard]] constexpr bool has(Input input) const noexcept
    {
        return (bits_ & bit(input)) != 0;
    }
    [[nodiscard]] friend constexpr Inputs operator|(Inputs a, Inputs b) noexcept
    {
        Inputs both;
        both.bits_ = a.bits_ | b.bits_;
        return both;
    }
    bool operator==(const Inputs&) const = default;

  private:
    static constexpr std::uint32_t bit(Input input) noexcept
    {
        return std::uint32_t{1} << static_cast<unsigned>(input);
    }
    std::uint32_t bits_ = 0;
};

} // namespace raymarch::motion
