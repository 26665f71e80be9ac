// SPDX-License-Identifier: MIT
/// @file
/// A program under measurement: a child that serves a pseudo-terminal and writes a register file.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::bench
{

/// A folder under the system's temporary one; removed with all that is in it.
class TemporaryFolder
{
  public:
    [[nodiscard]] static Result<TemporaryFolder> make();
    TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
    std::filesystem::path path_;
};

class TerminalChild
{
  public:
    /// Starts `command` with `{registers}` and `{link}` in its words replaced by paths in `folder`,
    /// and opens the terminal behind the link as soon as it is there, within five seconds. Errors:
    /// Unavailable (it ended, or made no link in time), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<TerminalChild>>
    start(const std::vector<std::string>& command, const std::filesystem::path& folder);
    TerminalChild(const TerminalChild&) = delete;
    TerminalChild& operator=(const TerminalChild&) = delete;
    /// Ends the child: SIGTERM, and SIGKILL after two seconds.
    ~TerminalChild();

    /// What the register file holds now.
    [[nodiscard]] std::uint32_t word(std::size_t index) const noexcept { return page_[index]; }

    /// False when the terminal did not take all of it.
    [[nodiscard]] bool write(std::string_view bytes) noexcept;
    /// Throws away what the child has sent.
    void drain() noexcept;

  private:
    TerminalChild() = default;
    [[nodiscard]] Result<void> map_registers(const std::filesystem::path& path);
    [[nodiscard]] Result<void> open_terminal(const std::filesystem::path& link);
    [[nodiscard]] bool ended() noexcept;

    const volatile std::uint32_t* page_ = nullptr;
    pid_t pid_ = -1;
    UniqueFd terminal_;
};

} // namespace raymarch::bench
