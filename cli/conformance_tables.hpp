// SPDX-License-Identifier: MIT
/// @file
/// The protocol's table files (tests/data), which are built into the tool.
#pragma once

#include <array>
#include <string_view>

namespace raymarch::cli
{

struct ConformanceTable
{
    std::string_view name;
    std::string_view text;
};

[[nodiscard]] std::array<ConformanceTable, 3> conformance_tables() noexcept;

} // namespace raymarch::cli
