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

/// The service's end. Hosts come and go at the other end; each that spoke and leaves is a HungUp,
/// and the next one finds the terminal as the first did, whatever the last one left in it. Wait for
/// it edge-triggered: a terminal that nobody has open reports a hang-up all the time.
class PseudoTerminal final : public BytePort
{
  public:
    /// Makes the terminal, raw, of mode 0660 for the service's group, and a symbolic link to it at
    /// `link`; a symbolic link that is there already is replaced, anything else is not. LINK.lock
    /// beside it keeps a second service off. Errors: Unavailable (also when another process has the
    /// link, as held_by_another() tells), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<PseudoTerminal>> open(const std::string& link);
    /// Removes the link if it is still its own.
    ~PseudoTerminal() override;

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    /// Gone when a host left the terminal to itself alone (TIOCEXCL), and the service may not take
    /// that back: a new one has to be made.
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

    /// Readable when a host has come or left; -1 when that cannot be watched. look() then puts the
    /// terminal in order for a host that came at once after another, and the next read() is a
    /// HungUp. While nobody looks, or no host says anything, nothing else tells the two from one.
    [[nodiscard]] int visits_fd() const noexcept { return visits_.get(); }
    void look() noexcept;

    /// The terminal's own name, /dev/pts/N.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// False when the link was removed, or something else has its name now.
    [[nodiscard]] bool link_in_place() const noexcept;
    /// Makes the link again where nothing has its name. Errors: Unavailable.
    [[nodiscard]] Result<void> restore_link();

  private:
    PseudoTerminal(UniqueFd fd, UniqueFd visits, const termios& settings, std::string name,
                   std::string link) noexcept;
    /// What inotify told since the last time.
    struct Visits
    {
        bool followed = false; ///< the last host left, and another one has come
        int events = 0;
    };
    [[nodiscard]] Visits take_visits() noexcept;
    [[nodiscard]] bool nobody_has_it_open() const noexcept;
    [[nodiscard]] bool put_in_order() noexcept;
    [[nodiscard]] bool start_afresh() noexcept;

    std::optional<LockFile> lock_; ///< first: the link goes before its lock
    UniqueFd fd_;
    UniqueFd visits_;
    termios settings_; ///< those that each host finds
    std::string name_;
    std::string link_;
    std::optional<FileIdentity> own_link_;
    int hosts_ = 0;           ///< how many have the other end open, as far as is known
    bool left_ = false;       ///< the last of them has left
    bool visited_ = false;    ///< somebody opened it since it was alone
    bool host_spoke_ = false; ///< since the last hang-up
    bool hung_up_ = false;    ///< and the next read is to say so
};

} // namespace raymarch::drivers
