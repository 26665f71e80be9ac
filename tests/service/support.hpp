// SPDX-License-Identifier: MIT
/// @file
/// What tests of whole processes need: a folder, a child, a service, a host that talks to it.
#pragma once

#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::tests
{

/// How long anything may take before a test fails; far more than it takes on a loaded machine.
inline constexpr std::chrono::seconds patience{60};

/// Whether `condition` comes true; looks again and again.
[[nodiscard]] bool eventually(const std::function<bool()>& condition);

/// A new folder that is removed with all it holds.
class TemporaryFolder
{
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    [[nodiscard]] std::string operator/(std::string_view name) const;

  private:
    std::string path_;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// A child process; killed when it is still there at the end.
class Process
{
  public:
    /// Standard error goes to `error_file`, standard output to a file beside it.
    Process(std::vector<std::string> command, const std::string& error_file,
            const Environment& environment = {}, const std::string& input_file = "/dev/null");
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    void signal(int number) const;
    [[nodiscard]] pid_t pid() const { return pid_; }
    [[nodiscard]] bool running();
    /// The exit status; 128 + N when signal N ended it; -1 when it does not end.
    [[nodiscard]] int wait();
    [[nodiscard]] std::string errors() const;
    [[nodiscard]] std::string output() const;

  private:
    pid_t pid_;
    int status_ = -1;
    std::string error_file_;
};

/// Runs raymarchctl to its end.
struct Finished
{
    int status;
    std::string output;
    std::string errors;
};
[[nodiscard]] Finished run_tool(const TemporaryFolder& folder, std::vector<std::string> arguments,
                                std::string_view input = {});

/// raymarchd on a register file, a pseudo-terminal and a control socket in `folder`. Options given
/// replace those.
class Service
{
  public:
    /// `shell`, where there is one, is a script that ends in `exec "$@"`, and so becomes the
    /// service.
    explicit Service(const TemporaryFolder& folder, std::vector<std::string> options = {},
                     const Environment& environment = {}, const std::string& shell = {});

    /// Waits for the control socket to answer.
    [[nodiscard]] bool ready() const;
    /// Waits until the log says `text`.
    [[nodiscard]] bool says(std::string_view text) const;
    /// How often the log says it.
    [[nodiscard]] std::size_t count(std::string_view text) const;
    /// The value of a STATUS field; empty when there is none.
    [[nodiscard]] std::string status(std::string_view field) const;
    /// The first eight words of the register file.
    [[nodiscard]] std::vector<std::uint32_t> words() const;

    [[nodiscard]] std::string terminal() const { return folder_ / "tty"; }
    [[nodiscard]] std::string control() const { return folder_ / "control"; }
    [[nodiscard]] std::string registers() const { return folder_ / "registers"; }
    Process process;

  private:
    const TemporaryFolder& folder_;
};

/// One end of a conversation.
class Host
{
  public:
    /// The terminal at `path`, raw.
    [[nodiscard]] static Host on_terminal(const std::string& path);
    [[nodiscard]] static Host on_socket(const std::string& path);
    explicit Host(UniqueFd fd) : fd_(std::move(fd)) {}

    void send(std::string_view bytes) const;
    /// The next reply without its ending; empty when none comes.
    [[nodiscard]] std::string reply();
    [[nodiscard]] std::string ask(std::string_view line);
    [[nodiscard]] bool connected() const { return static_cast<bool>(fd_); }
    [[nodiscard]] int fd() const { return fd_.get(); }

  private:
    UniqueFd fd_;
    std::string received_;
};

/// The frame of the original user interface, and the words that it means.
inline const std::string original_line =
    "FX=0.000,FY=0.000,FZ=1.000,RX=1.000,RY=0.000,RZ=0.000,UX=0.000,UY=1.000,UZ=0.000,ZM=3.00,"
    "LX=3.000,LY=2.000,LZ=5.000,R=1.000,G=1.000,B=1.000,OBJ=sphere";
inline const std::vector<std::uint32_t> original_words = {
    0x01804028, 0x03000000, 0x00000000, 0x07FFFFFF, 0x7FFFC000, 0x000003FF, 0x00001FFF, 0xF00003FF};

} // namespace raymarch::tests
