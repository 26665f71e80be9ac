// SPDX-License-Identifier: MIT
/// @file
/// The interfaces to the hardware: registers, byte streams, Ethernet frames and digital lines. A
/// test implements them without a device.
#pragma once

#include "base/result.hpp"

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace raymarch::drivers
{

/// The offset of a register in its window. It is a multiple of 4.
struct RegOffset
{
    std::uint16_t bytes = 0;
    auto operator<=>(const RegOffset&) const = default;
};

/// A window of 32-bit registers with an optional interrupt line.
class RegisterBus
{
  public:
    RegisterBus() = default;
    RegisterBus(const RegisterBus&) = delete;
    RegisterBus& operator=(const RegisterBus&) = delete;
    virtual ~RegisterBus() = default;

    /// Does one aligned load. Precondition: `at` lies inside the window.
    [[nodiscard]] virtual std::uint32_t read(RegOffset at) noexcept = 0;
    /// Does one aligned store, in program order.
    virtual void write(RegOffset at, std::uint32_t word) noexcept = 0;

    /// Becomes readable when an interrupt has come; -1 if there is no interrupt line.
    [[nodiscard]] virtual int interrupt_fd() const noexcept = 0;
    /// Unmasks the interrupt.
    virtual void arm_interrupt() noexcept = 0;
    /// Reads interrupt_fd(). Returns the number of interrupts so far.
    [[nodiscard]] virtual Result<std::uint32_t> take_interrupt() = 0;

    /// Returns true when the registers have gone away. Loads then return 0.
    [[nodiscard]] virtual bool lost() const noexcept = 0;
};

/// The result of BytePort::read().
enum class ReadStatus : std::uint8_t {
    Data,   ///< `size` bytes were read
    Empty,  ///< there is nothing to read now
    HungUp, ///< the other side closed the port; another host may open it
    Gone,   ///< the port cannot be used any more
};
struct ReadOutcome
{
    ReadStatus status = ReadStatus::Empty;
    std::size_t size = 0;
};

/// A non-blocking stream of bytes in both directions.
class BytePort
{
  public:
    BytePort() = default;
    BytePort(const BytePort&) = delete;
    BytePort& operator=(const BytePort&) = delete;
    virtual ~BytePort() = default;

    /// Use this descriptor only to wait for the port.
    [[nodiscard]] virtual int fd() const noexcept = 0;
    [[nodiscard]] virtual ReadOutcome read(std::span<char> into) noexcept = 0;
    /// Returns how many bytes were written, possibly none.
    [[nodiscard]] virtual std::size_t write(std::string_view bytes) noexcept = 0;
};

/// A network interface. A frame goes from the destination address to the last byte of data.
class FramePort
{
  public:
    FramePort() = default;
    FramePort(const FramePort&) = delete;
    FramePort& operator=(const FramePort&) = delete;
    virtual ~FramePort() = default;

    /// Returns when the kernel has accepted the frame. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> send(std::span<const std::uint8_t> frame) = 0;
    /// Receives the next incoming frame, cut to the size of `into`. Returns its size, or nothing if
    /// no frame comes within `timeout`. Errors: InputOutput.
    [[nodiscard]] virtual Result<std::optional<std::size_t>>
    receive(std::span<std::uint8_t> into, std::chrono::milliseconds timeout) = 0;
};

/// A change of the logical level, which is inverted if the line is active-low.
struct Edge
{
    bool level = false;
    std::chrono::nanoseconds at{}; ///< the kernel's timestamp of the edge
};

/// One digital line: a button, a switch or an LED.
class Pin
{
  public:
    Pin() = default;
    Pin(const Pin&) = delete;
    Pin& operator=(const Pin&) = delete;
    virtual ~Pin() = default;

    /// Reads the logical level. Errors: InputOutput.
    [[nodiscard]] virtual Result<bool> read() = 0;
    /// Sets an output. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> write(bool on) = 0;
    /// Becomes readable when an edge has come; -1 for outputs, and for inputs without edges.
    [[nodiscard]] virtual int edge_fd() const noexcept = 0;
    /// Returns the oldest edge that has not been read, or nothing if there is none. Errors:
    /// InputOutput.
    [[nodiscard]] virtual Result<std::optional<Edge>> take_edge() = 0;
};

} // namespace raymarch::drivers
