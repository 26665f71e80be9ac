// SPDX-License-Identifier: MIT
/// @file
/// The host's end of the protocol: lines out, replies in, over a serial port or the control socket.
#pragma once

#include "base/result.hpp"
#include "drivers/ports.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::console
{

/// Where the service is.
struct Endpoint
{
    std::string port;   ///< TTY[@BAUD]
    std::string socket; ///< path of the control socket
};

inline constexpr const char* default_socket = "/run/raymarchd/control";

/// Adds --port and --socket; without either the default socket is meant.
void add_endpoint_options(CLI::App& command, Endpoint& endpoint);

class Connection
{
  public:
    /// Errors: Usage, Unavailable, InputOutput.
    [[nodiscard]] static Result<Connection> open(const Endpoint& endpoint);

    /// Sends all bytes as they are. Errors: InputOutput, also when the other side takes nothing for
    /// the length of the time-out.
    [[nodiscard]] Result<void> send(std::string_view bytes);

    /// The next line that comes, without its ending. Errors: InputOutput, also when none comes
    /// within the time-out.
    [[nodiscard]] Result<std::string> receive(std::chrono::milliseconds timeout = reply_timeout);

    /// Sends a line and collects its reply: lines beginning `#`, and the one beginning OK or ERR.
    [[nodiscard]] Result<std::vector<std::string>> ask(std::string_view line);

    /// Drops whatever comes until nothing has come for `quiet`.
    void drain(std::chrono::milliseconds quiet);

    static constexpr std::chrono::milliseconds reply_timeout{5000};

  private:
    explicit Connection(std::unique_ptr<drivers::BytePort> port) : port_(std::move(port)) {}
    /// False when nothing happened in time.
    [[nodiscard]] bool wait(short events, std::chrono::milliseconds timeout) const;

    std::unique_ptr<drivers::BytePort> port_;
    std::string received_;
};

/// Asks, prints the reply, and gives its last line: the one beginning OK or ERR.
[[nodiscard]] Result<std::string> ask_and_print(Connection& connection, std::string_view line);

/// Whether a reply is an ERR.
[[nodiscard]] inline bool is_err(std::string_view reply) noexcept
{
    return reply.starts_with("ERR");
}

} // namespace raymarch::console
