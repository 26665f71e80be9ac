// SPDX-License-Identifier: MIT
/// @file
/// The short way of a whole frame: all pairs at once, in the vector registers of the processor.
///
/// A host sends the same keys with numbers like `-0.123` over and over. Such a line is taken apart
/// by vectors: commas are found 64 bytes at a time, four pairs are checked and quantised together.
/// Whatever else a line may hold, blanks, small letters, exponents, more decimals, any fault, is
/// left to the definition in assignments.hpp, which then reads the line from its beginning. So this
/// has one answer only: the codes, or "not mine".
///
/// What is compared and multiplied is computed here from the parameter table, at compile time. The
/// vectors are frame_lanes.cpp.
#pragma once

#include "protocol/parameters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{

inline constexpr std::size_t lanes_per_block = 4;
inline constexpr std::size_t max_lanes = 32;
/// Longer frames go the long way.
inline constexpr std::size_t max_lanes_text = 256;

/// The name of a choice as the last bytes before a comma: in two numbers of eight bytes, of which
/// the latter ends with the name's last letter.
struct LaneChoice
{
    std::uint8_t lane = 0;
    std::uint8_t code = 0;
    std::uint8_t length = 0;
    std::array<std::uint64_t, 2> bits{};
    std::array<std::uint64_t, 2> masks{};
};

/// One lane a parameter, in table order: first the numbers, in whole blocks, then the choices.
struct FrameLanes
{
    template <typename T>
    using Lanes = std::array<T, max_lanes>;

    // `KEY=` at the front of a pair: KeyFront.
    alignas(32) Lanes<std::uint64_t> key_bits{};
    alignas(32) Lanes<std::uint64_t> key_mask{};
    /// 64 plus the bits from the comma before a pair to its value.
    alignas(32) Lanes<std::uint64_t> value_begin{};
    /// The most thousandths, without a minus sign and with one.
    alignas(32) Lanes<std::int64_t> most{};
    alignas(32) Lanes<std::int64_t> most_negative{};
    /// Codes of a thousandth in units of 2^-32, rounded up; and its upper half.
    alignas(32) Lanes<std::uint64_t> factor{};
    alignas(32) Lanes<std::uint64_t> factor_high{};
    alignas(32) Lanes<std::int64_t> largest_code{};

    std::size_t size = 0;
    std::size_t numbers = 0;

    std::array<LaneChoice, 16> choices{};
    std::size_t choice_count = 0;

    /// The lane of a pair from the hash of its first two bytes.
    std::array<std::uint8_t, 64> lane_of_hash{};
    std::uint32_t hash_factor = 0;
};

/// Where in lane_of_hash the key is looked for that the eight bytes begin with.
[[nodiscard]] constexpr std::size_t lane_hash(std::uint64_t front, std::uint32_t factor) noexcept
{
    return (static_cast<std::uint32_t>(front & 0xFFFF) * factor) >> 26;
}

/// Whether this processor has the vectors. Where it has none, no frame is taken.
[[nodiscard]] bool has_frame_lanes() noexcept;

/// Reads a frame into the front of `state`. False for a frame that is not taken, faulty or not;
/// then the codes of the frame's parameters are any. Made once for each table, in frame_lanes.cpp,
/// so that what the table says stands in the instructions.
template <const FrameLanes& lanes>
[[nodiscard]] bool read_frame_by_lanes(std::string_view text, State& state) noexcept;

// ------------------------------------------------------------------------------------------------

namespace detail
{

// Not consteval: clang 14 would not take a call of that with a row of a table that is a parameter.

/// The most that is taken: a thousand times as much stays below 2^32, see quantize_four().
inline constexpr std::int64_t most_thousandths = 4'294'966;

constexpr std::int64_t thousandths(std::int64_t scaled, int fraction_bits)
{
    return std::min(scaled * 1000 >> fraction_bits, most_thousandths);
}

/// Whether a number goes through a lane. With three fraction bits or more, no number of three
/// decimals lies half-way between two codes; a code fits the lower half of its lane, with its sign.
constexpr bool fits_number_lane(const Parameter& parameter)
{
    return !parameter.is_choice() && !parameter.is_tail() && parameter.tail_bits == 0 &&
           parameter.front.length > 0 && parameter.code_fraction_bits() >= 3 &&
           parameter.code_fraction_bits() < 32 && parameter.min_scaled <= 0 &&
           parameter.max_scaled >= 0 && -parameter.min_scaled <= INT32_MAX &&
           parameter.max_scaled <= INT32_MAX;
}

constexpr bool fits_choice_lane(const Parameter& parameter)
{
    return parameter.is_choice() && parameter.front.length > 0 &&
           std::ranges::all_of(parameter.choices,
                               [](std::string_view name) { return name.size() <= 16; });
}

constexpr void add_choices(FrameLanes& lanes, std::size_t lane, const Parameter& parameter)
{
    for (std::size_t code = 0; code < parameter.choices.size(); ++code) {
        const std::string_view name = parameter.choices[code];
        LaneChoice& choice = lanes.choices[lanes.choice_count++];
        choice.lane = static_cast<std::uint8_t>(lane);
        choice.code = static_cast<std::uint8_t>(code);
        choice.length = static_cast<std::uint8_t>(name.size());
        for (std::size_t i = 0; i < name.size(); ++i) {
            const std::size_t at = 16 - name.size() + i;
            choice.bits[at / 8] |= std::uint64_t{static_cast<std::uint8_t>(name[i])} << at % 8 * 8;
            choice.masks[at / 8] |= std::uint64_t{0xFF} << at % 8 * 8;
        }
    }
}

/// A factor that gives each key a place of its own; 0 when two keys begin with the same two bytes.
constexpr std::uint32_t find_hash_factor(const FrameLanes& lanes)
{
    for (std::uint32_t factor = 0x9E37'79B1; factor < 0x9E37'79B1 + 20'000; factor += 2) {
        std::uint64_t used = 0;
        bool good = true;
        for (std::size_t i = 0; good && i < lanes.size; ++i) {
            const std::uint64_t bit = std::uint64_t{1} << lane_hash(lanes.key_bits[i], factor);
            good = (used & bit) == 0;
            used |= bit;
        }
        if (good)
            return factor;
    }
    return 0;
}

} // namespace detail

/// The lanes of a table, of size 0 where it cannot have any: its frame is not its first rows, one
/// of these does not fit its lane, or the numbers do not fill their blocks.
template <std::size_t N>
consteval FrameLanes frame_lanes_of(const std::array<Parameter, N>& table)
{
    FrameLanes lanes;
    for (const Parameter& parameter : table) {
        if (parameter.is_row())
            break;
        const std::size_t i = lanes.size++;
        const bool is_number = detail::fits_number_lane(parameter) && lanes.numbers == i;
        if (i >= max_lanes - lanes_per_block || !(is_number || detail::fits_choice_lane(parameter)))
            return {};
        lanes.key_bits[i] = parameter.front.bits;
        lanes.key_mask[i] = parameter.front.mask;
        lanes.value_begin[i] = 64 + 8 * (parameter.front.length + 1U);
        if (!is_number) {
            if (lanes.choice_count + parameter.choices.size() > lanes.choices.size())
                return {};
            detail::add_choices(lanes, i, parameter);
            continue;
        }
        ++lanes.numbers;
        const int fraction_bits = parameter.code_fraction_bits();
        lanes.most[i] = detail::thousandths(parameter.max_scaled, fraction_bits);
        lanes.most_negative[i] = detail::thousandths(-parameter.min_scaled, fraction_bits);
        lanes.factor[i] = ((std::uint64_t{1} << (32 + fraction_bits)) + 999) / 1000;
        lanes.factor_high[i] = lanes.factor[i] >> 32;
        lanes.largest_code[i] = std::min<std::int64_t>(parameter.largest_code, INT32_MAX);
    }
    lanes.hash_factor = detail::find_hash_factor(lanes);
    const bool rows_behind = std::ranges::all_of(table.begin() + lanes.size, table.end(),
                                                 [](const Parameter& row) { return row.is_row(); });
    if (lanes.hash_factor == 0 || !rows_behind || lanes.numbers < lanes_per_block ||
        lanes.numbers % lanes_per_block != 0)
        return {};
    for (std::size_t i = 0; i < lanes.size; ++i)
        lanes.lane_of_hash[lane_hash(lanes.key_bits[i], lanes.hash_factor)] =
            static_cast<std::uint8_t>(i);
    return lanes;
}

} // namespace raymarch::protocol
