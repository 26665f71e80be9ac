// SPDX-License-Identifier: MIT
/// @file
/// The answers of HELP, made from the tables.
#pragma once

#include "protocol/parameters.hpp"
#include "protocol/reply.hpp"

#include <string_view>

namespace raymarch::protocol
{

/// Lines beginning `# ` about `word`, or about everything when it is empty. False, and no line,
/// when there is nothing of that name.
[[nodiscard]] bool write_help(ReplyWriter& reply, const Accelerator& accelerator,
                              std::string_view word) noexcept;

} // namespace raymarch::protocol
