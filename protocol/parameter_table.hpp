// SPDX-License-Identifier: MIT
/// @file
/// The tools to write a parameter table. Its rows have designated initialisers and are passed
/// through `complete`, which computes the codes of ranges and defaults from their decimal text. A
/// table that contradicts itself does not compile. A table within the table (`S1.X` to `S14.R`) is
/// one pattern, repeated by `repeated_rows`.
#pragma once

#include "protocol/parameters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

namespace detail
{

/// Is called for a table that contradicts itself. It is not constexpr, so compilation stops there.
inline void table_error(const char* /*what*/) {}

consteval std::int64_t bound(std::string_view text, int fraction_bits)
{
    const std::optional<Decimal> value = parse_decimal(text);
    if (!value)
        table_error("a bound is no number");
    const Scaled scaled = scale(*value, fraction_bits);
    if (scaled.inexact)
        table_error("a bound is no multiple of the format's unit");
    const auto magnitude = static_cast<std::int64_t>(scaled.floor);
    return value->negative ? -magnitude : magnitude;
}

consteval Limits limits(std::int64_t least, std::int64_t most)
{
    if (most < 0)
        return {};
    return {.least = least > 0 ? static_cast<std::uint64_t>(least) * 2 : 0,
            .first_above = static_cast<std::uint64_t>(most) * 2 + 1};
}

consteval void complete_row(Parameter& row)
{
    const Format own = {.is_signed = row.format.is_signed,
                        .integer_bits = row.format.integer_bits,
                        .fraction_bits = static_cast<std::uint8_t>(row.code_fraction_bits())};
    row.largest_code = own.max_code();
    int below = row.code_width();
    for (Slice& slice : std::span(row.slices).first(row.slice_count)) {
        below -= slice.width();
        slice.shift = static_cast<std::uint8_t>(below);
        slice.mask = static_cast<std::uint32_t>((std::uint64_t{1} << slice.width()) - 1);
    }
    if (row.is_choice()) {
        row.max_scaled = static_cast<std::int64_t>(row.choices.size()) - 1;
        const std::optional<std::int64_t> code = find_choice(row, row.initial);
        if (!code)
            table_error("the default is none of the choices");
        row.initial_code = *code;
    } else {
        row.min_scaled = bound(row.min, own.fraction_bits);
        row.max_scaled = bound(row.max, own.fraction_bits);
        row.initial_code = bound(row.initial, own.fraction_bits);
        if (row.initial_code < row.min_scaled || row.initial_code > row.max_scaled)
            table_error("the default is out of range");
        row.positive = limits(row.min_scaled, row.max_scaled);
        row.negative = limits(-row.max_scaled, -row.min_scaled);
        if (row.initial_code > own.max_code()) // the default is 1.0, and the format ends below it
            row.initial_code = own.max_code();
    }
    // The upper end may lie one code above the format (1.0 in Q1.17); the lower one may not.
    if (row.min_scaled < own.min_code() || row.max_scaled - 1 > own.max_code())
        table_error("the range does not fit the format");
    if (row.tail_bits > 0 && row.max_scaled > own.max_code())
        table_error("a number with a tail cannot end above its format");
    int width = 0;
    for (const Slice& slice : row.placement())
        width += slice.width();
    if (row.slice_count > 0 && width != row.code_width())
        table_error("the slices are not as wide as the format");
}

} // namespace detail

/// Fills in the computed members of a table and checks it. Keys must be unique and upper case,
/// ranges and defaults must fit their formats, slices must be as wide as the format, and no bit of
/// a register may be used twice.
template <std::size_t N>
consteval std::array<Parameter, N> complete(std::array<Parameter, N> table)
{
    static_assert(N < max_parameters, "an index one past the end must fit ParameterIndex");
    std::array<std::uint32_t, max_parameter_words> used{};
    for (std::size_t i = 0; i < N; ++i) {
        Parameter& row = table[i];
        detail::complete_row(row);
        if (i > 0 && (table[i - 1].tail_bits > 0) != row.is_tail())
            detail::table_error("a tail and the row before it do not belong together");
        if (row.is_tail() && row.format.width() != table[i - 1].tail_bits)
            detail::table_error("a tail is not as wide as the row before it says");
        for (const char c : row.key)
            if (to_upper(c) != c)
                detail::table_error("a key is not upper case");
        for (std::size_t j = 0; j < i; ++j)
            if (!row.is_tail() && table[j].key == row.key)
                detail::table_error("a key stands twice");
        for (const Slice& slice : row.placement()) {
            const auto mask =
                static_cast<std::uint32_t>(((std::uint64_t{1} << slice.width()) - 1) << slice.lsb);
            if (used[slice.word] & mask)
                detail::table_error("two parameters share a bit");
            used[slice.word] |= mask;
        }
    }
    return table;
}

/// The parameters that a complete frame names: all values except rows of a table within the table.
template <std::size_t N>
consteval ParameterSet frame_of(const std::array<Parameter, N>& table)
{
    ParameterSet frame;
    for (std::size_t i = 0; i < N; ++i)
        frame.set(i, !table[i].is_row() && !table[i].is_tail());
    return frame;
}

/// Makes the row for the lower bits of a wide number. The previous row must say `.tail_bits = 32`.
consteval Parameter tail_of(const Parameter& upper, std::array<Slice, max_slices> slices,
                            std::uint8_t slice_count)
{
    Parameter tail;
    tail.meaning = upper.meaning;
    tail.group = upper.group;
    tail.format = unsigned_q(upper.tail_bits, 0);
    tail.min = tail.initial = "0";
    tail.max = upper.tail_bits == 32 ? "4294967295" : "";
    tail.slices = slices;
    tail.slice_count = slice_count;
    return tail;
}

/// A piece of a key as a template argument.
template <std::size_t N>
struct KeyPart
{
    std::array<char, N> text{};
    // NOLINTNEXTLINE(*-explicit-*, *-avoid-c-arrays): written as a plain literal
    consteval KeyPart(const char (&literal)[N]) { std::copy_n(literal, N, text.begin()); }
    [[nodiscard]] constexpr std::string_view view() const { return {text.data(), N - 1}; }
};

/// The keys of a table within the table: RowKeys<"S", 3, "X", "Y">::at(1, 0) is "S2.X".
template <KeyPart Prefix, std::size_t Rows, KeyPart... Columns>
struct RowKeys
{
    static constexpr std::size_t rows = Rows;
    static constexpr std::size_t columns = sizeof...(Columns);

    [[nodiscard]] static constexpr std::string_view at(std::size_t row, std::size_t column)
    {
        const Text& key = storage[row * columns + column];
        return {key.text.data(), key.size};
    }

  private:
    struct Text
    {
        std::array<char, 16> text{};
        std::size_t size = 0;
    };
    static constexpr auto make() // not consteval: clang 14 would not take it
    {
        std::array<Text, Rows * sizeof...(Columns)> keys{};
        const std::array<std::string_view, sizeof...(Columns)> names = {Columns.view()...};
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto append = [&](char c) { keys[i].text[keys[i].size++] = c; };
            const std::size_t number = i / names.size() + 1;
            for (const char c : Prefix.view())
                append(c);
            if (number >= 10)
                append(static_cast<char>('0' + number / 10));
            append(static_cast<char>('0' + number % 10));
            append('.');
            for (const char c : names[i % names.size()])
                append(c);
        }
        return keys;
    }
    static constexpr auto storage = make();
};

/// Repeats `pattern` once for each row of `Keys`. Each repetition is `words_per_row` words after
/// the previous one. Defaults may be changed row by row before the table is completed.
template <typename Keys>
constexpr auto repeated_rows(const std::array<Parameter, Keys::columns>& pattern,
                             std::uint16_t words_per_row)
{
    std::array<Parameter, Keys::rows * Keys::columns> table{};
    for (std::size_t row = 0; row < Keys::rows; ++row)
        for (std::size_t column = 0; column < Keys::columns; ++column) {
            Parameter& parameter = table[row * Keys::columns + column];
            parameter = pattern[column];
            parameter.key = Keys::at(row, column);
            for (Slice& slice : parameter.slices)
                slice.word = static_cast<std::uint16_t>(slice.word + row * words_per_row);
        }
    return table;
}

/// Joins several tables.
template <std::size_t... N>
constexpr auto joined(const std::array<Parameter, N>&... tables)
{
    std::array<Parameter, (N + ...)> all{};
    auto at = all.begin();
    ((at = std::copy(tables.begin(), tables.end(), at)), ...);
    return all;
}

} // namespace raymarch::protocol
