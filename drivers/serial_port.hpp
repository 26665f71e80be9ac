// SPDX-License-Identifier: MIT
/// @file
/// A serial port: raw, 8N1, exclusive; the old settings come back when it is closed. Of a
/// pseudo-terminal only the lock is exclusive: it is all that a killed program does not leave
/// behind.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <termios.h>

#include <memory>
#include <string>

namespace raymarch::drivers
{

/// A tty that is there as a device: a UART, or a USB converter.
class SerialPort final : public BytePort
{
  public:
    /// Errors: Usage (a baud rate that no tty has), Unavailable (no such tty, or another process
    /// has it), InputOutput (it does not take the settings).
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
/// All of them, for a message.
[[nodiscard]] std::string baud_rates();

/// Bytes as they are: no echo, no translation, no signals, no flow control; 8 bits, no parity, one
/// stop bit, the receiver on and the modem lines ignored.
void make_raw(termios& settings) noexcept;

/// One non-blocking read or write as a BytePort reports it. EIO and end of file are `at_end`.
[[nodiscard]] ReadOutcome read_some(int fd, std::span<char> into, ReadStatus at_end) noexcept;
[[nodiscard]] std::size_t write_some(int fd, std::string_view bytes) noexcept;

} // namespace raymarch::drivers
