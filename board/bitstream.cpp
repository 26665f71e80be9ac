// SPDX-License-Identifier: MIT
#include "board/bitstream.hpp"

#include "board/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raymarch::board
{
namespace
{

using Bytes = std::span<const std::uint8_t>;

/// A `.bit` begins with a field of 9 bytes, and the 16-bit number 1 before the lettered fields.
constexpr std::array<std::uint8_t, 13> bit_magic = {0x00, 0x09, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F,
                                                    0xF0, 0x0F, 0xF0, 0x00, 0x00, 0x01};

/// Reads the header of a `.bit`, up to its data.
Result<void> read_header(Bytes bytes, const std::string& name, Bitstream& bitstream)
{
    struct Field
    {
        char letter;
        std::string Bitstream::*text;
    };
    constexpr std::array fields = {Field{'a', &Bitstream::design}, Field{'b', &Bitstream::part},
                                   Field{'c', &Bitstream::date}, Field{'d', &Bitstream::time}};
    const Error cut = bad_bitstream(name, "the header of the .bit is cut or damaged");
    std::size_t at = bit_magic.size();
    for (const auto& [letter, text] : fields) {
        if (bytes.size() < at + 3 || bytes[at] != static_cast<std::uint8_t>(letter))
            return fail(cut);
        const std::size_t length = big_endian(bytes, at + 1, 2);
        at += 3;
        if (bytes.size() < at + length)
            return fail(cut);
        const Bytes value = bytes.subspan(at, length);
        (bitstream.*text).assign(value.begin(), std::find(value.begin(), value.end(), 0));
        at += length;
    }
    if (bytes.size() < at + 5 || bytes[at] != 'e')
        return fail(cut);
    const std::size_t length = big_endian(bytes, at + 1, 4);
    bitstream.data = bytes.subspan(at + 5);
    if (bitstream.data.size() != length)
        return fail(
            bad_bitstream(name, fmt::format("the header says {} bytes of data, and there are {}",
                                            length, bitstream.data.size())));
    return {};
}

} // namespace

Error bad_bitstream(const std::string& name, std::string_view what)
{
    return plain_error(ErrorKind::BadData, fmt::format("{}: {}", name, what));
}

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
        return fail(bad_bitstream(
            name, fmt::format("{} bytes of data are no whole words of 4", bitstream.data.size())));
    if (auto read = read_configuration({bitstream.data, bitstream.form}, name, bitstream); !read)
        return fail(read.error());
    return bitstream;
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

} // namespace raymarch::board
