// SPDX-License-Identifier: MIT
#include "drivers/pseudo_terminal.hpp"

#include "base/temporary_file.hpp"
#include "drivers/serial_port.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// Both ends of a pseudo-terminal share their settings.
std::optional<termios> set_raw(int fd) noexcept
{
    termios settings = {};
    if (::tcgetattr(fd, &settings) != 0)
        return std::nullopt;
    make_raw(settings);
    if (::tcsetattr(fd, TCSANOW, &settings) != 0)
        return std::nullopt;
    return settings;
}

/// Gives the service's group access, as to the control socket. The group and the mode of a new node
/// come from the mount options of /dev/pts, not from the umask.
void open_to_group(const std::string& node) noexcept
{
    if (::chown(node.c_str(), static_cast<uid_t>(-1), ::getegid()) == 0)
        static_cast<void>(::chmod(node.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP));
}

constexpr std::uint32_t closed = IN_CLOSE_WRITE | IN_CLOSE_NOWRITE;

/// Watches hosts open and close the node. If no inotify watch is left, the service notices a host
/// only when it sends something, and its leaving only when nobody else has the terminal open.
UniqueFd watch_visits(const std::string& node) noexcept
{
    UniqueFd visits(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    if (::inotify_add_watch(visits.get(), node.c_str(), IN_OPEN | closed) < 0)
        visits.reset();
    return visits;
}

Result<void> place_link(const std::string& target, const fs::path& link)
{
    std::error_code error;
    const fs::file_status there = fs::symlink_status(link, error);
    if (fs::exists(there) && !fs::is_symlink(there))
        return fail(plain_error(ErrorKind::Unavailable,
                                link.string() + " exists and is not a symbolic link"));
    const auto fresh = make_temporary(link, [&](const std::string& name) {
        return ::symlink(target.c_str(), name.c_str()) == 0;
    });
    if (!fresh)
        return fail(Error{ErrorKind::Unavailable, fresh.error().number, fresh.error().message});
    fs::rename(*fresh, link, error);
    if (!error)
        return {};
    ::unlink(fresh->c_str());
    return fail(
        plain_error(ErrorKind::Unavailable, "link " + link.string() + ": " + error.message()));
}

} // namespace

Result<std::unique_ptr<PseudoTerminal>> PseudoTerminal::open(const std::string& link)
{
    const std::string place = fs::absolute(link).string();
    auto lock = LockFile::take(place + ".lock");
    if (!lock && held_by_another(lock.error()))
        return fail(Error{ErrorKind::Unavailable, lock.error().number,
                          "link " + link + ": " + lock.error().message});
    UniqueFd fd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 64> name{};
    if (!fd || ::grantpt(fd.get()) != 0 || ::unlockpt(fd.get()) != 0 ||
        ::ptsname_r(fd.get(), name.data(), name.size()) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "make", "a pseudo-terminal"));
    const auto settings = set_raw(fd.get());
    if (!settings)
        return fail(errno_error(ErrorKind::InputOutput, "set up", name.data()));
    open_to_group(name.data());
    // The terminal reports a hang-up only after the other end has been opened and closed once.
    UniqueFd(::open(name.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)).reset();
    UniqueFd visits = watch_visits(name.data());
    if (auto placed = place_link(name.data(), place); !placed)
        return fail(placed.error());
    std::unique_ptr<PseudoTerminal> terminal(
        new PseudoTerminal(std::move(fd), std::move(visits), *settings, name.data(), place));
    if (lock)
        terminal->lock_.emplace(std::move(*lock));
    return terminal;
}

PseudoTerminal::PseudoTerminal(UniqueFd fd, UniqueFd visits, const termios& settings,
                               std::string name, std::string link) noexcept
    : fd_(std::move(fd))
    , visits_(std::move(visits))
    , settings_(settings)
    , name_(std::move(name))
    , link_(std::move(link))
    , own_link_(identity_of_link(link_))
{}

PseudoTerminal::~PseudoTerminal()
{
    if (link_in_place())
        ::unlink(link_.c_str());
}

bool PseudoTerminal::link_in_place() const noexcept
{
    return own_link_ && identity_of_link(link_) == own_link_;
}

Result<void> PseudoTerminal::restore_link()
{
    if (link_in_place())
        return {};
    if (::symlink(name_.c_str(), link_.c_str()) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "link", link_));
    own_link_ = identity_of_link(link_);
    return {};
}

/// inotify joins two equal events that follow each other. So hosts that come or leave together are
/// miscounted. A host may then count as the successor of the last one, and unread replies are lost.
PseudoTerminal::Visits PseudoTerminal::take_visits() noexcept
{
    Visits visits;
    std::array<char, 1024> chunk; // NOLINT(*-member-init): read before use
    for (ssize_t size = 0;
         visits_ && (size = ::read(visits_.get(), chunk.data(), chunk.size())) > 0;) {
        inotify_event event = {};
        for (std::size_t at = 0; at < static_cast<std::size_t>(size);
             at += sizeof event + event.len) {
            std::memcpy(&event, chunk.data() + at, sizeof event); // it is not aligned
            ++visits.events;
            if ((event.mask & IN_OPEN) != 0) {
                ++hosts_;
                visited_ = true;
                visits.followed = std::exchange(left_, false) || visits.followed;
            } else if ((event.mask & closed) != 0 && hosts_ > 0) {
                left_ = --hosts_ == 0;
            }
        }
    }
    return visits;
}

void PseudoTerminal::look() noexcept
{
    if (!take_visits().followed)
        return;
    hung_up_ = hung_up_ || std::exchange(host_spoke_, false);
    static_cast<void>(reset_for_next_host());
}

bool PseudoTerminal::nobody_has_it_open() const noexcept
{
    pollfd end = {.fd = fd_.get(), .events = 0, .revents = 0};
    return ::poll(&end, 1, 0) > 0 && (end.revents & POLLHUP) != 0;
}

/// Undoes what the last host left in the terminal: its settings, stopped output, unread replies,
/// exclusive mode. Returns false if exclusive mode keeps out the service, and thus every host.
bool PseudoTerminal::reset_terminal() noexcept
{
    const bool alone = nobody_has_it_open();
    ::tcsetattr(fd_.get(), TCSANOW, &settings_);
    const UniqueFd other_end(::open(name_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!other_end)
        return errno != EBUSY || !nobody_has_it_open();
    const int ordinary = N_TTY;
    ::ioctl(other_end.get(), TIOCSETD, &ordinary);
    if (alone) // otherwise the next host may have set the exclusive mode
        ::ioctl(other_end.get(), TIOCNXCL);
    ::tcflow(other_end.get(), TCOON);
    ::tcflush(other_end.get(), TCIFLUSH);
    return true;
}

/// The reset opens and closes the terminal, too. Its own events are read here, so that they do not
/// count as a host.
bool PseudoTerminal::reset_for_next_host() noexcept
{
    constexpr int max_tries = 3;  // a host may open and close the terminal all the time
    constexpr int own_events = 2; // one open, one close
    for (int tries = 0; tries < max_tries; ++tries) {
        if (!reset_terminal())
            return false;
        if (take_visits().events <= own_events)
            break; // nobody has come or left meanwhile
    }
    // The event of a host that has it open but was not counted comes next, or was joined with ours.
    left_ = hosts_ == 0 && !nobody_has_it_open();
    return true;
}

ReadOutcome PseudoTerminal::read(std::span<char> into) noexcept
{
    // The bytes are counted first, so that look() knows every host that sent one of them.
    int waiting = 0;
    ::ioctl(fd_.get(), FIONREAD, &waiting);
    look();
    if (std::exchange(hung_up_, false))
        return {ReadStatus::HungUp, 0}; // it comes before the first bytes of the next host
    if (waiting <= 0 && !nobody_has_it_open())
        return {ReadStatus::Empty, 0};
    if (waiting > 0)
        into = into.first(std::min(into.size(), static_cast<std::size_t>(waiting)));
    const ReadOutcome outcome = read_some(fd_.get(), into, ReadStatus::HungUp);
    if (outcome.status == ReadStatus::Data)
        host_spoke_ = true;
    if (outcome.status != ReadStatus::HungUp)
        return outcome;
    // A hang-up that reset_terminal() caused is not reported.
    if (!visited_ && !host_spoke_)
        return {ReadStatus::Empty, 0};
    hosts_ = 0;
    if (!reset_for_next_host())
        return {ReadStatus::Gone, 0};
    visited_ = !nobody_has_it_open();
    return {std::exchange(host_spoke_, false) ? ReadStatus::HungUp : ReadStatus::Empty, 0};
}

std::size_t PseudoTerminal::write(std::string_view bytes) noexcept
{
    return write_some(fd_.get(), bytes);
}

} // namespace raymarch::drivers
