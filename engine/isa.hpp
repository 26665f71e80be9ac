// SPDX-License-Identifier: MIT
/// @file
/// The instruction sets that kernels are written for, and which of them this processor has.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raymarch::engine
{

enum class Isa : std::uint8_t {
    Scalar, ///< no vectors: the reference itself
    Sse4,
    Neon,
    Avx2,
    Avx512, ///< F, BW, DQ, VL
};

struct IsaRow
{
    Isa isa;
    std::string_view name; ///< `--isa` takes it
};
inline constexpr std::array isa_rows = {
    IsaRow{Isa::Scalar, "scalar"}, IsaRow{Isa::Sse4, "sse4"},     IsaRow{Isa::Neon, "neon"},
    IsaRow{Isa::Avx2, "avx2"},     IsaRow{Isa::Avx512, "avx512"},
};

[[nodiscard]] constexpr std::string_view name_of(Isa isa) noexcept
{
    return isa_rows[static_cast<std::size_t>(isa)].name;
}

[[nodiscard]] constexpr std::optional<Isa> find_isa(std::string_view name) noexcept
{
    for (const IsaRow& row : isa_rows)
        if (row.name == name)
            return row.isa;
    return std::nullopt;
}

/// Says whether this processor and its operating system run it.
[[nodiscard]] bool supported(Isa isa) noexcept;

} // namespace raymarch::engine
