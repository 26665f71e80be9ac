// SPDX-License-Identifier: MIT
/// @file
/// A pseudo-terminal that stands in for a serial port, with a link to its other end.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <memory>
#include <string>

namespace raymarch::drivers
{

/// The service's end. Hosts come and go at the other end; each that leaves is a HungUp.
/// Wait for it edge-triggered: a terminal that nobody has open reports a hang-up all the time.
class PseudoTerminal final : public BytePort
{
  public:
    /// Makes the terminal, raw, and a symbolic link to it at `link`; a symbolic link that is there
    /// already is replaced, anything else is not. Errors: Unavailable, InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<PseudoTerminal>> open(const std::string& link);
    /// Removes the link if it is still its own.
    ~PseudoTerminal() override;

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

    /// The terminal's own name, /dev/pts/N.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

  private:
    PseudoTerminal(UniqueFd fd, std::string name, std::string link) noexcept
        : fd_(std::move(fd))
        , name_(std::move(name))
        , link_(std::move(link))
    {}
    void drop_unread_replies() noexcept;

    UniqueFd fd_;
    std::string name_;
    std::string link_;
    bool host_present_ = true;
};

} // namespace raymarch::drivers
