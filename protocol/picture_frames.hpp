// SPDX-License-Identifier: MIT
/// @file
/// A picture as Ethernet frames and back (docs/export.md; source 001, section VII).
///
/// Frames as a capture or a raw socket sees them: from the destination address to the last byte of
/// data. Preamble and frame check sequence are the business of the network hardware.
#pragma once

#include "protocol/parameters.hpp" // PictureSize

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raymarch::protocol
{

/// The only size that is exported.
inline constexpr PictureSize export_size{.width = 400, .height = 300};

/// Levels of grey, 0 (black) to 15, one a byte, rows from the top; always of `export_size`.
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

/// The source counts rows to the picture's width: rows 300 to 399 are sent and do not exist.
inline constexpr std::size_t rows_sent = export_size.width;
/// A start frame, then one a row.
inline constexpr std::size_t export_frames = 1 + rows_sent;

inline constexpr std::size_t fcs_bytes = 4;
/// Two addresses, one byte of type, data.
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

/// Whether the frame check sequence stands at the end: only hardware and a few captures have it.
enum class Fcs : std::uint8_t { Without, With };

/// Frame 0 is the start frame, frame 1 + r is row r; rows that do not exist are black.
/// Preconditions: `index` < export_frames, no level above 15.
[[nodiscard]] EthernetFrame frame_of(const GreyPicture& picture, std::size_t index,
                                     Fcs fcs = Fcs::Without) noexcept;

/// When the first bits of a frame leave the source's hardware, in clocks of 50 MHz after the
/// trigger.
[[nodiscard]] constexpr std::uint32_t first_clock(std::size_t index) noexcept
{
    return index == 0 ? 5 : static_cast<std::uint32_t>(370 + 981 * (index - 1));
}
inline constexpr std::uint32_t clocks_a_row = 981;
inline constexpr std::uint32_t nanoseconds_a_clock = 20;

/// What a frame turned out to be.
enum class FrameFate : std::uint8_t {
    Foreign, ///< between other addresses, shorter than two addresses, or of another protocol
    Start,   ///< a picture begins
    Row,     ///< taken, for the first time since the last start
    Doubled, ///< taken, though this row has come since the last start
    Beyond,  ///< one of the rows that do not exist
    Damaged, ///< between our addresses, but of no length, check sequence or content of ours
};
inline constexpr std::size_t frame_fates = 6;

/// Puts a picture together from the frames of a receiver, in any order. Tags of virtual networks
/// (IEEE 802.1Q) are passed over.
///
/// Rows that came before a start frame may be of another picture. They are kept as long as nothing
/// speaks against them, which makes the order of frames unimportant; the first row that came
/// before the start and comes again after it proves that they are, and they are forgotten.
class PictureAssembler
{
  public:
    FrameFate take(std::span<const std::uint8_t> frame);

    /// Each row has come since the last start frame: nothing can improve the picture.
    [[nodiscard]] bool settled() const noexcept;
    /// Each row is there, though some may be of an earlier picture.
    [[nodiscard]] bool complete() const noexcept;
    /// The rows that are there; the others are black.
    [[nodiscard]] const GreyPicture& picture() const noexcept { return picture_; }
    /// The rows that are not there, rising.
    [[nodiscard]] std::vector<std::size_t> missing_rows() const;
    /// How many frames had this fate.
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
    /// Of each row the number of start frames, plus one, after which it came.
    std::array<std::uint32_t, export_size.height> came_after_{};
    std::uint32_t now_ = 1;
    std::array<std::size_t, frame_fates> counts_{};
};

} // namespace raymarch::protocol
