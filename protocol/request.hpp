// SPDX-License-Identifier: MIT
/// @file
/// A line to what it asks for: judged by length, bytes and checksum, then told apart as frame or
/// command. What a frame or a command's words hold is read by assignments.hpp and arguments.hpp.
#pragma once

#include "protocol/commands.hpp"
#include "protocol/errors.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/text.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace raymarch::protocol
{

struct Request
{
    enum class Kind : std::uint8_t {
        Blank,   ///< only spaces and tabs: no reply
        Reply,   ///< a reply that an echo sent back: no reply either
        Faulty,  ///< `fault` says why
        Frame,   ///< `text` is the whole frame
        Command, ///< `command` with its words in `text`, trimmed
    };
    Kind kind = Kind::Blank;
    bool checksummed = false; ///< the line carried *HH, so the reply does too
    [[nodiscard]] bool answered() const noexcept
    {
        return kind != Kind::Blank && kind != Kind::Reply;
    }
    Text text{};
    const CommandRow* command = nullptr;
    std::size_t command_column = 0; ///< of the command's word
    Fault fault{};
};

/// Views in the result point into `line`.
[[nodiscard]] Request read_request(const Line& line, bool require_checksum) noexcept;

/// Argument when a command that needs words has none, or one that takes none has some.
[[nodiscard]] std::optional<Fault> check_arity(const Request& request) noexcept;

} // namespace raymarch::protocol
