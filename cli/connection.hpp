// SPDX-License-Identifier: MIT
/// @file
/// The host's end of the protocol: lines out, replies in, over a serial port or the control socket.
///
/// A serial line may hold what an earlier host left: half a line on the way out, replies on the way
/// in. `open` brings it to a known state before anything is asked; first_contact.cpp does that.
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

/// Where the service is.
struct Endpoint
{
    std::string port;   ///< TTY[@BAUD]
    std::string socket; ///< path of the control socket
};

inline constexpr const char* default_socket = "/run/raymarchd/control";

/// Adds --port and --socket; without either the default socket is meant.
void add_endpoint_options(CLI::App& command, Endpoint& endpoint);

/// What the first contact found out about the far end.
enum class FarEnd {
    Speaks,     ///< it answers, with marks where it was asked with marks
    Unmarked,   ///< it answers, but not by the rules of marks: none are used
    OnlyErrors, ///< it sends ERR replies only: the service's setting `replies` says so
    Silent,     ///< it said nothing that could be a reply
};

/// While a Connection is there, Ctrl-C ends its waits and not the program: see `interrupted`.
class Connection
{
  public:
    /// Opens and makes first contact. A far end that stays silent is no error here: what is sent
    /// may still reach it. Errors: Usage, Unavailable, InputOutput.
    [[nodiscard]] static Result<Connection> open(const Endpoint& endpoint);

    /// Sends all bytes as they are; what comes meanwhile is kept for `receive`, so that both sides
    /// may be full of words. Errors: InputOutput, also when nothing moves for the time-out.
    [[nodiscard]] Result<void> send(std::string_view bytes);

    /// The next line that comes, without its ending; nothing when no byte comes for the length of
    /// the time-out. Errors: InputOutput.
    [[nodiscard]] Result<std::optional<std::string>>
    receive(std::chrono::milliseconds timeout = reply_timeout);

    /// Sends a user's bytes and an LF behind them, and collects the replies that are due, line by
    /// line as they came. Nothing is due for a blank line. Errors: InputOutput.
    [[nodiscard]] Result<std::vector<std::string>> ask(std::string_view bytes);

    /// Asks a command of the tool's own, marked where the far end knows marks, and gives the last
    /// line of its reply, OK or ERR, without its mark. Errors: InputOutput.
    [[nodiscard]] Result<std::string> request(std::string_view command);

    /// How `request` writes a command.
    [[nodiscard]] std::string request_line(std::string_view command) const;

    /// Brings the line to a known state again. Errors: InputOutput.
    [[nodiscard]] Result<void> synchronise();

    [[nodiscard]] FarEnd far_end() const noexcept { return far_end_; }
    /// What the far end said of itself at the first contact; nullptr where it said nothing known.
    [[nodiscard]] const protocol::Accelerator* accelerator() const noexcept { return accelerator_; }

    /// Becomes readable when a signal asks the program to stop.
    [[nodiscard]] int stop_fd() const noexcept { return stop_->fd(); }
    /// The signal that has come, or 0.
    [[nodiscard]] int interrupted() noexcept;
    /// Forgets the signal: the prompt of a console goes on after Ctrl-C.
    void forget_interruption() noexcept { interrupted_ = 0; }

    static constexpr std::chrono::milliseconds reply_timeout{5000};

  private:
    using Clock = std::chrono::steady_clock;
    using Accepts = std::function<bool(std::string_view reply)>;

    explicit Connection(std::unique_ptr<drivers::BytePort> port) : port_(std::move(port)) {}

    /// False when nothing happened in time. Errors: InputOutput, when a signal came.
    [[nodiscard]] Result<bool> wait(short events, std::chrono::milliseconds timeout);
    /// As the public one, and an error at `give_up`: a far end that sends without line ends is not
    /// listened to for ever.
    [[nodiscard]] Result<std::optional<std::string>> receive(std::chrono::milliseconds timeout,
                                                             Clock::time_point give_up);
    /// Takes what has come. Errors: InputOutput, when the other side has closed.
    [[nodiscard]] Result<void> read_more();
    /// Why nothing came that could be the reply to `line`.
    [[nodiscard]] Error no_reply(std::string_view line) const;
    /// Waits for `due` replies; `marked`: only lines with a right mark are some.
    [[nodiscard]] Result<std::vector<std::string>> collect(std::string_view line, std::size_t due,
                                                           bool marked);
    /// Whether a reply belongs to something else than `asked`.
    [[nodiscard]] bool is_late(std::string_view asked, std::string_view reply) const;

    // The first contact, first_contact.cpp.
    enum class Found { Yes, Refused, No };
    /// Asks with a mark and drops what comes until a reply is accepted.
    [[nodiscard]] Result<Found> probe(std::string_view command, const Accepts& accepts);
    [[nodiscard]] Result<FarEnd> find_far_end();
    /// How long a reply is waited for.
    [[nodiscard]] std::chrono::milliseconds patience() const noexcept;

    std::unique_ptr<StopSignals> stop_ = std::make_unique<StopSignals>();
    std::unique_ptr<drivers::BytePort> port_;
    std::string received_;
    std::string skipped_; ///< the last line that was not the reply, for a message
    int interrupted_ = 0;

    FarEnd far_end_ = FarEnd::Silent;
    const protocol::Accelerator* accelerator_ = nullptr;
    std::string word_; ///< the first contact's, where it needed one
    Clock::time_point contact_ends_;
    bool replied_ = false; ///< something that looks like a reply came during the first contact
};

/// The accelerator that `OK accelerator=NAME …` names, the reply to ACCELERATOR and to STATUS;
/// nullptr for another reply, and for a name that is not known here.
[[nodiscard]] const protocol::Accelerator* accelerator_of(std::string_view reply);

/// Asks and prints the replies. Gives their last line, OK or ERR without its mark; an empty one
/// where nothing was due.
[[nodiscard]] Result<std::string> ask_and_print(Connection& connection, std::string_view bytes);

/// Prints the error, unless it only says that a signal ended a wait, and gives the exit status.
[[nodiscard]] int report(Connection& connection, const Error& error);

} // namespace raymarch::cli
