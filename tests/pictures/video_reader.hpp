// SPDX-License-Identifier: MIT
/// @file
/// What the tests' video reader exports: a module, so that the other tests need no videoio.
#pragma once

#include <cstdint>

namespace raymarch::test
{

using FrameSink = void (*)(void* context, const std::uint8_t* rgb, int width, int height);

/// Hands each frame of the file to the sink; returns its frames per second, 0 when it is no video.
using ReadVideoFunction = double (*)(const char* path, FrameSink sink, void* context);

inline constexpr const char* video_reader_file = "libraymarch_video_reader.so";
inline constexpr const char* video_reader_symbol = "raymarch_read_video";

} // namespace raymarch::test
