// SPDX-License-Identifier: MIT
/// @file
/// The host's end of the protocol over a serial port or the control socket.
///
/// On a serial line an earlier host may have left half a line, or replies that nobody read. So
/// `open` first brings the line to a known state (first_contact.cpp).
#pragma once

#include "base/result.hpp"
#include "cli/reply_lines.hpp"
#include "cli/stop_signals.hpp"
#include "drivers/ports.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
struct Accelerator;
}

namespace raymarch::cli
{

struct Endpoint
{
    std::string port;   ///< TTY[@BAUD]
    std::string socket; ///< the path of the control socket
};

inline constexpr const char* default_socket = "/run/raymarchd/control";

/// Adds --port and --socket. Without either the default socket is used.
void add_endpoint_options(CLI::App& command, Endpoint& endpoint);

/// The state of the far end, as the first contact found it.
enum class FarEnd {
    Speaks,     ///< it replies, and follows the rules of marks
    Unmarked,   ///< it replies, but does not follow the rules of marks, so no marks are used
    OnlyErrors, ///< it sends only ERR replies, because of the service's setting `replies`
    Silent,     ///< it sent nothing that could be a reply
};

/// While a Connection exists, Ctrl-C ends its waits and not the program: see `interrupted`.
class Connection
{
  public:
    /// Opens the endpoint and makes first contact. A silent far end is not an error, because lines
    /// may still reach it. Errors: Usage, Unavailable, InputOutput.
    [[nodiscard]] static Result<Connection> open(const Endpoint& endpoint);

    /// Sends all bytes unchanged. Bytes that come meanwhile are kept for `receive`, so that full
    /// buffers on both sides cause no deadlock. Errors: InputOutput, also after the timeout.
    [[nodiscard]] Result<void> send(std::string_view bytes);

    /// Returns the next line without its ending, or nothing if no byte comes within the timeout.
    /// Errors: InputOutput.
    [[nodiscard]] Result<std::optional<std::string>>
    receive(std::chrono::milliseconds timeout = reply_timeout);

    /// Sends a user's bytes and an LF, and returns the lines of the replies that are due. No reply
    /// is due for a blank line. Errors: InputOutput.
    [[nodiscard]] Result<std::vector<std::string>> ask(std::string_view bytes);

    /// Sends a command of the tool, with a mark if the far end knows marks. Returns the last line
    /// of the reply, OK or ERR, without its mark. Errors: InputOutput.
    [[nodiscard]] Result<std::string> request(std::string_view command);

    /// Returns the line that `request` sends for a command.
    [[nodiscard]] std::string request_line(std::string_view command) const;

    /// Brings the line to a known state again. Errors: InputOutput.
    [[nodiscard]] Result<void> synchronise();

    [[nodiscard]] FarEnd far_end() const noexcept { return far_end_; }
    /// Returns the accelerator at the first contact, or nullptr if it is unknown.
    [[nodiscard]] const protocol::Accelerator* accelerator() const noexcept { return accelerator_; }

    /// Becomes readable when a signal asks the program to stop.
    [[nodiscard]] int stop_fd() const noexcept { return stop_->fd(); }
    /// Returns the signal that has come, or 0.
    [[nodiscard]] int interrupted() noexcept;
    /// Forgets the signal. A console goes on after Ctrl-C.
    void forget_interruption() noexcept { interrupted_ = 0; }

    static constexpr std::chrono::milliseconds reply_timeout{5000};

  private:
    using Clock = std::chrono::steady_clock;
    using Accepts = std::function<bool(std::string_view reply)>;

    explicit Connection(std::unique_ptr<drivers::BytePort> port) : port_(std::move(port)) {}

    /// Returns false after the timeout. Errors: InputOutput, if a signal came.
    [[nodiscard]] Result<bool> wait(short events, std::chrono::milliseconds timeout);
    /// Like the public function, but reports an error at `give_up` if the far end sends without
    /// line ends.
    [[nodiscard]] Result<std::optional<std::string>> receive(std::chrono::milliseconds timeout,
                                                             Clock::time_point give_up);
    /// Reads the bytes that have come. Errors: InputOutput, if the far end has closed the port.
    [[nodiscard]] Result<void> read_more();
    /// Explains why no reply to `line` came.
    [[nodiscard]] Error no_reply(std::string_view line) const;
    /// Waits for `due` replies. If `marked`, only lines with a valid mark count.
    [[nodiscard]] Result<std::vector<std::string>> collect(std::string_view line, std::size_t due,
                                                           bool marked);
    /// Returns whether a reply belongs to an earlier line than `asked`.
    [[nodiscard]] bool is_late(std::string_view asked, std::string_view reply) const;

    // The following functions are in first_contact.cpp.
    enum class Found { Yes, Refused, No };
    /// Sends a command with a mark and drops all lines until one is accepted.
    [[nodiscard]] Result<Found> probe(std::string_view command, const Accepts& accepts);
    [[nodiscard]] Result<FarEnd> find_far_end();
    /// Returns the timeout for a reply to a line of the user.
    [[nodiscard]] std::chrono::milliseconds line_timeout() const noexcept;

    std::unique_ptr<StopSignals> stop_ = std::make_unique<StopSignals>();
    std::unique_ptr<drivers::BytePort> port_;
    std::string received_;
    std::string skipped_; ///< the last line that was not a reply, for a message
    int interrupted_ = 0;

    FarEnd far_end_ = FarEnd::Silent;
    const protocol::Accelerator* accelerator_ = nullptr;
    std::string word_; ///< the random word of the first contact, if it needed one
    Clock::time_point contact_ends_;
    bool replied_ = false; ///< something that looks like a reply came during the first contact
};

/// Returns the accelerator in `OK accelerator=NAME …`, the reply to ACCELERATOR and to STATUS;
/// nullptr for any other reply and for an unknown name.
[[nodiscard]] const protocol::Accelerator* accelerator_of(std::string_view reply);

/// Sends the bytes and prints the replies. Returns the last line, OK or ERR without its mark, or an
/// empty string if no reply was due.
[[nodiscard]] Result<std::string> ask_and_print(Connection& connection, std::string_view bytes);

/// Prints the error, unless a signal caused it. Returns the exit status.
[[nodiscard]] int report(Connection& connection, const Error& error);

} // namespace raymarch::cli
