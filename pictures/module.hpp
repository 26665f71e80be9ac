// SPDX-License-Identifier: MIT
/// @file
/// What the modules export: one C function for each kind of file, so that the programs need not
/// know the libraries behind them.
///
/// `libraymarch_pictures.so` has JPEG (OpenCV) and GIF (giflib); `libraymarch_video.so` has
/// MP4, by itself because OpenCV's videoio brings some sixty libraries with it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace raymarch::pictures
{

using ByteSink = void (*)(void* context, const std::uint8_t* bytes, std::size_t count);

/// Encodes `width` x `height` RGB pixels as the format of `extension` (".jpg") and hands
/// the bytes to `sink`. False when OpenCV cannot.
using EncodeFunction = bool (*)(const char* extension, const std::uint8_t* rgb, int width,
                                int height, ByteSink sink, void* context);

/// One frame of a GIF, as large as the film.
struct GifFrame
{
    const std::uint8_t* palette; ///< red, green, blue of each colour
    int colours;                 ///< 1 to 256
    const std::uint8_t* indices; ///< of the palette, rows from the top
    std::uint16_t delay;         ///< how long it is shown, in hundredths of a second
};

/// A GIF that plays over and over; its bytes go to the sink as they come about.
class GifEncoder
{
  public:
    GifEncoder() = default;
    GifEncoder(const GifEncoder&) = delete;
    GifEncoder& operator=(const GifEncoder&) = delete;
    virtual ~GifEncoder() = default;
    virtual bool add(const GifFrame& frame) = 0; ///< false when it cannot be encoded
    virtual bool finish() = 0; ///< the file's last bytes; nothing may be added after it
};

/// Null when there is no memory for it. The caller owns the encoder.
using OpenGifFunction = GifEncoder* (*)(int width, int height, ByteSink sink, void* context);

/// A video file that is written under its own name.
class VideoEncoder
{
  public:
    VideoEncoder() = default;
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;
    virtual ~VideoEncoder() = default;
    virtual bool add(const std::uint8_t* rgb) = 0; ///< a whole frame; false when it is not taken
    virtual bool finish() = 0; ///< closes the file; false when it does not hold all the frames
};

/// The file's ending decides the format. Null when it cannot be written, or no codec is there.
using OpenVideoFunction = VideoEncoder* (*)(const char* path, int width, int height,
                                            unsigned frames_per_second);

inline constexpr const char* module_file = "libraymarch_pictures.so";
inline constexpr const char* encode_symbol = "raymarch_encode_picture";
inline constexpr const char* gif_symbol = "raymarch_open_gif";
inline constexpr const char* video_module_file = "libraymarch_video.so";
inline constexpr const char* video_symbol = "raymarch_open_video";

} // namespace raymarch::pictures
