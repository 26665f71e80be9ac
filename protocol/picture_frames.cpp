// SPDX-License-Identifier: MIT
#include "protocol/picture_frames.hpp"

#include "base/crc32.hpp"

#include <algorithm>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

using Bytes = std::span<const std::uint8_t>;

/// The destination and source addresses. They are fixed in the hardware of source 001.
constexpr std::array<std::uint8_t, 12> addresses = {0x88, 0x66, 0x5A, 0x03, 0x48, 0xB0,
                                                    0x11, 0x11, 0x11, 0x11, 0x11, 0x11};
/// The type has one byte and not two as in Ethernet. The first byte of data takes the second's
/// place.
constexpr std::uint8_t type_byte = 0x00;
constexpr std::size_t data_offset = addresses.size() + 1;
constexpr std::array<std::uint8_t, 50> start_data = [] {
    std::array<std::uint8_t, 50> data{};
    data.fill(0xFF);
    return data;
}();
constexpr std::size_t row_number_bytes = 4;

static_assert(start_frame_bytes == data_offset + start_data.size());
static_assert(start_frame_bytes + fcs_bytes <
              row_frame_bytes); // so the length tells the kind of frame

std::uint32_t check_sequence(Bytes bytes) noexcept
{
    return crc32(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::array<std::uint8_t, fcs_bytes> low_byte_first(std::uint32_t word) noexcept
{
    return {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 24)};
}

/// Appends to the storage of a frame, which has room for the longest frame.
class FrameWriter
{
  public:
    void byte(std::uint8_t value) noexcept { frame_.storage[frame_.size++] = value; }
    void bytes(Bytes values) noexcept
    {
        for (const std::uint8_t value : values)
            byte(value);
    }
    [[nodiscard]] const EthernetFrame& frame() const noexcept { return frame_; }

  private:
    EthernetFrame frame_;
};

void write_row(FrameWriter& writer, const GreyPicture& picture, std::size_t row) noexcept
{
    for (std::size_t i = row_number_bytes; i-- > 0;)
        writer.byte(static_cast<std::uint8_t>(row >> (8 * i)));
    for (std::size_t x = 0; x < export_size.width; x += 2) {
        const bool exists = row < export_size.height;
        const unsigned left = exists ? picture.row(row)[x] : 0U;
        const unsigned right = exists ? picture.row(row)[x + 1] : 0U;
        writer.byte(static_cast<std::uint8_t>(left << 4 | right));
    }
}

std::uint32_t type_of(Bytes frame, std::size_t at) noexcept
{
    return frame.size() < at + 2 ? 0U : static_cast<std::uint32_t>(frame[at] << 8 | frame[at + 1]);
}

/// Whether a tag follows the addresses. Switches insert a tag of IEEE 802.1Q or several of 802.1ad;
/// older switches write 9100. Our own frames never have such bytes at this place.
std::size_t tag_bytes(Bytes frame) noexcept
{
    std::size_t size = 0;
    for (;; size += 4) {
        const std::uint32_t type = type_of(frame, addresses.size() + size);
        if (type != 0x8100 && type != 0x88A8 && type != 0x9100)
            return size;
    }
}

/// Returns the bytes from the type to the last byte of data, without the check sequence if there is
/// a correct one. The check sequence covers the tags too. The result is empty if the length is
/// wrong.
Bytes content(Bytes frame, std::size_t tags) noexcept
{
    for (const std::size_t size : {start_frame_bytes + tags, row_frame_bytes + tags})
        if (frame.size() == size ||
            (frame.size() == size + fcs_bytes &&
             std::ranges::equal(frame.last(fcs_bytes),
                                low_byte_first(check_sequence(frame.first(size))))))
            return frame.first(size).subspan(addresses.size() + tags);
    return {};
}

} // namespace

EthernetFrame frame_of(const GreyPicture& picture, std::size_t index, Fcs fcs) noexcept
{
    FrameWriter writer;
    writer.bytes(addresses);
    writer.byte(type_byte);
    if (index == 0)
        writer.bytes(start_data);
    else
        write_row(writer, picture, index - 1);
    if (fcs == Fcs::With)
        writer.bytes(low_byte_first(check_sequence(writer.frame().bytes())));
    return writer.frame();
}

FrameFate PictureAssembler::take(Bytes frame)
{
    const FrameFate fate = judge(frame);
    ++counts_[static_cast<std::size_t>(fate)];
    return fate;
}

FrameFate PictureAssembler::judge(Bytes frame)
{
    if (frame.size() < addresses.size() ||
        !std::ranges::equal(frame.first(addresses.size()), addresses))
        return FrameFate::Foreign;
    constexpr std::uint32_t least_type = 0x0600; // smaller values are lengths in Ethernet
    const std::size_t tags = tag_bytes(frame);
    const Bytes typed = content(frame, tags);
    if (typed.empty() && type_of(frame, addresses.size() + tags) >= least_type)
        return FrameFate::Foreign;
    if (typed.empty() || typed.front() != type_byte)
        return FrameFate::Damaged;
    const Bytes data = typed.subspan(1);
    if (data.size() == start_data.size()) {
        if (!std::ranges::equal(data, start_data))
            return FrameFate::Damaged;
        ++now_;
        return FrameFate::Start;
    }
    std::uint32_t row = 0;
    for (const std::uint8_t byte : data.first(row_number_bytes))
        row = row << 8 | byte;
    if (row >= rows_sent)
        return FrameFate::Damaged;
    if (row >= export_size.height)
        return FrameFate::Beyond;
    return take_row(row, data.subspan(row_number_bytes));
}

FrameFate PictureAssembler::take_row(std::size_t row, Bytes pairs)
{
    const std::uint32_t before = came_after_[row];
    if (before != absent && before != now_)
        forget_earlier_pictures();
    came_after_[row] = now_;
    const std::span<std::uint8_t> levels = picture_.row(row);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        levels[2 * i] = pairs[i] >> 4;
        levels[2 * i + 1] = pairs[i] & 15;
    }
    return before == now_ ? FrameFate::Doubled : FrameFate::Row;
}

void PictureAssembler::forget_earlier_pictures()
{
    for (std::size_t row = 0; row < came_after_.size(); ++row) {
        if (came_after_[row] == now_)
            continue;
        came_after_[row] = absent;
        std::ranges::fill(picture_.row(row), std::uint8_t{0});
    }
}

bool PictureAssembler::settled() const noexcept
{
    return std::ranges::all_of(came_after_, [this](std::uint32_t after) { return after == now_; });
}

bool PictureAssembler::complete() const noexcept
{
    return std::ranges::none_of(came_after_, [](std::uint32_t after) { return after == absent; });
}

std::vector<std::size_t> PictureAssembler::missing_rows() const
{
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < came_after_.size(); ++row)
        if (came_after_[row] == absent)
            rows.push_back(row);
    return rows;
}

} // namespace raymarch::protocol
