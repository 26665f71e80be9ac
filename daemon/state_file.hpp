// SPDX-License-Identifier: MIT
/// @file
/// Formats and parses the state file. It has the last state and the saved state of each
/// accelerator.
///
///     raymarch-state 1
///     last marcher FX=0,…,OBJ=sphere
///     saved marcher FX=0,…,OBJ=cube
///     last fractal X=0,…,HUE=0
///     crc32 1234ABCD
///
/// The checksum covers every line before it. A file with a wrong checksum or of another version is
/// refused. Lines of unknown accelerators are kept.
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
    std::optional<protocol::State> last;  ///< restored after a restart
    std::optional<protocol::State> saved; ///< SAVE stores it for LOAD
    bool operator==(const PersistedState&) const = default;
};

struct PersistedStates
{
    std::array<PersistedState, protocol::accelerators.size()> states{};
    std::string others; ///< the lines of unknown accelerators

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
