// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the extended registers. Also converts parameters to register words and back.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstdint>
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

// Laid out by hand: one row a register.
// clang-format off
inline constexpr std::array extended_registers = {
    RegisterRow{Register::Id,         "ID",         "ro", "0x524D4152 (\"RMAR\"); anything else means that words from 8 on are not there"},
    RegisterRow{Register::Version,    "VERSION",    "ro", "major[31:16] minor[15:0]"},
    RegisterRow{Register::Capability, "CAPABILITY", "ro", "accelerator kind[31:24], ray units[23:16], rest 0"},
    RegisterRow{Register::Geometry,   "GEOMETRY",   "ro", "width[31:16] height[15:0] in pixels"},
    RegisterRow{Register::Control,    "CONTROL",    "rw", "bit0 enable, bit1 interrupt enable, bit2 shadow mode (parameter writes take effect at COMMIT), bit3 soft reset (clears itself)"},
    RegisterRow{Register::Commit,     "COMMIT",     "wo", "any value: the parameter words are latched at the next frame start"},
    RegisterRow{Register::Status,     "STATUS",     "rw", "bit0 busy, bit1 commit pending, bit2 frame done (write 1 to clear; drops the interrupt), bit3 fault"},
    RegisterRow{Register::Frames,     "FRAMES",     "ro", "frames finished since reset"},
    RegisterRow{Register::Cycles,     "CYCLES",     "ro", "clock cycles of the last frame"},
    RegisterRow{Register::ClockHz,    "CLOCK_HZ",   "ro", "clock of the ray units in Hz"},
    RegisterRow{Register::Scratch,    "SCRATCH",    "rw", "free, for the self-test at start"},
};
// clang-format on

inline constexpr std::uint32_t id_value = 0x524D4152;
inline constexpr std::uint32_t version_value = 0x0001'0000;

namespace control
{
inline constexpr std::uint32_t enable = 1U << 0;
inline constexpr std::uint32_t interrupt_enable = 1U << 1;
inline constexpr std::uint32_t shadow = 1U << 2;
inline constexpr std::uint32_t soft_reset = 1U << 3;
} // namespace control

namespace status
{
inline constexpr std::uint32_t busy = 1U << 0;
inline constexpr std::uint32_t commit_pending = 1U << 1;
inline constexpr std::uint32_t frame_done = 1U << 2;
inline constexpr std::uint32_t fault = 1U << 3;
} // namespace status

[[nodiscard]] constexpr std::uint32_t capability_word(const Accelerator& accelerator) noexcept
{
    return std::uint32_t{accelerator.kind} << 24 | std::uint32_t{accelerator.ray_units} << 16;
}
[[nodiscard]] constexpr std::uint8_t capability_kind(std::uint32_t word) noexcept
{
    return static_cast<std::uint8_t>(word >> 24);
}
[[nodiscard]] constexpr std::uint32_t geometry_word(PictureSize size) noexcept
{
    return std::uint32_t{size.width} << 16 | size.height;
}
[[nodiscard]] constexpr PictureSize geometry_size(std::uint32_t word) noexcept
{
    return {static_cast<std::uint16_t>(word >> 16), static_cast<std::uint16_t>(word)};
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
