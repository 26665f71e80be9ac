// SPDX-License-Identifier: MIT
/// @file
/// Bitstreams of 7-series logic, from the bytes of the file: what they say of themselves, whether
/// they are whole, and the form that the kernel loads. A wrong one is found before it is loaded.
///
/// Vivado writes `.bit`: a header of big-endian fields, then configuration words, high byte first.
/// The Zynq's configuration port, and so the kernel, takes `.bin`: the same words without the
/// header, low byte first. (UG470: packets and registers; drivers/fpga/zynq-fpga.c of Linux: the
/// sync word that it looks for.) The open tools (Project X-Ray) write the same words, without the
/// check sequences.
#pragma once

#include "base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::board
{

enum class BitstreamForm : std::uint8_t { Bit, Bin };

/// A whole bitstream. Borrows the bytes that it was read from.
struct Bitstream
{
    BitstreamForm form = BitstreamForm::Bin;
    std::string design; ///< name and options; this and the next three stand in a `.bit` only
    std::string part;
    std::string date;
    std::string time;
    std::uint32_t idcode = 0;           ///< of the device that takes it; the upper 4 bits, its
                                        ///< revision, are 0
    bool compressed = false;            ///< frames that repeat are written once
    bool checked = false;               ///< a correct check sequence covers every frame; without
                                        ///< one, damage cannot be found
    std::size_t frame_words = 0;        ///< of frame data
    std::size_t repeated_frames = 0;    ///< each written by one packet of MFWR; compressed only
    std::span<const std::uint8_t> data; ///< configuration words in the byte order of the form
};

/// A device that bitstreams are made for.
struct LogicDevice
{
    std::string_view part;       ///< with its package, as Vivado writes it
    std::uint32_t idcode;        ///< without the revision
    std::size_t bitstream_bytes; ///< of a whole one that is not compressed
    std::size_t frames;          ///< of its configuration memory
    std::size_t padding_frames;  ///< in a whole bitstream: two after each row of each kind
};

/// PYNQ-Z1: XC7Z020-1CLG400C. (UG470 and UG585: IDCODE and length of the bitstream. Project X-Ray's
/// part.json: three rows, each with 2564 frames of logic and 768 of block RAM.)
inline constexpr LogicDevice zynq_7020{"7z020clg400", 0x0372'7093, 4'045'564, 9'996, 12};

/// Words of a frame in the whole 7 series.
inline constexpr std::size_t words_a_frame = 101;

/// More than any bitstream of the family: a limit for reading the file.
inline constexpr std::size_t largest_bitstream_file = 32 << 20;

/// Reads a `.bit` or a byte-swapped `.bin`; `name` is for messages. Errors: BadData, with what is
/// wrong and where: no bitstream, damaged (by its check sequences, where it has them), cut, for two
/// devices, or not byte-swapped.
[[nodiscard]] Result<Bitstream> parse_bitstream(std::span<const std::uint8_t> bytes,
                                                const std::string& name);

/// Checks that the bitstream configures all of `device`. The part in the header of a `.bit` may
/// also be written as the tools take it, with `xc` before and the speed grade behind it, in either
/// case of letters: `xc7z020clg400-1`. Errors: BadData.
[[nodiscard]] Result<void> check_bitstream(const Bitstream& bitstream, const LogicDevice& device,
                                           const std::string& name);

/// The bytes of a `.bin`, as the kernel takes them.
[[nodiscard]] std::vector<std::uint8_t> bin_of(const Bitstream& bitstream);

} // namespace raymarch::board
