// SPDX-License-Identifier: MIT
/// @file
/// One host's conversation: bytes in, lines to the controller, replies out. No system calls.
#pragma once

#include "daemon/controller.hpp"
#include "daemon/output_queue.hpp"
#include "protocol/echo_editor.hpp"
#include "protocol/line_reader.hpp"

#include <cstdint>
#include <string_view>

namespace raymarch::daemon
{

/// How far one step of a session came.
enum class Step : std::uint8_t {
    Done,   ///< a line was executed, or a piece of one
    Hungry, ///< all bytes are taken, and the line wants more
    Full,   ///< the reply might find no room among those that the host has not read
    Waits,  ///< a disk works on the line
};

class Session
{
  public:
    explicit Session(Controller& controller) noexcept : controller_(controller) {}

    /// Executes the next line, or goes on with one that takes long. Takes from the front of `bytes`
    /// what it has used; the rest must be given again, before anything newer. Replies go to the
    /// output.
    [[nodiscard]] Step step(std::string_view& bytes, const TurnIsOver& turn_is_over);

    /// Takes all bytes, without a pause, and as from a host that does not read: what finds no room
    /// in the output is dropped. A line that a disk works on is left, and the bytes behind it.
    void receive(std::string_view bytes);

    /// Whether a line is not done yet: a disk works on it, or it has steps left.
    [[nodiscard]] bool busy() const noexcept { return rest_.any(); }

    /// Whether the host reads its replies. While it does not, nothing waits for room: replies that
    /// find none are dropped whole, and counted.
    void set_reads(bool reads) noexcept { reads_ = reads; }

    /// The host left: an unfinished line and unread replies are forgotten, and echo is off again.
    void hang_up() noexcept;
    /// The replies that still wait will never be read.
    void drop_output() noexcept { dropped_replies_ += output_.clear(); }

    [[nodiscard]] OutputQueue& output() noexcept { return output_; }
    [[nodiscard]] std::uint64_t dropped_replies() const noexcept { return dropped_replies_; }
    [[nodiscard]] std::uint64_t hang_ups() const noexcept { return hang_ups_; }

  private:
    [[nodiscard]] bool has_room() const noexcept
    {
        return !reads_ || output_.room() >= protocol::longest_reply;
    }
    [[nodiscard]] Step type(std::string_view& bytes, const TurnIsOver& turn_is_over);
    void execute(const protocol::Line& line, const TurnIsOver& turn_is_over);
    void push(std::string_view reply) noexcept;

    Controller& controller_;
    SessionSettings settings_;
    protocol::LineReader reader_;
    protocol::EchoEditor editor_;
    Unfinished rest_;
    OutputQueue output_;
    bool reads_ = true;
    std::uint64_t dropped_replies_ = 0;
    std::uint64_t hang_ups_ = 0;
};

} // namespace raymarch::daemon
