// SPDX-License-Identifier: MIT
#include "drivers/serial_port.hpp"

#include "drivers/lock_file.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>

namespace raymarch::drivers
{
namespace
{

struct Speed
{
    unsigned baud;
    speed_t code;
};
constexpr std::array speeds = {
    Speed{1200, B1200},       Speed{2400, B2400},       Speed{4800, B4800},
    Speed{9600, B9600},       Speed{19200, B19200},     Speed{38400, B38400},
    Speed{57600, B57600},     Speed{115200, B115200},   Speed{230400, B230400},
    Speed{460800, B460800},   Speed{500000, B500000},   Speed{576000, B576000},
    Speed{921600, B921600},   Speed{1000000, B1000000}, Speed{1152000, B1152000},
    Speed{1500000, B1500000}, Speed{2000000, B2000000}, Speed{2500000, B2500000},
    Speed{3000000, B3000000}, Speed{3500000, B3500000}, Speed{4000000, B4000000},
};

std::optional<speed_t> speed_of(unsigned baud) noexcept
{
    for (const Speed& speed : speeds)
        if (speed.baud == baud)
            return speed.code;
    return std::nullopt;
}

/// tcsetattr() succeeds if it could set any of the settings, so they are read back.
bool has_settings(int fd, const termios& wanted) noexcept
{
    termios now = {};
    return ::tcgetattr(fd, &now) == 0 && now.c_cflag == wanted.c_cflag &&
           now.c_lflag == wanted.c_lflag && ::cfgetospeed(&now) == ::cfgetospeed(&wanted);
}

/// Returns whether the device number is that of a host's end of a pseudo-terminal.
bool is_pseudo_terminal(int fd) noexcept
{
    constexpr unsigned first_major =
        136; // Documentation/admin-guide/devices.txt: UNIX98 PTY slaves
    constexpr unsigned last_major = 143;
    struct stat info = {};
    if (::fstat(fd, &info) != 0 || !S_ISCHR(info.st_mode))
        return false;
    const unsigned number = major(info.st_rdev);
    return number >= first_major && number <= last_major;
}

} // namespace

bool is_baud_rate(unsigned baud) noexcept
{
    return speed_of(baud).has_value();
}

std::string baud_rates()
{
    std::string text;
    for (const Speed& speed : speeds)
        text.append(text.empty() ? "" : " ").append(std::to_string(speed.baud));
    return text;
}

void make_raw(termios& settings) noexcept
{
    ::cfmakeraw(&settings); // it keeps XOFF for the other side and other flags
    settings.c_iflag = 0;
    settings.c_oflag = 0;
    settings.c_lflag = 0;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | PARENB | CRTSCTS | HUPCL);
    settings.c_cflag |= CS8 | CREAD | CLOCAL;
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
}

ReadOutcome read_some(int fd, std::span<char> into, ReadStatus at_end) noexcept
{
    for (;;) {
        const ssize_t size = ::read(fd, into.data(), into.size());
        if (size > 0)
            return {ReadStatus::Data, static_cast<std::size_t>(size)};
        if (size == 0 || errno == EIO)
            return {at_end, 0};
        if (errno == EAGAIN)
            return {ReadStatus::Empty, 0};
        if (errno != EINTR)
            return {ReadStatus::Gone, 0};
    }
}

std::size_t write_some(int fd, std::string_view bytes) noexcept
{
    for (;;) {
        const ssize_t size = ::write(fd, bytes.data(), bytes.size());
        if (size >= 0)
            return static_cast<std::size_t>(size);
        if (errno != EINTR)
            return 0; // the port is full or gone; the next read tells which
    }
}

Result<std::unique_ptr<SerialPort>> SerialPort::open(const std::string& path, unsigned baud)
{
    const auto speed = speed_of(baud);
    if (!speed)
        return fail(plain_error(ErrorKind::Usage, path + ": there is no baud rate " +
                                                      std::to_string(baud) + "; the rates are " +
                                                      baud_rates()));
    UniqueFd fd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", path));
    // TIOCEXCL keeps out every process that opens the tty later, except root's. The lock keeps out
    // programs that use locks, and ends with the process. TIOCEXCL stays as long as any process has
    // the tty open, so it is not set on a pseudo-terminal, which the service keeps open.
    if (auto locked = lock_descriptor(fd.get(), path); !locked && held_by_another(locked.error()))
        return fail(locked.error());
    termios before = {};
    if (::tcgetattr(fd.get(), &before) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "read the terminal settings of", path));
    if (!is_pseudo_terminal(fd.get()) && ::ioctl(fd.get(), TIOCEXCL) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "get exclusive access to", path));

    std::unique_ptr<SerialPort> port(new SerialPort(std::move(fd), before));
    termios settings = before;
    make_raw(settings);
    ::cfsetispeed(&settings, *speed);
    ::cfsetospeed(&settings, *speed);
    if (::tcsetattr(port->fd(), TCSANOW, &settings) != 0 || !has_settings(port->fd(), settings))
        return fail(
            plain_error(ErrorKind::InputOutput,
                        path + " does not accept " + std::to_string(baud) + " baud, 8N1, raw"));
    ::tcflush(port->fd(), TCIFLUSH);
    return port;
}

SerialPort::~SerialPort()
{
    ::tcsetattr(fd_.get(), TCSANOW, &before_);
    ::ioctl(fd_.get(), TIOCNXCL);
}

ReadOutcome SerialPort::read(std::span<char> into) noexcept
{
    return read_some(fd_.get(), into, ReadStatus::Gone);
}

std::size_t SerialPort::write(std::string_view bytes) noexcept
{
    return write_some(fd_.get(), bytes);
}

} // namespace raymarch::drivers
