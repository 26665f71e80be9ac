// SPDX-License-Identifier: MIT
/// @file
/// The persisted state as text: what was last applied, and what SAVE put aside.
///
///     raymarch-state 1
///     last marcher FX=0,…,OBJ=sphere
///     saved marcher FX=0,…,OBJ=cube
///     crc32 1234ABCD
///
/// The check covers every line before it. A file that fails it, or that another version wrote, is
/// refused whole.
#pragma once

#include "base/result.hpp"
#include "protocol/parameters.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace raymarch::daemon
{

struct PersistedState
{
    std::optional<protocol::State> last;  ///< to go on with after a restart
    std::optional<protocol::State> saved; ///< what SAVE put aside for LOAD
    bool operator==(const PersistedState&) const = default;
};

[[nodiscard]] std::string format_state_file(const protocol::Accelerator& accelerator,
                                            const PersistedState& state);

/// Errors: BadData. States of another accelerator are left out.
[[nodiscard]] Result<PersistedState> parse_state_file(const protocol::Accelerator& accelerator,
                                                      std::string_view text);

} // namespace raymarch::daemon
