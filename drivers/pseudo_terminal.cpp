// SPDX-License-Identifier: MIT
#include "drivers/pseudo_terminal.hpp"

#include "base/unfinished_file.hpp"
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

/// The settings live with the other end, but are set from this one as well.
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

/// For the service's group, as the control socket. The node belongs to the user of the service, but
/// its group and mode come from how /dev/pts is mounted, not from the umask.
void open_to_group(const std::string& node) noexcept
{
    if (::chown(node.c_str(), static_cast<uid_t>(-1), ::getegid()) == 0)
        static_cast<void>(::chmod(node.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP));
}

constexpr std::uint32_t closed = IN_CLOSE_WRITE | IN_CLOSE_NOWRITE;

/// Tells of each host that opens or closes the node. Without it (no watch is left) only hosts that
/// speak and leave the terminal to nobody are known.
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
                                link.string() + " is there and is no symbolic link"));
    const auto fresh = make_beside(link, [&](const std::string& name) {
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
    // Once opened and closed, it says of itself that nobody has it open.
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

/// inotify tells two equal events that nobody took in between as one. So hosts that come or leave
/// together are miscounted, and the next one may be taken for the last one's successor, which costs
/// replies that have not been read by then.
PseudoTerminal::Visits PseudoTerminal::take_visits() noexcept
{
    Visits visits;
    std::array<char, 1024> chunk; // NOLINT(*-member-init): read before use
    for (ssize_t size = 0;
         visits_ && (size = ::read(visits_.get(), chunk.data(), chunk.size())) > 0;) {
        inotify_event event = {};
        for (std::size_t at = 0; at < static_cast<std::size_t>(size);
             at += sizeof event + event.len) {
            std::memcpy(&event, chunk.data() + at, sizeof event); // whose place is not aligned
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
    static_cast<void>(start_afresh());
}

bool PseudoTerminal::nobody_has_it_open() const noexcept
{
    pollfd end = {.fd = fd_.get(), .events = 0, .revents = 0};
    return ::poll(&end, 1, 0) > 0 && (end.revents & POLLHUP) != 0;
}

/// Removes what the last host left in the terminal, which the next host would find: its settings,
/// output that it stopped, replies that it did not read, exclusive mode. Returns false when
/// exclusive mode keeps out the service as well, and thus every host for good.
bool PseudoTerminal::put_in_order() noexcept
{
    const bool alone = nobody_has_it_open();
    ::tcsetattr(fd_.get(), TCSANOW, &settings_);
    const UniqueFd other_end(::open(name_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!other_end)
        return errno != EBUSY || !nobody_has_it_open();
    const int ordinary = N_TTY;
    ::ioctl(other_end.get(), TIOCSETD, &ordinary);
    if (alone) // else it is the next host's own
        ::ioctl(other_end.get(), TIOCNXCL);
    ::tcflow(other_end.get(), TCOON);
    ::tcflush(other_end.get(), TCIFLUSH);
    return true;
}

/// Puts the terminal in order for whoever has it open by now. To do so is a visit, too: its events
/// are taken here, or the service would follow itself for ever.
bool PseudoTerminal::start_afresh() noexcept
{
    constexpr int most_tries = 3; // a host that comes and goes all the time does not hold us
    constexpr int own_events = 2; // opened, closed
    for (int tries = 0; tries < most_tries; ++tries) {
        if (!put_in_order())
            return false;
        if (take_visits().events <= own_events)
            break; // nobody has come or left meanwhile
    }
    // Who has it open but was not counted is told of next, or was told of together with us.
    left_ = hosts_ == 0 && !nobody_has_it_open();
    return true;
}

ReadOutcome PseudoTerminal::read(std::span<char> into) noexcept
{
    // In this order: who has said one of these bytes has been seen to come.
    int waiting = 0;
    ::ioctl(fd_.get(), FIONREAD, &waiting);
    look();
    if (std::exchange(hung_up_, false))
        return {ReadStatus::HungUp, 0}; // before the next host's first bytes
    if (waiting <= 0 && !nobody_has_it_open())
        return {ReadStatus::Empty, 0};
    if (waiting > 0)
        into = into.first(std::min(into.size(), static_cast<std::size_t>(waiting)));
    const ReadOutcome outcome = read_some(fd_.get(), into, ReadStatus::HungUp);
    if (outcome.status == ReadStatus::Data)
        host_spoke_ = true;
    if (outcome.status != ReadStatus::HungUp)
        return outcome;
    // Opening and closing the other end makes a hang-up of its own; that one is not news.
    if (!visited_ && !host_spoke_)
        return {ReadStatus::Empty, 0};
    hosts_ = 0;
    if (!start_afresh())
        return {ReadStatus::Gone, 0};
    visited_ = !nobody_has_it_open();
    return {std::exchange(host_spoke_, false) ? ReadStatus::HungUp : ReadStatus::Empty, 0};
}

std::size_t PseudoTerminal::write(std::string_view bytes) noexcept
{
    return write_some(fd_.get(), bytes);
}

} // namespace raymarch::drivers
