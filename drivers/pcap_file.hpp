// SPDX-License-Identifier: MIT
/// @file
/// Captures of Ethernet frames in the classic pcap format (link type 1), to and from the bytes of
/// the file. The file itself is read and written as a whole (drivers/atomic_file.hpp).
#pragma once

#include "base/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raymarch::drivers
{

/// A capture being written: low byte first, microseconds, version 2.4.
class PcapWriter
{
  public:
    PcapWriter();
    /// `time` is since 1970; parts of a microsecond are dropped. Frames go up to
    /// `largest_pcap_frame` bytes (precondition).
    void add(std::span<const std::uint8_t> frame, std::chrono::nanoseconds time);
    /// The file so far.
    [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
};

/// What a record may claim; more means that the file is damaged.
inline constexpr std::size_t largest_pcap_frame = 262'144;

/// One frame of a capture.
struct PcapRecord
{
    std::span<const std::uint8_t> frame; ///< what was captured of it
    std::chrono::nanoseconds time{};     ///< since 1970
    bool cut = false;                    ///< there was more of it on the wire
};

/// A capture being read: either byte order, micro- or nanoseconds.
class PcapReader
{
  public:
    /// `bytes` is the file's content and outlives the reader; `name` is for messages.
    /// Errors: BadData (no pcap file, or not of Ethernet frames).
    [[nodiscard]] static Result<PcapReader> open(std::span<const std::uint8_t> bytes,
                                                 std::string name);
    /// The next record; nothing at the end. Errors: BadData, from there on nothing can be read.
    [[nodiscard]] Result<std::optional<PcapRecord>> next();

  private:
    PcapReader() = default;
    [[nodiscard]] std::uint32_t word(std::size_t offset) const noexcept;
    [[nodiscard]] bool take_magic() noexcept;

    std::span<const std::uint8_t> bytes_;
    std::string name_;
    std::size_t at_ = 0;
    bool high_byte_first_ = false;
    std::uint32_t nanoseconds_a_tick_ = 1000;
};

} // namespace raymarch::drivers
