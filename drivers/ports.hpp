// SPDX-License-Identifier: MIT
/// @file
/// The four seams to the world. Everything above them can be tested without a device.
///
/// This layer moves words, bytes, frames and levels; what they mean is not its business.
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

/// A byte offset into a register window, a multiple of 4.
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

    /// One aligned load. Precondition: `at` lies inside the window.
    [[nodiscard]] virtual std::uint32_t read(RegOffset at) noexcept = 0;
    /// One aligned store, in program order.
    virtual void write(RegOffset at, std::uint32_t word) noexcept = 0;

    /// Readable when an interrupt has come; -1 where there is no line.
    [[nodiscard]] virtual int interrupt_fd() const noexcept = 0;
    /// Lets the next interrupt through.
    virtual void arm_interrupt() noexcept = 0;
    /// Takes what made interrupt_fd() readable; the number of interrupts so far.
    [[nodiscard]] virtual Result<std::uint32_t> take_interrupt() = 0;

    /// True once the window behind the registers has gone away; loads then give 0.
    [[nodiscard]] virtual bool lost() const noexcept = 0;
};

/// What a read of a BytePort ended in.
enum class ReadStatus : std::uint8_t {
    Data,   ///< `size` bytes were read
    Empty,  ///< nothing there now
    HungUp, ///< the other side closed; another one may come
    Gone,   ///< the port is of no use any more
};
struct ReadOutcome
{
    ReadStatus status = ReadStatus::Empty;
    std::size_t size = 0;
};

/// A stream of bytes in both directions that never waits.
class BytePort
{
  public:
    BytePort() = default;
    BytePort(const BytePort&) = delete;
    BytePort& operator=(const BytePort&) = delete;
    virtual ~BytePort() = default;

    /// For waiting; the port itself is read and written only through the calls below.
    [[nodiscard]] virtual int fd() const noexcept = 0;
    [[nodiscard]] virtual ReadOutcome read(std::span<char> into) noexcept = 0;
    /// How many bytes were taken now, possibly none.
    [[nodiscard]] virtual std::size_t write(std::string_view bytes) noexcept = 0;
};

/// A network interface: whole Ethernet frames, from the destination address to the last byte of
/// data.
class FramePort
{
  public:
    FramePort() = default;
    FramePort(const FramePort&) = delete;
    FramePort& operator=(const FramePort&) = delete;
    virtual ~FramePort() = default;

    /// Returns when the system has taken the frame. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> send(std::span<const std::uint8_t> frame) = 0;
    /// The next frame that another machine or program sent, cut to `into`: its size, or nothing
    /// when none comes within `timeout`. Errors: InputOutput.
    [[nodiscard]] virtual Result<std::optional<std::size_t>>
    receive(std::span<std::uint8_t> into, std::chrono::milliseconds timeout) = 0;
};

/// A change of a line's level, after active-low has been undone.
struct Edge
{
    bool level = false;
    std::chrono::nanoseconds at{}; ///< when, by a clock of the system that never waits for us
};

/// One digital line: a button, a switch or an LED.
class Pin
{
  public:
    Pin() = default;
    Pin(const Pin&) = delete;
    Pin& operator=(const Pin&) = delete;
    virtual ~Pin() = default;

    /// The present level, after active-low has been undone. Errors: InputOutput.
    [[nodiscard]] virtual Result<bool> read() = 0;
    /// Drives an output. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> write(bool on) = 0;
    /// Readable when an edge has come; -1 for outputs, and for inputs that do not report edges.
    [[nodiscard]] virtual int edge_fd() const noexcept = 0;
    /// The next edge that waits, in the order in which they came; nothing when none does. Errors:
    /// InputOutput.
    [[nodiscard]] virtual Result<std::optional<Edge>> take_edge() = 0;
};

} // namespace raymarch::drivers
