// SPDX-License-Identifier: MIT
/// @file
/// A pseudo-terminal that stands in for a serial port, with a link to its other end.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/file_identity.hpp"
#include "drivers/lock_file.hpp"
#include "drivers/ports.hpp"

#include <termios.h>

#include <memory>
#include <optional>
#include <string>

namespace raymarch::drivers
{

/// The service's end of the terminal. Hosts open and close the other end. When a host that has sent
/// something leaves, a read() returns HungUp. The terminal is reset then, so that the next host
/// finds it as the first one did. Its descriptor must be watched edge-triggered, because a terminal
/// that nobody has open reports a hang-up all the time.
class PseudoTerminal final : public BytePort
{
  public:
    /// Makes a raw terminal of mode 0660 for the service's group, and a symbolic link to it at
    /// `link`. A symbolic link that is there already is replaced; anything else of that name is an
    /// error. LINK.lock keeps a second service from the link. Errors: Unavailable (also when
    /// another process has the link, as held_by_another() tells), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<PseudoTerminal>> open(const std::string& link);
    /// Removes the link if it still leads to this terminal.
    ~PseudoTerminal() override;

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    /// Returns Gone when a host left the terminal in exclusive mode (TIOCEXCL) and the service is
    /// not allowed to end that mode. A new terminal has to be made then.
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

    /// Becomes readable when a host has opened or closed the terminal; -1 when that cannot be
    /// watched. Where one host has followed another at once, look() resets the terminal for the new
    /// host, and the next read() returns HungUp. Only look() and read() can tell the two hosts
    /// apart, so look() is to be called whenever this descriptor is readable.
    [[nodiscard]] int visits_fd() const noexcept { return visits_.get(); }
    void look() noexcept;

    /// The path of the terminal itself, /dev/pts/N.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Returns false when the link was removed, or something else has its name now.
    [[nodiscard]] bool link_in_place() const noexcept;
    /// Makes the link again if nothing has its name. Errors: Unavailable.
    [[nodiscard]] Result<void> restore_link();

  private:
    PseudoTerminal(UniqueFd fd, UniqueFd visits, const termios& settings, std::string name,
                   std::string link) noexcept;
    /// The inotify events since the last call of take_visits().
    struct Visits
    {
        bool followed = false; ///< the last host left, and another one has come
        int events = 0;
    };
    [[nodiscard]] Visits take_visits() noexcept;
    [[nodiscard]] bool nobody_has_it_open() const noexcept;
    [[nodiscard]] bool put_in_order() noexcept;
    [[nodiscard]] bool start_afresh() noexcept;

    std::optional<LockFile> lock_; ///< first, so that the link is removed before the lock ends
    UniqueFd fd_;
    UniqueFd visits_;
    termios settings_; ///< each host finds these
    std::string name_;
    std::string link_;
    std::optional<FileIdentity> own_link_;
    int hosts_ = 0;           ///< hosts that have the other end open, as far as is known
    bool left_ = false;       ///< the last of them has left
    bool visited_ = false;    ///< a host has opened it since nobody had it open
    bool host_spoke_ = false; ///< a host has sent something since the last hang-up
    bool hung_up_ = false;    ///< the next read() is to return HungUp
};

} // namespace raymarch::drivers
