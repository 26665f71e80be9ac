// SPDX-License-Identifier: MIT
/// @file
/// Encodes and decodes captures of Ethernet frames in the classic pcap format (link type 1).
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

/// Writes a capture of version 2.4: little-endian, with times in microseconds.
class PcapWriter
{
  public:
    PcapWriter();
    /// `time` counts from 1970; parts of a microsecond are dropped. Precondition: the frame has at
    /// most `largest_pcap_frame` bytes.
    void add(std::span<const std::uint8_t> frame, std::chrono::nanoseconds time);
    /// Returns the file so far.
    [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
};

/// A longer record means that the file is damaged.
inline constexpr std::size_t largest_pcap_frame = 262'144;

struct PcapRecord
{
    std::span<const std::uint8_t> frame; ///< the captured bytes
    std::chrono::nanoseconds time{};     ///< since 1970
    bool cut = false;                    ///< the frame was longer on the wire
};

/// Reads a capture in either byte order, with times in micro- or nanoseconds.
class PcapReader
{
  public:
    /// `bytes` is the file's content and outlives the reader; `name` is for messages.
    /// Errors: BadData (it is not a pcap file, or has no Ethernet frames).
    [[nodiscard]] static Result<PcapReader> open(std::span<const std::uint8_t> bytes,
                                                 std::string name);
    /// Returns the next record, or nothing at the end. Errors: BadData; nothing more can be read
    /// then.
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
