// SPDX-License-Identifier: MIT
/// @file
/// Rows that hold for any accelerator, made from its description: the table files speak of the
/// marcher, and this is what an endpoint with another one is judged by.
#pragma once

#include "conformance/table.hpp"
#include "protocol/parameters.hpp"

#include <vector>

namespace raymarch::conformance
{

/// Frames, SET and GET of every key at both ends of its range, faults, presets and RESET. The rows
/// run in order, start from the defaults and leave them behind; their line is 0.
[[nodiscard]] std::vector<Row> description_rows(const protocol::Accelerator& accelerator);

} // namespace raymarch::conformance
