// SPDX-License-Identifier: MIT
#include "drivers/pseudo_terminal.hpp"

#include "base/unfinished_file.hpp"
#include "drivers/serial_port.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// The settings live with the other end, but are set from this one as well.
bool set_raw(int fd) noexcept
{
    termios settings = {};
    if (::tcgetattr(fd, &settings) != 0)
        return false;
    make_raw(settings);
    return ::tcsetattr(fd, TCSANOW, &settings) == 0;
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
    UniqueFd fd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 64> name{};
    if (!fd || ::grantpt(fd.get()) != 0 || ::unlockpt(fd.get()) != 0 ||
        ::ptsname_r(fd.get(), name.data(), name.size()) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "make", "a pseudo-terminal"));
    if (!set_raw(fd.get()))
        return fail(errno_error(ErrorKind::InputOutput, "set up", name.data()));
    if (auto placed = place_link(name.data(), link); !placed)
        return fail(placed.error());
    return std::unique_ptr<PseudoTerminal>(
        new PseudoTerminal(std::move(fd), name.data(), fs::absolute(link).string()));
}

PseudoTerminal::~PseudoTerminal()
{
    std::error_code error;
    if (fs::read_symlink(link_, error) == name_ && !error)
        fs::remove(link_, error);
}

/// Replies that the old host did not read would greet the next one.
void PseudoTerminal::drop_unread_replies() noexcept
{
    const UniqueFd other_end(::open(name_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (other_end)
        ::tcflush(other_end.get(), TCIFLUSH);
}

ReadOutcome PseudoTerminal::read(std::span<char> into) noexcept
{
    const ReadOutcome outcome = read_some(fd_.get(), into, ReadStatus::HungUp);
    if (outcome.status == ReadStatus::Data)
        host_present_ = true;
    if (outcome.status != ReadStatus::HungUp)
        return outcome;
    static_cast<void>(set_raw(fd_.get())); // a host may have set it up otherwise, and said nothing
    // Opening and closing the other end makes a hang-up of its own; that one is not news.
    if (!host_present_)
        return {ReadStatus::Empty, 0};
    host_present_ = false;
    drop_unread_replies();
    return outcome;
}

std::size_t PseudoTerminal::write(std::string_view bytes) noexcept
{
    return write_some(fd_.get(), bytes);
}

} // namespace raymarch::drivers
