// SPDX-License-Identifier: MIT
/// @file
/// The other end of a line for raymarchctl, as a test wants it to behave.
#pragma once

#include "service/support.hpp"

#include <array>
#include <functional>
#include <string>
#include <thread>

namespace raymarch::tests
{

/// A socket that listens, or a pseudo-terminal, and a thread that speaks for it. The behaviour gets
/// a descriptor that blocks, and returns when a read says that the tool has left.
class FarEnd
{
  public:
    using Behaviour = std::function<void(int fd)>;
    enum class Place { Socket, Terminal };

    FarEnd(const TemporaryFolder& folder, Place place, Behaviour behaviour);
    FarEnd(const FarEnd&) = delete;
    FarEnd& operator=(const FarEnd&) = delete;
    ~FarEnd();

    /// `{"--socket", PATH}` or `{"--port", PATH}`.
    [[nodiscard]] std::vector<std::string> options() const { return options_; }

  private:
    UniqueFd listener_; ///< or the terminal's own end, which is the behaviour's
    UniqueFd held_;     ///< the tool's end of the terminal: it stays raw until the tool is there
    std::vector<std::string> options_;
    std::thread thread_;
};

inline constexpr std::array places = {FarEnd::Place::Socket, FarEnd::Place::Terminal};

/// Writes all of it; false when the tool has left.
bool write_all(int fd, std::string_view bytes);

/// The next bytes; empty at the end.
[[nodiscard]] std::string read_bytes(int fd);

/// Answers each line that is not blank with what `answer` gives, until the tool leaves.
[[nodiscard]] FarEnd::Behaviour answers(std::function<std::string(const std::string& line)> answer);

/// A line to a service, on which an earlier host has left something.
struct Left
{
    std::string sent{};   ///< to the service, before the tool comes
    std::string coming{}; ///< to the tool, before anything that the service says
    bool echoes = false;  ///< what the tool sends comes back
};
[[nodiscard]] FarEnd::Behaviour relays(std::string control_socket, Left left);

/// `line*HH`, CR and LF: a reply to a line with a mark.
[[nodiscard]] std::string marked(std::string_view line);

} // namespace raymarch::tests
