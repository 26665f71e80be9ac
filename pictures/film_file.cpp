// SPDX-License-Identifier: MIT
#include "pictures/film_file.hpp"

#include "base/file_target.hpp"
#include "pictures/film_writers.hpp"
#include "pictures/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>

namespace raymarch::pictures
{
namespace
{

/// In the order of FilmFormat.
struct Row
{
    std::string_view ending; ///< empty: any that a picture has
    std::string_view name;
    unsigned most_per_second;
    OpenFilm open;
};
constexpr std::array rows = {
    // Viewers show a frame of 1/100 s for 1/10 s; 2/100 s is the least that they all take.
    Row{".gif", "a GIF", 50, open_gif},
    Row{".mp4", "an MP4", 240, open_mp4},
    Row{"", "a sequence of pictures", 240, open_sequence},
};

std::string describe(engine::PictureSize size)
{
    return std::to_string(size.width) + 'x' + std::to_string(size.height);
}

bool ends_with(std::string_view path, std::string_view ending)
{
    return path.size() >= ending.size() &&
           std::equal(
               ending.begin(), ending.end(), path.end() - std::ssize(ending),
               [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// Found out now rather than after the last frame.
Result<void> check_place(const std::string& path)
{
    struct stat info = {}; // what cannot be looked at cannot be made either, and that says why
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::Usage, not_a_file(path, info.st_mode).message));
    return {};
}

} // namespace

Result<FilmFormat> film_format_of(std::string_view path)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].ending.empty() && ends_with(path, rows[i].ending))
            return static_cast<FilmFormat>(i);
    if (path != "-" && format_of(path))
        return FilmFormat::Sequence;
    return fail(plain_error(ErrorKind::Usage,
                            std::string(path) +
                                ": a film's name ends in .gif or .mp4; .png, .jpg, .jpeg, .ppm and "
                                ".tga are a sequence of pictures, as in name_%04d.png"));
}

Result<void> FilmWriter::add(const engine::Image& frame)
{
    assert(!finished_);
    if (failure_)
        return fail(*failure_);
    Result<void> result;
    if (frame.size != size_)
        result = fail(plain_error(ErrorKind::BadData, path_ + ": frame " + std::to_string(frames_) +
                                                          " is " + describe(frame.size) +
                                                          ", the film is " + describe(size_)));
    else
        result = write(frame);
    if (result)
        ++frames_;
    else
        failure_ = result.error();
    return result;
}

Result<void> FilmWriter::finish()
{
    assert(!finished_);
    finished_ = true;
    if (failure_)
        return fail(*failure_);
    if (frames_ == 0)
        return fail(plain_error(ErrorKind::BadData, path_ + ": a film has at least one frame"));
    return complete();
}

Result<std::unique_ptr<FilmWriter>> open_film(const std::string& path, engine::PictureSize size,
                                              unsigned frames_per_second)
{
    const auto format = film_format_of(path);
    if (!format)
        return fail(format.error());
    const Row& row = rows[static_cast<std::size_t>(*format)];
    if (size.width == 0 || size.height == 0)
        return fail(plain_error(ErrorKind::Usage, path + ": a film of " + describe(size) +
                                                      " has no pixels; 1x1 is the least"));
    if (frames_per_second < 1 || frames_per_second > row.most_per_second)
        return fail(plain_error(ErrorKind::Usage, path + ": " + std::to_string(frames_per_second) +
                                                      " frames a second; " + std::string(row.name) +
                                                      " has 1 to " +
                                                      std::to_string(row.most_per_second)));
    if (*format != FilmFormat::Sequence)
        if (const auto place = check_place(path); !place)
            return fail(place.error());
    return row.open(path, size, frames_per_second);
}

} // namespace raymarch::pictures
