// SPDX-License-Identifier: MIT
/// @file
/// What a row of a parameter table says, and what a description of an accelerator is made of.
///
/// A table is written with designated initialisers and passed through `complete`, which computes
/// the codes of the ranges and defaults from their decimal text and refuses to compile a table that
/// contradicts itself. Parser, packer, help, documents, SystemVerilog and state file read only
/// this.
#pragma once

#include "protocol/decimal.hpp"
#include "protocol/text.hpp"

#include <array>
#include <bit>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace raymarch::protocol
{

/// A Q-format at run time: two's complement with the sign among the integer bits, or unsigned.
struct Format
{
    bool is_signed = false;
    std::uint8_t integer_bits = 0;
    std::uint8_t fraction_bits = 0;

    [[nodiscard]] constexpr int width() const noexcept { return integer_bits + fraction_bits; }
    [[nodiscard]] constexpr std::int64_t max_code() const noexcept
    {
        return static_cast<std::int64_t>((std::uint64_t{1} << (width() - (is_signed ? 1 : 0))) - 1);
    }
    [[nodiscard]] constexpr std::int64_t min_code() const noexcept
    {
        return is_signed ? -max_code() - 1 : 0;
    }
};

[[nodiscard]] constexpr Format signed_q(std::uint8_t integer_bits, std::uint8_t fraction_bits)
{
    return {true, integer_bits, fraction_bits};
}
[[nodiscard]] constexpr Format unsigned_q(std::uint8_t integer_bits, std::uint8_t fraction_bits)
{
    return {false, integer_bits, fraction_bits};
}

/// Position of a parameter in its table.
using ParameterIndex = std::uint8_t;

/// Bits [msb:lsb] of one register word. A parameter that spans words lists its upper part first.
struct Slice
{
    std::uint8_t word = 0;
    std::uint8_t msb = 0;
    std::uint8_t lsb = 0;
    // Filled in by complete(): which bit of the parameter stands at lsb, and as many ones as bits.
    std::uint8_t shift = 0;
    std::uint32_t mask = 0;

    [[nodiscard]] constexpr int width() const noexcept { return msb - lsb + 1; }
};

/// A slice with the parameter that it belongs to.
struct Field
{
    ParameterIndex parameter = 0;
    Slice slice{};
};

/// `KEY=` as the first bytes of eight that the processor loads at once; empty for a key of more
/// than seven letters.
struct KeyFront
{
    std::uint64_t bits = 1; ///< with an empty mask: matches nothing
    std::uint64_t mask = 0;
    std::uint8_t length = 0;

    [[nodiscard]] constexpr bool matches(std::uint64_t loaded) const noexcept
    {
        return (loaded & mask) == bits;
    }
};

/// The magnitudes that a parameter takes, in half codes: from `least` to below `first_above`.
struct Limits
{
    std::uint64_t least = UINT64_MAX; ///< as they stand here: none
    std::uint64_t first_above = 0;
};

/// One value that a host may set.
struct Parameter
{
    std::string_view key;     ///< upper case, as on the wire
    std::string_view meaning; ///< for help and documents
    std::string_view unit;    ///< empty where there is none
    std::string_view group;   ///< what RESET and RANDOM may name
    Format format;
    std::string_view min; ///< decimal text, inclusive; empty for choices
    std::string_view max;
    std::string_view initial; ///< decimal text, or the name of a choice
    std::array<Slice, 2> slices{};
    std::uint8_t slice_count = 1;
    std::span<const std::string_view> choices{}; ///< names of the codes 0, 1, …; empty for numbers

    // Filled in by complete(): the range in units of 2^-fraction_bits, the default's code, and what
    // the parser's short path compares.
    std::int64_t min_scaled = 0;
    std::int64_t max_scaled = 0;
    std::int64_t initial_code = 0;
    std::int64_t largest_code = 0; ///< format.max_code()
    Limits positive{};             ///< of numbers without a minus sign
    Limits negative{};             ///< with one; a negative zero is a zero
    KeyFront front{};

    [[nodiscard]] constexpr std::span<const Slice> placement() const noexcept
    {
        return std::span(slices).first(slice_count);
    }
    [[nodiscard]] constexpr bool is_choice() const noexcept { return !choices.empty(); }
};

/// The largest table that fits a State.
inline constexpr std::size_t max_parameters = 64;
/// The most parameter words of any accelerator.
inline constexpr std::size_t max_parameter_words = 64;

/// The code of every parameter, in table order.
struct State
{
    std::array<std::int64_t, max_parameters> codes{};
    bool operator==(const State&) const = default;
};

/// A subset of a table, by index.
using ParameterSet = std::bitset<max_parameters>;

/// The twelve parameters that make a camera; what VIEW sets and the basis check looks at.
struct OrbitCamera
{
    std::array<ParameterIndex, 3> forward;
    std::array<ParameterIndex, 3> right;
    std::array<ParameterIndex, 3> up;
    ParameterIndex zoom;
};

/// The three channels that HUE sets.
struct Colour
{
    std::array<ParameterIndex, 3> channels;
};

/// A view worth looking at: the defaults, changed by `settings` in the syntax of SET.
struct Preset
{
    std::string_view name;
    std::string_view summary;
    std::string_view settings;
};

struct PictureSize
{
    std::uint16_t width = 0;
    std::uint16_t height = 0;
    bool operator==(const PictureSize&) const = default;
};

/// Everything that the software knows of one accelerator, except how it computes.
struct Accelerator
{
    std::string_view name;
    std::string_view summary;
    std::uint8_t kind;               ///< CAPABILITY[31:24]
    std::uint16_t first_word_offset; ///< byte offset of parameter word 0
    std::uint8_t word_count;
    PictureSize size;     ///< what the source draws
    PictureSize max_size; ///< what the model draws
    std::uint8_t ray_units;
    std::uint32_t clock_hz;
    std::span<const Parameter> parameters;
    std::span<const Field> fields; ///< every slice of the parameters, see fields_of()
    std::span<const Preset> presets;
    std::optional<OrbitCamera> camera;
    std::optional<Colour> colour;
};

/// The index of `key` (any case), looked for first at `guess`: keys mostly come in table order.
[[nodiscard]] constexpr std::optional<ParameterIndex>
find_parameter(std::span<const Parameter> table, std::string_view key,
               std::size_t guess = 0) noexcept
{
    if (guess < table.size() && equal_ignoring_case(table[guess].key, key))
        return static_cast<ParameterIndex>(guess);
    for (std::size_t i = 0; i < table.size(); ++i)
        if (equal_ignoring_case(table[i].key, key))
            return static_cast<ParameterIndex>(i);
    return std::nullopt;
}

/// The code of a choice from its name (any case) or its single digit.
[[nodiscard]] constexpr std::optional<std::int64_t> find_choice(const Parameter& parameter,
                                                                std::string_view text) noexcept
{
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        if (equal_ignoring_case(parameter.choices[i], text))
            return static_cast<std::int64_t>(i);
    if (text.size() == 1 && detail::is_digit(text[0]) &&
        static_cast<std::size_t>(text[0] - '0') < parameter.choices.size())
        return text[0] - '0';
    return std::nullopt;
}

/// The defaults of a table.
[[nodiscard]] constexpr State initial_state(const Accelerator& accelerator) noexcept
{
    State state;
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        state.codes[i] = accelerator.parameters[i].initial_code;
    return state;
}

// ------------------------------------------------------------------------------------------------

namespace detail
{

/// Reached only by a table that contradicts itself; not constexpr, so that compiling stops there.
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

consteval KeyFront key_front(std::string_view key)
{
    if (key.size() >= sizeof(std::uint64_t))
        return {};
    KeyFront front{.bits = 0, .mask = 0, .length = static_cast<std::uint8_t>(key.size() + 1)};
    for (std::size_t i = 0; i <= key.size(); ++i) {
        const auto byte = static_cast<std::uint8_t>(i < key.size() ? key[i] : '=');
        const std::size_t position =
            std::endian::native == std::endian::little ? i : sizeof(std::uint64_t) - 1 - i;
        front.bits |= std::uint64_t{byte} << (8 * position);
        front.mask |= std::uint64_t{0xFF} << (8 * position);
    }
    return front;
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
    row.front = key_front(row.key);
    row.largest_code = row.format.max_code();
    int below = row.format.width();
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
        row.min_scaled = bound(row.min, row.format.fraction_bits);
        row.max_scaled = bound(row.max, row.format.fraction_bits);
        row.initial_code = bound(row.initial, row.format.fraction_bits);
        if (row.initial_code < row.min_scaled || row.initial_code > row.max_scaled)
            table_error("the default is out of range");
        row.positive = limits(row.min_scaled, row.max_scaled);
        row.negative = limits(-row.max_scaled, -row.min_scaled);
        if (row.initial_code > row.format.max_code()) // 1.0 in a format that ends below it
            row.initial_code = row.format.max_code();
    }
    // The upper end may lie one code above the format (1.0 in Q1.17); the lower one may not.
    if (row.min_scaled < row.format.min_code() || row.max_scaled > row.format.max_code() + 1)
        table_error("the range does not fit the format");
    int width = 0;
    for (const Slice& slice : row.placement())
        width += slice.width();
    if (width != row.format.width())
        table_error("the slices are not as wide as the format");
}

} // namespace detail

/// Fills in the computed members of a table and checks it: keys unique and upper case, ranges and
/// defaults representable, slices as wide as their format, no bit of a register used twice.
template <std::size_t N>
consteval std::array<Parameter, N> complete(std::array<Parameter, N> table)
{
    static_assert(N <= max_parameters);
    std::array<std::uint32_t, max_parameter_words> used{};
    for (std::size_t i = 0; i < N; ++i) {
        Parameter& row = table[i];
        detail::complete_row(row);
        for (const char c : row.key)
            if (to_upper(c) != c)
                detail::table_error("a key is not upper case");
        for (std::size_t j = 0; j < i; ++j)
            if (table[j].key == row.key)
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

/// The fields of a table in one row, as packing walks through them; as many as `count` says.
template <std::size_t N>
struct Fields
{
    std::array<Field, 2 * N> rows{};
    std::size_t count = 0;

    [[nodiscard]] constexpr std::span<const Field> span() const noexcept
    {
        return std::span(rows).first(count);
    }
};

template <std::size_t N>
consteval Fields<N> fields_of(const std::array<Parameter, N>& table)
{
    Fields<N> fields;
    for (std::size_t i = 0; i < N; ++i)
        for (const Slice& slice : table[i].placement())
            fields.rows[fields.count++] = {static_cast<ParameterIndex>(i), slice};
    return fields;
}

} // namespace raymarch::protocol
