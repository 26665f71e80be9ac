// SPDX-License-Identifier: MIT
#include "drivers/bitstream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace raymarch::drivers
{
namespace
{

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint32_t sync_word = 0xAA99'5566;
constexpr std::uint32_t sync_word_swapped = 0x6655'99AA;
constexpr std::uint32_t revision_mask = 0xF000'0000;

/// What opens a `.bit`: a field of 9 bytes, and the 16-bit number 1 before the lettered fields.
constexpr std::array<std::uint8_t, 13> bit_magic = {0x00, 0x09, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F,
                                                    0xF0, 0x0F, 0xF0, 0x00, 0x00, 0x01};

/// Registers of the configuration logic, and the commands of one of them.
constexpr std::uint32_t command_register = 4;
constexpr std::uint32_t multiple_frame_register = 10;
constexpr std::uint32_t idcode_register = 12;
constexpr std::uint32_t desync_command = 13;

Error bad(const std::string& name, std::string_view what)
{
    return plain_error(ErrorKind::BadData, fmt::format("{}: {}", name, what));
}

/// A big-endian number of `count` bytes; precondition: they are there.
std::uint32_t number(Bytes bytes, std::size_t at, std::size_t count)
{
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(at, count))
        value = value << 8 | byte;
    return value;
}

/// Configuration words, in either byte order.
class Words
{
  public:
    Words(Bytes data, BitstreamForm form) : data_(data), form_(form) {}
    [[nodiscard]] std::size_t size() const { return data_.size() / 4; }
    [[nodiscard]] std::uint32_t operator[](std::size_t index) const
    {
        const std::uint32_t word = number(data_, 4 * index, 4);
        return form_ == BitstreamForm::Bit ? word : __builtin_bswap32(word);
    }
    [[nodiscard]] std::optional<std::size_t> find(std::uint32_t wanted) const
    {
        for (std::size_t i = 0; i < size(); ++i)
            if ((*this)[i] == wanted)
                return i;
        return std::nullopt;
    }

  private:
    Bytes data_;
    BitstreamForm form_;
};

/// The header of a `.bit`, up to its data.
Result<void> read_header(Bytes bytes, const std::string& name, Bitstream& bitstream)
{
    struct Field
    {
        char letter;
        std::string Bitstream::*text;
    };
    constexpr std::array fields = {Field{'a', &Bitstream::design}, Field{'b', &Bitstream::part},
                                   Field{'c', &Bitstream::date}, Field{'d', &Bitstream::time}};
    const Error cut = bad(name, "the header of the .bit is cut or damaged");
    std::size_t at = bit_magic.size();
    for (const auto& [letter, text] : fields) {
        if (bytes.size() < at + 3 || bytes[at] != static_cast<std::uint8_t>(letter))
            return fail(cut);
        const std::size_t length = number(bytes, at + 1, 2);
        at += 3;
        if (bytes.size() < at + length)
            return fail(cut);
        const Bytes value = bytes.subspan(at, length);
        (bitstream.*text).assign(value.begin(), std::find(value.begin(), value.end(), 0));
        at += length;
    }
    if (bytes.size() < at + 5 || bytes[at] != 'e')
        return fail(cut);
    const std::size_t length = number(bytes, at + 1, 4);
    bitstream.data = bytes.subspan(at + 5);
    if (bitstream.data.size() != length)
        return fail(bad(name, fmt::format("the header says {} bytes of data, and there are {}",
                                          length, bitstream.data.size())));
    return {};
}

/// From the sync word to the command that ends the configuration: what is written to which
/// register.
Result<void> read_packets(const Words& words, const std::string& name, Bitstream& bitstream)
{
    const auto sync = words.find(sync_word);
    if (!sync)
        return fail(bad(name, words.find(sync_word_swapped)
                                  ? "the bytes of its words are not swapped, as a .bin for the "
                                    "Zynq's are: give the .bit"
                                  : "there is no sync word: no bitstream"));
    std::optional<std::uint32_t> idcode;
    for (std::size_t at = *sync + 1; at < words.size();) {
        const std::uint32_t header = words[at++];
        const std::uint32_t type = header >> 29;
        const bool is_write = (header >> 27 & 3) == 2;
        if (type == 2) { // goes on with the register of the packet before it
            const std::size_t count = header & 0x07FF'FFFF;
            if (is_write && count > words.size() - at)
                break;
            at += is_write ? count : 0;
            continue;
        }
        if (type != 1) {
            if (header == 0 || header == 0xFFFF'FFFF) // padding
                continue;
            return fail(bad(name, fmt::format("damaged: {:08X} at byte {} of the data is no packet",
                                              header, 4 * (at - 1))));
        }
        const std::size_t count = is_write ? header & 0x7FF : 0;
        if (count > words.size() - at)
            break;
        const std::uint32_t target = header >> 13 & 0x3FFF;
        if (count > 0 && target == idcode_register)
            idcode = words[at] & ~revision_mask;
        if (count > 0 && target == multiple_frame_register)
            bitstream.compressed = true;
        if (count > 0 && target == command_register && words[at] == desync_command) {
            if (!idcode)
                return fail(bad(name, "it names no device (IDCODE); encrypted bitstreams are not "
                                      "taken"));
            bitstream.idcode = *idcode;
            return {};
        }
        at += count;
    }
    return fail(bad(name, "it is cut: the command that ends the configuration is missing"));
}

} // namespace

Result<Bitstream> parse_bitstream(Bytes bytes, const std::string& name)
{
    Bitstream bitstream;
    if (bytes.size() >= bit_magic.size() &&
        std::equal(bit_magic.begin(), bit_magic.end(), bytes.begin())) {
        bitstream.form = BitstreamForm::Bit;
        if (auto header = read_header(bytes, name, bitstream); !header)
            return fail(header.error());
    } else {
        bitstream.data = bytes;
    }
    if (bitstream.data.size() % 4 != 0)
        return fail(bad(
            name, fmt::format("{} bytes of data are no whole words of 4", bitstream.data.size())));
    if (auto packets = read_packets({bitstream.data, bitstream.form}, name, bitstream); !packets)
        return fail(packets.error());
    return bitstream;
}

Result<void> check_bitstream(const Bitstream& bitstream, const LogicDevice& device,
                             const std::string& name)
{
    constexpr std::size_t padding = 64; // what tools may add at the end
    const std::size_t size = bitstream.data.size();
    if (bitstream.form == BitstreamForm::Bit && bitstream.part != device.part)
        return fail(bad(name, fmt::format("it is for part {}, the board's is {}", bitstream.part,
                                          device.part)));
    if (bitstream.idcode != device.idcode)
        return fail(bad(name, fmt::format("it is for the device with IDCODE {:08X}, the board's "
                                          "is {:08X}",
                                          bitstream.idcode, device.idcode)));
    if (bitstream.design.find("PARTIAL=TRUE") != std::string::npos)
        return fail(bad(name, "it configures only a part of the logic"));
    if (size > device.bitstream_bytes + padding ||
        (!bitstream.compressed && size < device.bitstream_bytes))
        return fail(bad(name, fmt::format("{} bytes of data; a whole bitstream of {} has {}{}",
                                          size, device.part, device.bitstream_bytes,
                                          bitstream.compressed ? " at most" : "")));
    return {};
}

std::vector<std::uint8_t> bin_of(const Bitstream& bitstream)
{
    std::vector<std::uint8_t> bytes(bitstream.data.begin(), bitstream.data.end());
    if (bitstream.form == BitstreamForm::Bit)
        for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4)
            std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                         bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
    return bytes;
}

} // namespace raymarch::drivers
