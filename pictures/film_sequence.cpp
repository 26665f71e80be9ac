// SPDX-License-Identifier: MIT
/// @file
/// A film as a numbered picture for each frame, from 0.
#include "base/temporary_file.hpp"
#include "pictures/film_writers.hpp"
#include "pictures/numbered_name.hpp"
#include "pictures/picture_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <utility>
#include <vector>

namespace raymarch::pictures
{
namespace
{

/// The destructor removes the folder.
class TemporaryFolder
{
  public:
    [[nodiscard]] static Result<TemporaryFolder> make(const std::string& path)
    {
        auto name = raymarch::make_temporary(
            path, [](const std::string& made) { return ::mkdir(made.c_str(), 0777) == 0; });
        if (!name)
            return fail(name.error());
        return TemporaryFolder(*std::move(name));
    }
    TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    TemporaryFolder& operator=(TemporaryFolder&& other) = delete;
    ~TemporaryFolder()
    {
        if (!path_.empty())
            ::rmdir(path_.c_str()); // it is empty: the frames were renamed or removed
    }
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}

    std::string path_; ///< empty when moved from
};

/// The frames are written to a temporary folder; at the end each is renamed.
class SequenceFilm final : public FilmWriter
{
  public:
    SequenceFilm(const std::string& path, engine::PictureSize size, PictureFormat format,
                 NumberedName name, TemporaryFolder folder)
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
        auto file = TemporaryFile::open(name_.at(frames()), folder_.path());
        if (!file)
            return fail(file.error());
        if (auto result = file->write(*bytes); !result)
            return result;
        if (auto result = file->close(); !result)
            return result;
        waiting_.push_back(*std::move(file));
        return {};
    }

    Result<void> complete() override
    {
        for (TemporaryFile& file : waiting_)
            if (auto result = file.commit(); !result)
                return result;
        return {};
    }

    PictureFormat format_;
    NumberedName name_;
    TemporaryFolder folder_;
    std::vector<TemporaryFile> waiting_; ///< declared last: the files are removed before the folder
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
    auto folder = TemporaryFolder::make(path);
    if (!folder)
        return fail(folder.error());
    return std::make_unique<SequenceFilm>(path, size, *format, *std::move(name),
                                          *std::move(folder));
}

} // namespace raymarch::pictures
