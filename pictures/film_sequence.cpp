// SPDX-License-Identifier: MIT
/// @file
/// A film as a numbered picture for each frame, from 0.
#include "pictures/film_writers.hpp"
#include "pictures/numbered_name.hpp"
#include "pictures/picture_file.hpp"
#include "pictures/unfinished_file.hpp"

namespace raymarch::pictures
{
namespace
{

/// The frames wait in a hidden folder under their numbers; at the end each is renamed.
class SequenceFilm final : public FilmWriter
{
  public:
    SequenceFilm(const std::string& path, engine::PictureSize size, PictureFormat format,
                 NumberedName name, Unfinished folder)
        : FilmWriter(path, size)
        , format_(format)
        , name_(std::move(name))
        , folder_(std::move(folder))
    {}

  private:
    Result<void> write(const engine::Image& image) override
    {
        const auto bytes = encode(image, format_);
        if (!bytes)
            return fail(bytes.error());
        auto file = OutputFile::open(waiting(frames()), name_.at(frames()));
        if (!file)
            return fail(file.error());
        if (auto result = file->write(*bytes); !result)
            return result;
        return file->close();
    }

    Result<void> complete() override
    {
        for (std::size_t i = 0; i < frames(); ++i)
            if (auto result = publish(waiting(i), name_.at(i)); !result)
                return result;
        return {};
    }

    [[nodiscard]] std::string waiting(std::size_t number) const
    {
        return folder_.path() + '/' + std::to_string(number);
    }

    PictureFormat format_;
    NumberedName name_;
    Unfinished folder_;
};

} // namespace

Result<std::unique_ptr<FilmWriter>> open_sequence(const std::string& path, engine::PictureSize size,
                                                  unsigned /*frames_per_second*/)
{
    const auto format = format_of(path);
    if (!format)
        return fail(format.error());
    auto name = numbered_name(path);
    if (!name)
        return fail(name.error());
    // A module that is missing is missed now, not after the first frame has been computed.
    if (const auto probe = encode(engine::Image({1, 1}), *format); !probe)
        return fail(probe.error());
    auto folder = Unfinished::folder(path);
    if (!folder)
        return fail(folder.error());
    return std::make_unique<SequenceFilm>(path, size, *format, *std::move(name),
                                          *std::move(folder));
}

} // namespace raymarch::pictures
