// SPDX-License-Identifier: MIT
/// @file
/// Frames to a film file, one by one: GIF, MP4, or a picture for each frame.
///
/// The final name is there when the film is whole, not before; docs/pictures.md says what is in the
/// files.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace raymarch::pictures
{

enum class FilmFormat : std::uint8_t {
    Gif,      ///< at most 256 colours a frame, at most 50 frames a second
    Mp4,      ///< needs the video module
    Sequence, ///< a numbered picture for each frame
};

/// By the ending of the file's name, any case: gif, mp4, or that of a picture (`picture_file.hpp`).
/// Errors: Usage, naming what is allowed.
[[nodiscard]] Result<FilmFormat> film_format_of(std::string_view path);

/// A film that is being written. Without finish(), or after a failure, nothing of it is left.
class FilmWriter
{
  public:
    virtual ~FilmWriter() = default;
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// The next frame. Errors: BadData when it is not as large as the film; InputOutput. After an
    /// error all that follows fails with it.
    [[nodiscard]] Result<void> add(const engine::Image& frame);

    /// Puts the film in its place, over what has its name. Errors: BadData without a frame;
    /// InputOutput. Nothing can be added after it (asserted).
    [[nodiscard]] Result<void> finish();

    [[nodiscard]] std::size_t frames() const noexcept { return frames_; }

  protected:
    FilmWriter(std::string path, engine::PictureSize size) : path_(std::move(path)), size_(size) {}

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    virtual Result<void> write(const engine::Image& frame) = 0;
    virtual Result<void> complete() = 0;

    std::string path_; ///< the final name
    engine::PictureSize size_;
    std::size_t frames_ = 0;
    bool finished_ = false;
    std::optional<Error> failure_;
};

/// `path` is a file, or the pattern of a sequence (`numbered_name.hpp`).
/// Errors: Usage (ending, pattern, size 0, frames per second), Unavailable (a module that is not
/// installed), InputOutput.
[[nodiscard]] Result<std::unique_ptr<FilmWriter>>
open_film(const std::string& path, engine::PictureSize size, unsigned frames_per_second);

} // namespace raymarch::pictures
