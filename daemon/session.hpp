// SPDX-License-Identifier: MIT
/// @file
/// One host's conversation: bytes in, lines to the controller, replies out. No system calls.
#pragma once

#include "daemon/controller.hpp"
#include "protocol/echo_editor.hpp"
#include "protocol/line_reader.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raymarch::daemon
{

/// Replies that a host does not read wait here, as many as fit; further ones are dropped whole and
/// counted, so that nothing ever waits for a host.
class OutputQueue
{
  public:
    /// False when it does not fit, and then nothing of it is taken.
    bool push(std::string_view bytes) noexcept;
    [[nodiscard]] std::string_view pending() const noexcept { return {bytes_.data(), size_}; }
    /// The first `count` bytes have been sent.
    void pop(std::size_t count) noexcept;
    void clear() noexcept { size_ = 0; }

  private:
    std::array<char, 16'384> bytes_{};
    std::size_t size_ = 0;
};

class Session
{
  public:
    explicit Session(Controller& controller) noexcept : controller_(controller) {}

    /// Takes all bytes; replies go to the output.
    void receive(std::string_view bytes);
    /// The host left: an unfinished line and unread replies are forgotten, and echo is off again.
    void hang_up() noexcept;

    [[nodiscard]] OutputQueue& output() noexcept { return output_; }
    [[nodiscard]] std::uint64_t dropped_replies() const noexcept { return dropped_replies_; }
    [[nodiscard]] std::uint64_t hang_ups() const noexcept { return hang_ups_; }

  private:
    void receive_typed(std::string_view& bytes);
    void execute(const protocol::Line& line);

    Controller& controller_;
    SessionSettings settings_;
    protocol::LineReader reader_;
    protocol::EchoEditor editor_;
    OutputQueue output_;
    std::uint64_t dropped_replies_ = 0;
    std::uint64_t hang_ups_ = 0;
};

} // namespace raymarch::daemon
