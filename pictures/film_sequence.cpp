// SPDX-License-Identifier: MIT
/// @file
/// A film as a numbered picture for each frame, from 0.
#include "base/unfinished_file.hpp"
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

/// A hidden folder that goes with its owner.
class HiddenFolder
{
  public:
    [[nodiscard]] static Result<HiddenFolder> make_beside(const std::string& path)
    {
        auto name = raymarch::make_beside(
            path, [](const std::string& hidden) { return ::mkdir(hidden.c_str(), 0777) == 0; });
        if (!name)
            return fail(name.error());
        return HiddenFolder(*std::move(name));
    }
    HiddenFolder(HiddenFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    HiddenFolder& operator=(HiddenFolder&& other) = delete;
    ~HiddenFolder()
    {
        if (!path_.empty())
            ::rmdir(path_.c_str()); // the frames have left it, or gone
    }
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    explicit HiddenFolder(std::string path) : path_(std::move(path)) {}

    std::string path_; ///< empty when moved from
};

/// The frames wait in a hidden folder; at the end each is renamed.
class SequenceFilm final : public FilmWriter
{
  public:
    SequenceFilm(const std::string& path, engine::PictureSize size, PictureFormat format,
                 NumberedName name, HiddenFolder folder)
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
        auto file = UnfinishedFile::open(name_.at(frames()), folder_.path());
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
        for (UnfinishedFile& file : waiting_)
            if (auto result = file.finish(); !result)
                return result;
        return {};
    }

    PictureFormat format_;
    NumberedName name_;
    HiddenFolder folder_;
    std::vector<UnfinishedFile> waiting_; ///< after the folder: they go first
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
    auto folder = HiddenFolder::make_beside(path);
    if (!folder)
        return fail(folder.error());
    return std::make_unique<SequenceFilm>(path, size, *format, *std::move(name),
                                          *std::move(folder));
}

} // namespace raymarch::pictures
