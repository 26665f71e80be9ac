// SPDX-License-Identifier: MIT
/// @file
/// Reads a whole line for the service: text becomes a frame or a command with its values.
#pragma once

#include "protocol/commands.hpp"
#include "protocol/errors.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/parameters.hpp"
#include "protocol/typed_command.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace raymarch::protocol
{

/// A line that gets no reply.
enum class Silence : std::uint8_t {
    Blank, ///< only spaces and tabs
    Reply, ///< a reply that an echo sent back
};

/// A parameter frame.
struct Frame
{
    const State* state; ///< never null
};

struct TypedRequest
{
    bool checksummed = false; ///< the line carried *HH, so the reply does too
    /// What the line would do. Nothing is known of a line that is neither frame nor command.
    std::optional<Effect> effect{};
    std::variant<Silence, Fault, Frame, AnyCommand<commands>> what;
};

/// Reads a line for the accelerator of `context`. The result may point into `line` and to
/// `context.result`.
[[nodiscard]] TypedRequest parse(const Line& line, const ReadingContext& context,
                                 bool require_checksum);

} // namespace raymarch::protocol
