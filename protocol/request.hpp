// SPDX-License-Identifier: MIT
/// @file
/// Checks the length, the bytes and the checksum of a line, and tells frames from commands.
/// protocol/typed_request.hpp reads the rest.
#pragma once

#include "protocol/commands.hpp"
#include "protocol/errors.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/text.hpp"

#include <cstddef>
#include <cstdint>

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

} // namespace raymarch::protocol
