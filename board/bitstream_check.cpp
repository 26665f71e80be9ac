// SPDX-License-Identifier: MIT
/// @file
/// Checks that a bitstream is for a device, and for all of it.
#include "board/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace raymarch::board
{
namespace
{

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns a part as Vivado's header has it: in small letters, without `xc`, and without the speed
/// grade and the range of temperatures (`-1`, `-2`, `-1LI`). Other text stays as it is.
std::string plain_part(std::string_view text)
{
    std::string part(text);
    std::ranges::transform(part, part.begin(), lower);
    if (part.starts_with("xc"))
        part.erase(0, 2);
    const std::size_t dash = part.find('-');
    if (dash == std::string::npos)
        return part;
    const std::string_view grade = std::string_view(part).substr(dash + 1);
    if (grade.empty() || grade.size() > 3 || grade[0] < '1' || grade[0] > '3' ||
        grade.find_first_not_of("ceilmq", 1) != std::string_view::npos)
        return std::string(text);
    part.resize(dash);
    return part;
}

Result<void> check_part(const std::string& part, const LogicDevice& device, const std::string& name)
{
    const std::string plain = plain_part(part);
    if (plain == device.part)
        return {};
    const std::string_view die = device.part.substr(0, device.part.find("clg"));
    return fail(bad_bitstream(
        name,
        fmt::format("it is for part {}, the board's is {}{}", part, device.part,
                    plain.starts_with(die) ? ": the package, and so the pins, are others" : "")));
}

} // namespace

Result<void> check_bitstream(const Bitstream& bitstream, const LogicDevice& device,
                             const std::string& name)
{
    constexpr std::size_t padding = 64; // tools may add this many bytes
    const std::size_t size = bitstream.data.size();
    if (bitstream.form == BitstreamForm::Bit)
        if (auto fits = check_part(bitstream.part, device, name); !fits)
            return fits;
    if (bitstream.idcode != device.idcode)
        return fail(
            bad_bitstream(name, fmt::format("it is for the device with IDCODE {:08X}, the board's "
                                            "is {:08X}",
                                            bitstream.idcode, device.idcode)));
    if (bitstream.design.find("PARTIAL=TRUE") != std::string::npos)
        return fail(bad_bitstream(name, "it configures only a part of the logic"));
    if (size > device.bitstream_bytes + padding ||
        (!bitstream.compressed && size < device.bitstream_bytes))
        return fail(
            bad_bitstream(name, fmt::format("{} bytes of data; a whole bitstream of {} has {}{}",
                                            size, device.part, device.bitstream_bytes,
                                            bitstream.compressed ? " at most" : "")));
    const std::size_t frames = bitstream.frame_words / words_a_frame + bitstream.repeated_frames;
    const std::size_t whole = device.frames + (bitstream.compressed ? 0 : device.padding_frames);
    if (frames < whole)
        return fail(
            bad_bitstream(name, fmt::format("it configures only a part of the logic: {} frames; a "
                                            "whole bitstream of {} has {}",
                                            frames, device.part, whole)));
    return {};
}

} // namespace raymarch::board
