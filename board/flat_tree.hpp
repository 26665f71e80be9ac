// SPDX-License-Identifier: MIT
/// @file
/// A flattened device tree, as `dtc` compiles it, read for the properties of one name: what an
/// overlay says is not said again elsewhere. (Devicetree Specification 0.4, chapter 5)
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

/// The cells of a property's value: 32 bits, high byte first. A rest that is no cell is left out.
[[nodiscard]] std::vector<std::uint32_t> cells_of(TreeBytes value);

/// Whether `blob` begins as a tree does and is as long as it says. Errors: BadData, with `file`.
[[nodiscard]] Result<void> check_tree_header(TreeBytes blob, const std::string& file);

/// The values of the properties `name` of all nodes, in their order; they lie in `blob`. Errors:
/// BadData, with `file` and the place, where the tree is cut or garbled.
[[nodiscard]] Result<std::vector<TreeBytes>> values_of(TreeBytes blob, std::string_view name,
                                                       const std::string& file);

} // namespace raymarch::board
