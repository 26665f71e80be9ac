// SPDX-License-Identifier: MIT
/// @file
/// Makes the answers of HELP from the tables.
#pragma once

#include "protocol/parameters.hpp"
#include "protocol/reply.hpp"

#include <string_view>

namespace raymarch::protocol
{

/// Writes lines that begin with `# ` about `word`, or about everything if it is empty. Writes
/// nothing and returns false if nothing has that name.
[[nodiscard]] bool write_help(ReplyWriter& reply, const Accelerator& accelerator,
                              std::string_view word) noexcept;

} // namespace raymarch::protocol
