// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the extended registers and their fields. Also converts parameters to register words and
/// back.
#pragma once

#include "protocol/parameters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

namespace raymarch::protocol
{

/// The register page: one AXI-lite slave of 4 KiB with 32-bit words.
inline constexpr std::size_t register_page_bytes = 4096;

/// Byte offsets; the names are those of the table below.
enum class Register : std::uint16_t {
    Id = 0x20,
    Version = 0x24,
    Capability = 0x28,
    Geometry = 0x2C,
    Control = 0x30,
    Commit = 0x34,
    Status = 0x38,
    Frames = 0x3C,
    Cycles = 0x40,
    ClockHz = 0x44,
    Scratch = 0x48,
};

struct RegisterRow
{
    Register at;
    std::string_view name;
    std::string_view access; ///< ro, wo, rw
    std::string_view meaning;
};

/// Bits [msb:lsb] of an extended register.
struct RegisterField
{
    Register at;
    std::string_view name;
    std::uint8_t msb;
    std::uint8_t lsb;
    std::string_view access; ///< ro, rw; w1c: a write of 1 clears it; sc: it clears itself
    std::string_view reset;  ///< a number, or `fixed`: the logic says what it is
    std::string_view meaning;
};

// Laid out by hand: one row a register, and one a field.
// clang-format off
inline constexpr std::array extended_registers = {
    RegisterRow{Register::Id,         "ID",         "ro", "0x524D4152 (\"RMAR\"); anything else means that words from 8 on are not there"},
    RegisterRow{Register::Version,    "VERSION",    "ro", "version of the register block"},
    RegisterRow{Register::Capability, "CAPABILITY", "ro", "what accelerator this is"},
    RegisterRow{Register::Geometry,   "GEOMETRY",   "ro", "size of a picture"},
    RegisterRow{Register::Control,    "CONTROL",    "rw", "what the block does"},
    RegisterRow{Register::Commit,     "COMMIT",     "wo", "any value: the parameter words are latched at the next frame start"},
    RegisterRow{Register::Status,     "STATUS",     "rw", "how the block stands"},
    RegisterRow{Register::Frames,     "FRAMES",     "ro", "frames finished since reset"},
    RegisterRow{Register::Cycles,     "CYCLES",     "ro", "clock cycles of the last frame"},
    RegisterRow{Register::ClockHz,    "CLOCK_HZ",   "ro", "clock of the ray units in Hz"},
    RegisterRow{Register::Scratch,    "SCRATCH",    "rw", "free, for the self-test at start"},
};

inline constexpr std::array register_fields = {
    RegisterField{Register::Version,    "MAJOR",            31, 16, "ro",  "1",     "major version"},
    RegisterField{Register::Version,    "MINOR",            15, 0,  "ro",  "0",     "minor version"},
    RegisterField{Register::Capability, "KIND",             31, 24, "ro",  "fixed", "accelerator: its position in the list of parameter words on this page, from 0"},
    RegisterField{Register::Capability, "RAY_UNITS",        23, 16, "ro",  "fixed", "number of ray units"},
    RegisterField{Register::Geometry,   "WIDTH",            31, 16, "ro",  "fixed", "pixels of a row"},
    RegisterField{Register::Geometry,   "HEIGHT",           15, 0,  "ro",  "fixed", "rows of a picture"},
    RegisterField{Register::Control,    "ENABLE",           0,  0,  "rw",  "0",     "the block draws"},
    RegisterField{Register::Control,    "INTERRUPT_ENABLE", 1,  1,  "rw",  "0",     "the interrupt line follows STATUS.FRAME_DONE"},
    RegisterField{Register::Control,    "SHADOW",           2,  2,  "rw",  "0",     "parameter words that are written take effect at COMMIT"},
    RegisterField{Register::Control,    "SOFT_RESET",       3,  3,  "sc",  "0",     "a write of 1 resets the block; a frame that is being drawn is finished"},
    RegisterField{Register::Status,     "BUSY",             0,  0,  "ro",  "0",     "a frame is being drawn"},
    RegisterField{Register::Status,     "COMMIT_PENDING",   1,  1,  "ro",  "0",     "COMMIT was written, and the next frame has not started"},
    RegisterField{Register::Status,     "FRAME_DONE",       2,  2,  "w1c", "0",     "a frame was finished; cleared, it lowers the interrupt line"},
    RegisterField{Register::Status,     "FAULT",            3,  3,  "ro",  "0",     "the logic reports a fault"},
};
// clang-format on

/// The row of the field `name` of the register `at`. A name that no row has does not compile.
[[nodiscard]] consteval const RegisterField& register_field(Register at, std::string_view name)
{
    const auto* const row = std::ranges::find_if(register_fields, [&](const RegisterField& field) {
        return field.at == at && field.name == name;
    });
    if (row == register_fields.end())
        std::abort(); // is no constant expression
    return *row;
}
/// The mask of a field, where it stands in its register.
[[nodiscard]] consteval std::uint32_t field_mask(Register at, std::string_view name)
{
    const RegisterField& field = register_field(at, name);
    return (UINT32_MAX >> (31 - field.msb + field.lsb)) << field.lsb;
}

inline constexpr std::uint32_t id_value = 0x524D4152;
inline constexpr std::uint32_t version_value = 1U << register_field(Register::Version, "MAJOR").lsb;

namespace control
{
inline constexpr std::uint32_t enable = field_mask(Register::Control, "ENABLE");
inline constexpr std::uint32_t interrupt_enable = field_mask(Register::Control, "INTERRUPT_ENABLE");
inline constexpr std::uint32_t shadow = field_mask(Register::Control, "SHADOW");
inline constexpr std::uint32_t soft_reset = field_mask(Register::Control, "SOFT_RESET");
} // namespace control

namespace status
{
inline constexpr std::uint32_t busy = field_mask(Register::Status, "BUSY");
inline constexpr std::uint32_t commit_pending = field_mask(Register::Status, "COMMIT_PENDING");
inline constexpr std::uint32_t frame_done = field_mask(Register::Status, "FRAME_DONE");
inline constexpr std::uint32_t fault = field_mask(Register::Status, "FAULT");
} // namespace status

[[nodiscard]] constexpr std::uint32_t capability_word(const Accelerator& accelerator) noexcept
{
    return std::uint32_t{accelerator.kind} << register_field(Register::Capability, "KIND").lsb |
           std::uint32_t{accelerator.ray_units}
               << register_field(Register::Capability, "RAY_UNITS").lsb;
}
[[nodiscard]] constexpr std::uint8_t capability_kind(std::uint32_t word) noexcept
{
    return static_cast<std::uint8_t>(word >> register_field(Register::Capability, "KIND").lsb);
}
[[nodiscard]] constexpr std::uint32_t geometry_word(PictureSize size) noexcept
{
    return std::uint32_t{size.width} << register_field(Register::Geometry, "WIDTH").lsb |
           std::uint32_t{size.height} << register_field(Register::Geometry, "HEIGHT").lsb;
}
[[nodiscard]] constexpr PictureSize geometry_size(std::uint32_t word) noexcept
{
    return {static_cast<std::uint16_t>(word >> register_field(Register::Geometry, "WIDTH").lsb),
            static_cast<std::uint16_t>(word >> register_field(Register::Geometry, "HEIGHT").lsb)};
}

/// Packs `state` into words. Bits that belong to no parameter are 0.
[[nodiscard]] constexpr Words pack(const Accelerator& accelerator, const State& state) noexcept
{
    Words words(accelerator.word_count);
    accelerator.pack(state, words);
    return words;
}

/// Unpacks `words` into a state, the inverse of pack. Signed formats are sign-extended. A value
/// that is in no register gets its default.
[[nodiscard]] constexpr State unpack(const Accelerator& accelerator,
                                     std::span<const std::uint32_t> words) noexcept
{
    State state(accelerator.parameters.size());
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const Parameter& parameter = accelerator.parameters[i];
        if (parameter.slice_count == 0) {
            state.codes[i] = parameter.initial_code;
            continue;
        }
        std::uint64_t bits = 0;
        for (const Slice& slice : parameter.placement()) {
            bits = bits << slice.width() | (words[slice.word] >> slice.lsb & slice.mask);
        }
        const int spare = 64 - parameter.code_width();
        state.codes[i] = parameter.format.is_signed
                             ? static_cast<std::int64_t>(bits << spare) >> spare
                             : static_cast<std::int64_t>(bits);
    }
    return state;
}

} // namespace raymarch::protocol
