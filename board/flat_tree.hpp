// SPDX-License-Identifier: MIT
/// @file
/// Reads properties from a flattened device tree, as `dtc` compiles it. (Devicetree Specification
/// 0.4, chapter 5)
#pragma once

#include "base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::board
{

using TreeBytes = std::span<const std::uint8_t>;

/// Splits a property's value into cells of 32 bits, high byte first. Bytes after the last whole
/// cell are ignored.
[[nodiscard]] std::vector<std::uint32_t> cells_of(TreeBytes value);

/// Checks the header of the tree and its length. Errors: BadData, with `file`.
[[nodiscard]] Result<void> check_tree_header(TreeBytes blob, const std::string& file);

/// Returns the values of the property `name` of all nodes, in order; they point into `blob`.
/// Errors: BadData, with `file` and the offset, if the tree is cut or damaged.
[[nodiscard]] Result<std::vector<TreeBytes>> values_of(TreeBytes blob, std::string_view name,
                                                       const std::string& file);

} // namespace raymarch::board
