// SPDX-License-Identifier: MIT
#include "drivers/pcap_file.hpp"

#include <utility>

namespace raymarch::drivers
{
namespace
{

constexpr std::uint32_t micro_magic = 0xA1B2C3D4;
constexpr std::uint32_t nano_magic = 0xA1B23C4D;
/// The first word of pcapng is the same in both byte orders.
constexpr std::uint32_t pcapng_magic = 0x0A0D0D0A;
/// Version 2.4 is two numbers of 16 bits, the major number first, here as one little-endian word.
constexpr std::uint32_t version = 4U << 16 | 2U;
constexpr std::uint32_t ethernet = 1;
constexpr std::size_t file_header_bytes = 24;
constexpr std::size_t record_header_bytes = 16;
constexpr std::uint32_t nanoseconds_a_second = 1'000'000'000;

std::uint32_t low_byte_first(std::span<const std::uint8_t> bytes) noexcept
{
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | bytes[i];
    return word;
}

std::uint32_t high_byte_first(std::span<const std::uint8_t> bytes) noexcept
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word = word << 8 | bytes[i];
    return word;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t word)
{
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

} // namespace

PcapWriter::PcapWriter()
{
    append(bytes_, micro_magic);
    append(bytes_, version);
    append(bytes_, 0); // time zone
    append(bytes_, 0); // accuracy of the times
    append(bytes_, largest_pcap_frame);
    append(bytes_, ethernet);
}

void PcapWriter::add(std::span<const std::uint8_t> frame, std::chrono::nanoseconds time)
{
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
    const auto rest = std::chrono::floor<std::chrono::microseconds>(time - seconds);
    append(bytes_, static_cast<std::uint32_t>(seconds.count()));
    append(bytes_, static_cast<std::uint32_t>(rest.count()));
    append(bytes_, static_cast<std::uint32_t>(frame.size())); // captured
    append(bytes_, static_cast<std::uint32_t>(frame.size())); // on the wire
    bytes_.insert(bytes_.end(), frame.begin(), frame.end());
}

/// Reads the byte order and the unit of time from the first word. Returns false if it is not pcap.
bool PcapReader::take_magic() noexcept
{
    for (const bool high : {false, true}) {
        high_byte_first_ = high;
        if (word(0) == nano_magic)
            nanoseconds_a_tick_ = 1;
        if (word(0) == micro_magic || word(0) == nano_magic)
            return true;
    }
    return false;
}

Result<PcapReader> PcapReader::open(std::span<const std::uint8_t> bytes, std::string name)
{
    const auto refuse = [&name](const std::string& why) {
        return fail(plain_error(ErrorKind::BadData, name + " " + why));
    };
    PcapReader reader;
    reader.bytes_ = bytes;
    if (bytes.size() >= sizeof pcapng_magic && reader.word(0) == pcapng_magic)
        return refuse("is a pcapng file; editcap -F pcap makes a pcap file of it");
    if (bytes.size() < file_header_bytes || !reader.take_magic())
        return refuse("is not a pcap file");
    const std::uint32_t versions = reader.word(4);
    const std::uint32_t swapped = versions << 16 | versions >> 16;
    if ((reader.high_byte_first_ ? swapped : versions) != version)
        return refuse("is a pcap file, but its version is not 2.4");
    // The upper half may tell the length of check sequences; the length is not needed.
    if (const std::uint32_t type = reader.word(20) & 0xFFFF; type != ethernet)
        return refuse("has frames of link type " + std::to_string(type) +
                      "; Ethernet, which is 1, is needed");
    reader.name_ = std::move(name);
    reader.at_ = file_header_bytes;
    return reader;
}

std::uint32_t PcapReader::word(std::size_t offset) const noexcept
{
    const auto bytes = bytes_.subspan(offset, 4);
    return high_byte_first_ ? high_byte_first(bytes) : low_byte_first(bytes);
}

Result<std::optional<PcapRecord>> PcapReader::next()
{
    const std::size_t start = at_;
    const std::size_t left = bytes_.size() - start;
    if (left == 0)
        return std::nullopt;
    const auto refuse = [this, start](const std::string& why) {
        at_ = bytes_.size();
        return fail(plain_error(ErrorKind::BadData, name_ + ": the record at byte " +
                                                        std::to_string(start) + " " + why));
    };
    if (left < record_header_bytes)
        return refuse("is cut off");
    const std::uint64_t seconds = word(start);
    const std::uint64_t ticks = word(start + 4);
    const std::size_t captured = word(start + 8);
    if (captured > largest_pcap_frame)
        return refuse("claims " + std::to_string(captured) + " bytes");
    if (captured > left - record_header_bytes)
        return refuse("is cut off");
    at_ = start + record_header_bytes + captured;
    const std::uint64_t time = seconds * nanoseconds_a_second + ticks * nanoseconds_a_tick_;
    return PcapRecord{.frame = bytes_.subspan(start + record_header_bytes, captured),
                      .time = std::chrono::nanoseconds(static_cast<std::int64_t>(time)),
                      .cut = word(start + 12) > captured};
}

} // namespace raymarch::drivers
