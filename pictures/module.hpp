// SPDX-License-Identifier: MIT
/// @file
/// What the OpenCV module exports: one C function, so that the programs need not know OpenCV.
#pragma once

#include <cstddef>
#include <cstdint>

namespace raymarch::pictures
{

using ByteSink = void (*)(void* context, const std::uint8_t* bytes, std::size_t count);

/// Encodes `width` x `height` RGB pixels as the format of `extension` (".png", ".jpg") and hands
/// the bytes to `sink`. False when OpenCV cannot.
using EncodeFunction = bool (*)(const char* extension, const std::uint8_t* rgb, int width,
                                int height, ByteSink sink, void* context);

inline constexpr const char* module_file = "libraymarch_pictures.so";
inline constexpr const char* encode_symbol = "raymarch_encode_picture";

} // namespace raymarch::pictures
