// SPDX-License-Identifier: MIT
/// @file
/// A serial port: raw, 8N1, exclusive. Its old settings are restored when it is closed.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <termios.h>

#include <memory>
#include <string>

namespace raymarch::drivers
{

/// A UART, a USB converter, or a host's end of a pseudo-terminal.
class SerialPort final : public BytePort
{
  public:
    /// Errors: Usage (there is no such baud rate), Unavailable (there is no such tty, or another
    /// process has it), InputOutput (the tty does not accept the settings).
    [[nodiscard]] static Result<std::unique_ptr<SerialPort>> open(const std::string& path,
                                                                  unsigned baud);
    ~SerialPort() override;

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

  private:
    SerialPort(UniqueFd fd, const termios& before) noexcept : fd_(std::move(fd)), before_(before) {}

    UniqueFd fd_;
    termios before_;
};

[[nodiscard]] bool is_baud_rate(unsigned baud) noexcept;
/// Returns all baud rates, for a message.
[[nodiscard]] std::string baud_rates();

/// Sets raw mode: no echo, no translation, no signals, no flow control; 8 bits, no parity, one stop
/// bit, the receiver on and the modem lines ignored.
void make_raw(termios& settings) noexcept;

/// Does one non-blocking read or write for a BytePort. EIO and end of file give `at_end`.
[[nodiscard]] ReadOutcome read_some(int fd, std::span<char> into, ReadStatus at_end) noexcept;
[[nodiscard]] std::size_t write_some(int fd, std::string_view bytes) noexcept;

} // namespace raymarch::drivers
