// SPDX-License-Identifier: MIT
/// @file
/// The persisted states as text: of each accelerator what was last applied, and what SAVE put
/// aside.
///
///     raymarch-state 1
///     last marcher FX=0,…,OBJ=sphere
///     saved marcher FX=0,…,OBJ=cube
///     last fractal X=0,…,HUE=0
///     crc32 1234ABCD
///
/// The check covers every line before it. A file that fails it, or that another version wrote, is
/// refused whole. Lines of accelerators that this version does not know are kept as they are.
#pragma once

#include "base/result.hpp"
#include "protocol/accelerators.hpp"

#include <array>
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

/// One for each accelerator of the registry.
struct PersistedStates
{
    std::array<PersistedState, protocol::accelerators.size()> states{};
    std::string others; ///< whole lines of accelerators that this version does not know

    [[nodiscard]] PersistedState& of(const protocol::Accelerator& accelerator) noexcept
    {
        return states[protocol::position_of(accelerator)];
    }
    bool operator==(const PersistedStates&) const = default;
};

[[nodiscard]] std::string format_state_file(const PersistedStates& states);

/// Errors: BadData.
[[nodiscard]] Result<PersistedStates> parse_state_file(std::string_view text);

} // namespace raymarch::daemon
