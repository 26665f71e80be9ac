// SPDX-License-Identifier: MIT
/// @file
/// A pseudo-terminal in place of a serial port, with a link to its other end.
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
/// something leaves, read() returns HungUp and the terminal is reset for the next host. Its
/// descriptor must be watched edge-triggered, because a terminal that nobody has open reports a
/// hang-up all the time.
class PseudoTerminal final : public BytePort
{
  public:
    /// Makes a raw terminal with mode 0660 for the service's group, and a symbolic link to it at
    /// `link`. An old symbolic link is replaced; anything else of that name is an error. LINK.lock
    /// keeps out a second service. Errors: Unavailable (also if another process has the link, as
    /// held_by_another() tells), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<PseudoTerminal>> open(const std::string& link);
    /// Removes the link if it still leads to this terminal.
    ~PseudoTerminal() override;

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    /// Returns Gone if a host left the terminal in exclusive mode (TIOCEXCL) and the service is not
    /// allowed to end that mode. A new terminal has to be made then.
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

    /// Becomes readable when a host has opened or closed the terminal; -1 if that cannot be
    /// watched. Call look() then.
    [[nodiscard]] int visits_fd() const noexcept { return visits_.get(); }
    /// If another host has followed the last one, resets the terminal for it; the next read()
    /// returns HungUp.
    void look() noexcept;

    /// Returns the path of the terminal, /dev/pts/N.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Returns false if the link was removed or replaced.
    [[nodiscard]] bool link_in_place() const noexcept;
    /// Makes the link again if it was removed. Errors: Unavailable.
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
    [[nodiscard]] bool reset_terminal() noexcept;
    [[nodiscard]] bool reset_for_next_host() noexcept;

    std::optional<LockFile> lock_; ///< declared first: the link is removed before the lock ends
    UniqueFd fd_;
    UniqueFd visits_;
    termios settings_; ///< each host finds these
    std::string name_;
    std::string link_;
    std::optional<FileIdentity> own_link_;
    int hosts_ = 0;           ///< known hosts that have the other end open
    bool left_ = false;       ///< the last host has left
    bool visited_ = false;    ///< a host has opened the terminal since the last hang-up
    bool host_spoke_ = false; ///< a host has sent something since the last hang-up
    bool hung_up_ = false;    ///< the next read() is to return HungUp
};

} // namespace raymarch::drivers
