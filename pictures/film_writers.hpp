// SPDX-License-Identifier: MIT
/// @file
/// The writers behind open_film(), which has looked at what they are given.
#pragma once

#include "pictures/film_file.hpp"

namespace raymarch::pictures
{

using OpenFilm = Result<std::unique_ptr<FilmWriter>> (*)(const std::string& path,
                                                         engine::PictureSize size,
                                                         unsigned frames_per_second);

Result<std::unique_ptr<FilmWriter>> open_gif(const std::string& path, engine::PictureSize size,
                                             unsigned frames_per_second);
Result<std::unique_ptr<FilmWriter>> open_mp4(const std::string& path, engine::PictureSize size,
                                             unsigned frames_per_second);
Result<std::unique_ptr<FilmWriter>> open_sequence(const std::string& path, engine::PictureSize size,
                                                  unsigned frames_per_second);

/// How long frame `number` (from 0) of a GIF is shown, in hundredths of a second. Frames begin at
/// the whole hundredth before their time, so that no error grows.
[[nodiscard]] constexpr std::uint16_t gif_delay(std::uint64_t number, unsigned frames_per_second)
{
    const std::uint64_t begin = number * 100 / frames_per_second;
    const std::uint64_t end = (number + 1) * 100 / frames_per_second;
    return static_cast<std::uint16_t>(end - begin);
}

} // namespace raymarch::pictures
