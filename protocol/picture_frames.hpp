// SPDX-License-Identifier: MIT
/// @file
/// Converts a picture to Ethernet frames and back (docs/export.md; source 001, section VII).
///
/// Frames are as in a capture or a raw socket: from the destination address to the last byte of
/// data. The network hardware adds the preamble and the frame check sequence.
#pragma once

#include "protocol/parameters.hpp" // PictureSize

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raymarch::protocol
{

/// The only picture size that can be exported.
inline constexpr PictureSize export_size{.width = 400, .height = 300};

/// A picture of `export_size`. Each byte is a level of grey from 0 (black) to 15; the top row is
/// first.
struct GreyPicture
{
    std::vector<std::uint8_t> levels =
        std::vector<std::uint8_t>(std::size_t{export_size.width} * export_size.height);

    [[nodiscard]] std::span<std::uint8_t> row(std::size_t y) noexcept
    {
        return std::span(levels).subspan(y * export_size.width, export_size.width);
    }
    [[nodiscard]] std::span<const std::uint8_t> row(std::size_t y) const noexcept
    {
        return std::span(levels).subspan(y * export_size.width, export_size.width);
    }
    bool operator==(const GreyPicture&) const = default;
};

/// The source sends as many rows as the picture has columns. Rows 300 to 399 do not exist.
inline constexpr std::size_t rows_sent = export_size.width;
/// The number of frames: a start frame, and one for each row.
inline constexpr std::size_t export_frames = 1 + rows_sent;

inline constexpr std::size_t fcs_bytes = 4;
/// The length of a frame: two addresses, one byte of type, and the data.
inline constexpr std::size_t start_frame_bytes = 12 + 1 + 50;
inline constexpr std::size_t row_frame_bytes = 12 + 1 + 4 + export_size.width / 2;

struct EthernetFrame
{
    std::array<std::uint8_t, row_frame_bytes + fcs_bytes> storage{};
    std::size_t size = 0;
    [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept
    {
        return std::span(storage).first(size);
    }
};

/// Whether the frame check sequence is at the end. Only hardware and a few captures have it.
enum class Fcs : std::uint8_t { Without, With };

/// Makes one frame. Frame 0 is the start frame, frame 1 + r is row r. Rows that do not exist are
/// black.
/// Preconditions: `index` < export_frames, no level above 15.
[[nodiscard]] EthernetFrame frame_of(const GreyPicture& picture, std::size_t index,
                                     Fcs fcs = Fcs::Without) noexcept;

/// The time at which the source's hardware sends the first bits of a frame, in clocks of 50 MHz
/// after the trigger.
[[nodiscard]] constexpr std::uint32_t first_clock(std::size_t index) noexcept
{
    return index == 0 ? 5 : static_cast<std::uint32_t>(370 + 981 * (index - 1));
}
inline constexpr std::uint32_t clocks_a_row = 981;
inline constexpr std::uint32_t nanoseconds_a_clock = 20;

/// The kind of a received frame.
enum class FrameFate : std::uint8_t {
    Foreign, ///< between other addresses, shorter than two addresses, or of another protocol
    Start,   ///< a picture begins
    Row,     ///< the row was taken, and is the first of its number since the last start
    Doubled, ///< the row was taken, although it had come since the last start
    Beyond,  ///< the row does not exist
    Damaged, ///< between our addresses, but of no length, check sequence or content of ours
};
inline constexpr std::size_t frame_fates = 6;

/// Builds a picture from received frames, in any order. Tags of virtual networks (IEEE 802.1Q) are
/// skipped.
///
/// Rows that came before a start frame may belong to an earlier picture. They are kept at first, so
/// that the order of frames does not matter. If one of them comes again after the start, they do
/// belong to an earlier picture, and all of them are dropped.
class PictureAssembler
{
  public:
    FrameFate take(std::span<const std::uint8_t> frame);

    /// Whether each row has come since the last start frame. The picture is then final.
    [[nodiscard]] bool settled() const noexcept;
    /// Whether each row is there. Some may belong to an earlier picture.
    [[nodiscard]] bool complete() const noexcept;
    /// The picture so far. Rows that are missing are black.
    [[nodiscard]] const GreyPicture& picture() const noexcept { return picture_; }
    /// The numbers of the missing rows, in ascending order.
    [[nodiscard]] std::vector<std::size_t> missing_rows() const;
    /// How many frames were of this kind.
    [[nodiscard]] std::size_t count(FrameFate fate) const noexcept
    {
        return counts_[static_cast<std::size_t>(fate)];
    }

  private:
    FrameFate judge(std::span<const std::uint8_t> frame);
    FrameFate take_row(std::size_t row, std::span<const std::uint8_t> pairs);
    void forget_earlier_pictures();

    static constexpr std::uint32_t absent = 0;
    GreyPicture picture_;
    /// For each row, one plus the number of start frames before it; 0 if the row has not come.
    std::array<std::uint32_t, export_size.height> came_after_{};
    std::uint32_t now_ = 1;
    std::array<std::size_t, frame_fates> counts_{};
};

} // namespace raymarch::protocol
