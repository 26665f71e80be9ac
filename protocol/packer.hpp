// SPDX-License-Identifier: MIT
/// @file
/// Packs codes into register words. The compiler makes code without branches from a parameter
/// table.
///
/// Two successive words are treated as one number of 64 bits, whose upper half is the first word.
/// So most parameters that span words are one piece.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace raymarch::protocol
{
namespace detail
{

/// Bits of one code that are adjacent in one pair of words.
struct PackedPiece
{
    ParameterIndex parameter = 0;
    std::uint8_t shift = 0; ///< how many lower bits of the code are in other pieces
    std::uint8_t lsb = 0;   ///< the lowest bit of the piece in the pair
    std::uint16_t pair = 0;
    std::uint64_t mask = 0;
};

template <std::size_t N>
struct PackedPieces
{
    std::array<PackedPiece, max_slices * N> rows{};
    std::size_t count = 0;
    std::size_t words = 0;
};

template <std::size_t N>
consteval PackedPieces<N> packed_pieces(const std::array<Parameter, N>& table)
{
    PackedPieces<N> pieces;
    for (std::size_t i = 0; i < N; ++i) {
        PackedPiece* above = nullptr; // the previous slice, with the upper bits of the same code
        for (const Slice& slice : table[i].placement()) {
            pieces.words = pieces.words > slice.word ? pieces.words : slice.word + 1U;
            const auto pair = static_cast<std::uint16_t>(slice.word / 2);
            const auto lsb = static_cast<std::uint8_t>(slice.lsb + (slice.word % 2 == 0 ? 32 : 0));
            if (above != nullptr && above->pair == pair && above->lsb == lsb + slice.width()) {
                above->mask = above->mask << slice.width() | slice.mask;
                above->shift = slice.shift;
                above->lsb = lsb;
                continue;
            }
            above = &pieces.rows[pieces.count++];
            *above = {static_cast<ParameterIndex>(i), slice.shift, lsb, pair, slice.mask};
        }
    }
    return pieces;
}

template <const auto& Table>
inline constexpr auto packed_pieces_of = packed_pieces(Table);

} // namespace detail

/// Packs the codes of `state` into `words`, which must be zero before. It is not inlined: next to
/// the code that has just stored the codes, gcc would load two codes at once, and that load would
/// have to wait until both stores are complete.
template <const auto& Table>
[[gnu::noinline]] constexpr void pack_table(const State& state, Words& words) noexcept
{
    constexpr auto& pieces = detail::packed_pieces_of<Table>;
    std::array<std::uint64_t, (pieces.words + 1) / 2> sums{};
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        ((sums[pieces.rows[I].pair] |=
          (static_cast<std::uint64_t>(state.codes[pieces.rows[I].parameter]) >>
               pieces.rows[I].shift &
           pieces.rows[I].mask)
          << pieces.rows[I].lsb),
         ...);
    }
    (std::make_index_sequence<pieces.count>());
    for (std::size_t i = 0; i < pieces.words; ++i)
        words[i] = static_cast<std::uint32_t>(i % 2 == 0 ? sums[i / 2] >> 32 : sums[i / 2]);
}

} // namespace raymarch::protocol
