// SPDX-License-Identifier: MIT
/// @file
/// The types of a row of a parameter table and of the description of an accelerator.
///
/// Parser, packer, help, documents, SystemVerilog package and state file read only this.
/// parameter_table.hpp has the tools to write and check a table.
#pragma once

#include "protocol/counted.hpp"
#include "protocol/decimal.hpp"
#include "protocol/text.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace raymarch::protocol
{

/// A Q-format as a run-time value. It is two's complement, with the sign among the integer bits, or
/// unsigned.
struct Format
{
    bool is_signed = false;
    std::uint8_t integer_bits = 0;
    std::uint8_t fraction_bits = 0;

    [[nodiscard]] constexpr int width() const noexcept { return integer_bits + fraction_bits; }
    /// The largest code. Precondition: at most 64 bits if signed, 63 if unsigned.
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

/// The position of a parameter in its table.
using ParameterIndex = std::uint8_t;

/// Bits [msb:lsb] of one register word. A parameter that spans words lists its upper part first.
struct Slice
{
    std::uint16_t word = 0;
    std::uint8_t msb = 0;
    std::uint8_t lsb = 0;
    // complete() fills these in: which bit of the parameter is at lsb, and the mask of the slice.
    std::uint8_t shift = 0;
    std::uint32_t mask = 0;

    [[nodiscard]] constexpr int width() const noexcept { return msb - lsb + 1; }
};

/// The largest number of slices of a parameter.
inline constexpr std::size_t max_slices = 3;

/// The magnitudes that a parameter may have, in half codes, from `least` to below `first_above`.
struct Limits
{
    std::uint64_t least = UINT64_MAX; ///< the initial limits allow no value
    std::uint64_t first_above = 0;
};

/// One value that a host may set, or the lower bits of the previous row's value.
struct Parameter
{
    std::string_view key; ///< in upper case; a key with a dot belongs to a table within the table
    std::string_view meaning; ///< for help and documents
    std::string_view unit;    ///< empty if the value has no unit
    std::string_view group;   ///< the name that RESET and RANDOM take
    Format format;
    std::string_view min; ///< decimal text, inclusive; empty for choices
    std::string_view max;
    std::string_view initial; ///< decimal text, or the name of a choice
    std::array<Slice, max_slices> slices{};
    std::uint8_t slice_count = 1; ///< 0 if the value is in no register, only in the service
    std::uint8_t tail_bits = 0;   ///< how many lower bits are in the next row
    std::span<const std::string_view> choices{}; ///< names of the codes 0, 1, …; empty for numbers

    // complete() fills these in: the range in units of 2^-code_fraction_bits, the default's code,
    // and the limits that the quantizer compares with.
    std::int64_t min_scaled = 0;
    std::int64_t max_scaled = 0;
    std::int64_t initial_code = 0;
    std::int64_t largest_code = 0; ///< the largest code of code_width() bits
    Limits positive{};             ///< for numbers without a minus sign
    Limits negative{};             ///< for numbers with a minus sign; -0 is zero

    [[nodiscard]] constexpr std::span<const Slice> placement() const noexcept
    {
        return std::span(slices).first(slice_count);
    }
    [[nodiscard]] constexpr bool is_choice() const noexcept { return !choices.empty(); }
    /// Whether this row holds only the lower bits of the previous row's number.
    [[nodiscard]] constexpr bool is_tail() const noexcept { return key.empty(); }
    /// Whether this row belongs to a table within the table, such as the spheres of a scene. Such a
    /// value can be given with SET and is not needed in a frame.
    [[nodiscard]] constexpr bool is_row() const noexcept
    {
        // find() cannot be used: with the sanitizers of gcc its test for a null pointer is no
        // constant expression.
        for (const char c : key)
            if (c == '.')
                return true;
        return false;
    }
    /// The width of this row's own code, and the number of its fraction bits.
    [[nodiscard]] constexpr int code_width() const noexcept { return format.width() - tail_bits; }
    [[nodiscard]] constexpr int code_fraction_bits() const noexcept
    {
        return format.fraction_bits - tail_bits;
    }
};

/// The size of the largest table that fits a State.
inline constexpr std::size_t max_parameters = 256;

/// Finds a key in its table. It is a hash table with open addressing, made at compile time.
class KeyIndex
{
  public:
    /// The keys of `table`, which is shorter than max_parameters.
    consteval explicit KeyIndex(std::span<const Parameter> table)
    {
        slots_.fill(none);
        for (std::size_t i = 0; i < table.size(); ++i) {
            if (table[i].is_tail())
                continue;
            std::size_t slot = hash(table[i].key);
            while (slots_[slot] != none)
                slot = next(slot);
            slots_[slot] = static_cast<ParameterIndex>(i);
        }
    }
    /// The index of `key`, in upper or lower case, in the table that this was made from.
    [[nodiscard]] constexpr std::optional<ParameterIndex> find(std::span<const Parameter> table,
                                                               std::string_view key) const noexcept
    {
        for (std::size_t slot = hash(key); slots_[slot] != none; slot = next(slot))
            if (equal_ignoring_case(table[slots_[slot]].key, key))
                return slots_[slot];
        return std::nullopt;
    }

  private:
    static constexpr ParameterIndex none = max_parameters - 1;

    [[nodiscard]] static constexpr std::size_t hash(std::string_view key) noexcept
    {
        std::uint32_t sum = 0;
        for (const char c : key)
            sum = sum * 31 + static_cast<std::uint8_t>(to_upper(c));
        return sum % (2 * max_parameters);
    }
    [[nodiscard]] static constexpr std::size_t next(std::size_t slot) noexcept
    {
        return (slot + 1) % (2 * max_parameters);
    }

    std::array<ParameterIndex, 2 * max_parameters> slots_{};
};

/// The largest number of parameter words. They begin at offset 0x100 of the page.
inline constexpr std::size_t max_parameter_words = (0x800 - 0x100) / 4;

/// The parameter words of one accelerator, `word_count` of them.
using Words = Counted<std::uint32_t, max_parameter_words>;

/// The code of every parameter, in table order.
struct State
{
    Counted<std::int64_t, max_parameters> codes;

    /// Makes a state with room for any table. All codes are zero.
    constexpr State() noexcept = default;
    /// Makes a state for a table of this size. All codes are zero.
    constexpr explicit State(std::size_t size) noexcept : codes(size) {}
    bool operator==(const State&) const = default;
};

/// A set of parameters of a table, by their indices.
class ParameterSet
{
  public:
    constexpr ParameterSet& set(std::size_t i, bool on = true) noexcept
    {
        const std::uint32_t bit = std::uint32_t{1} << (i % 32);
        bits_[i / 32] = on ? bits_[i / 32] | bit : bits_[i / 32] & ~bit;
        return *this;
    }
    [[nodiscard]] constexpr bool operator[](std::size_t i) const noexcept
    {
        return (bits_[i / 32] >> (i % 32) & 1) != 0;
    }
    [[nodiscard]] constexpr std::size_t count() const noexcept
    {
        std::size_t count = 0;
        for (const std::uint32_t bits : bits_)
            count += static_cast<std::size_t>(std::popcount(bits));
        return count;
    }
    [[nodiscard]] constexpr bool any() const noexcept { return !(*this == ParameterSet()); }
    /// The parameters of `all` that are not in this set.
    [[nodiscard]] constexpr ParameterSet missing_of(const ParameterSet& all) const noexcept
    {
        ParameterSet missing;
        for (std::size_t i = 0; i < bits_.size(); ++i)
            missing.bits_[i] = all.bits_[i] & ~bits_[i];
        return missing;
    }
    bool operator==(const ParameterSet&) const = default;

  private:
    std::array<std::uint32_t, max_parameters / 32> bits_{}; // of 32: quicker on the board
};

/// The parameters of a camera. VIEW sets them, and the basis check reads them.
struct OrbitCamera
{
    std::array<ParameterIndex, 3> forward;
    std::array<ParameterIndex, 3> right;
    std::array<ParameterIndex, 3> up;
    ParameterIndex zoom;
};

/// The three colour channels that HUE sets.
struct Colour
{
    std::array<ParameterIndex, 3> channels;
};

/// A named view. It is the defaults, changed by `settings`, which has the syntax of SET.
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

/// All that the software knows about one accelerator, except how it computes a picture.
struct Accelerator
{
    std::string_view name;
    std::string_view summary;
    std::uint8_t kind;               ///< CAPABILITY[31:24]
    std::uint16_t first_word_offset; ///< byte offset of parameter word 0
    std::uint16_t word_count;
    PictureSize size;     ///< the picture size of the source
    PictureSize max_size; ///< the largest picture size of the model
    std::uint8_t ray_units;
    std::uint32_t clock_hz;
    std::span<const Parameter> parameters;
    KeyIndex keys;                               ///< of `parameters`
    void (*pack)(const State&, Words&) noexcept; ///< pack_table() of `parameters`
    ParameterSet frame;                          ///< the keys of a complete frame, see frame_of()
    std::span<const Preset> presets;
    std::optional<OrbitCamera> camera;
    std::optional<Colour> colour;
    std::optional<ParameterIndex> scene; ///< the parameter that chooses the scene
};

/// Finds the index of `key`, in any case of letters. It looks at `guess` first, because keys mostly
/// come in table order.
[[nodiscard]] constexpr std::optional<ParameterIndex>
find_parameter(const Accelerator& accelerator, std::string_view key, std::size_t guess = 0) noexcept
{
    if (key.empty()) // an empty key names no value
        return std::nullopt;
    const std::span<const Parameter> table = accelerator.parameters;
    if (guess < table.size() && equal_ignoring_case(table[guess].key, key))
        return static_cast<ParameterIndex>(guess);
    return accelerator.keys.find(table, key);
}

/// Finds the code of a choice from its name, in any case of letters, or from its single digit.
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

/// Makes the state with the defaults of a table.
[[nodiscard]] constexpr State initial_state(const Accelerator& accelerator) noexcept
{
    State state(accelerator.parameters.size());
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        state.codes[i] = accelerator.parameters[i].initial_code;
    return state;
}

} // namespace raymarch::protocol
