// SPDX-License-Identifier: MIT
/// @file
/// A film as an MP4, by the video module.
#include "base/temporary_file.hpp"
#include "pictures/film_writers.hpp"
#include "pictures/load_module.hpp"
#include "pictures/module.hpp"

#include <filesystem>
#include <system_error>

namespace raymarch::pictures
{
namespace
{

class Mp4Film final : public FilmWriter
{
  public:
    Mp4Film(const std::string& path, engine::PictureSize size, TemporaryFile temporary,
            std::unique_ptr<VideoEncoder> encoder)
        : FilmWriter(path, size)
        , temporary_(std::move(temporary))
        , encoder_(std::move(encoder))
    {}

  private:
    Result<void> write(const engine::Image& image) override
    {
        if (!encoder_->add(image.rgb.data()))
            return fail(plain_error(ErrorKind::InputOutput,
                                    path() + ": OpenCV could not encode the frame"));
        return {};
    }

    Result<void> complete() override
    {
        if (!encoder_->finish())
            return fail(plain_error(ErrorKind::InputOutput,
                                    path() + ": OpenCV could not write all frames; is there room "
                                             "on the disk?"));
        return temporary_.commit();
    }

    TemporaryFile temporary_; // declared first: it is removed after the encoder has closed it
    std::unique_ptr<VideoEncoder> encoder_;
};

} // namespace

Result<std::unique_ptr<FilmWriter>> open_mp4(const std::string& path, engine::PictureSize size,
                                             unsigned frames_per_second)
{
    const auto function = module_function<OpenVideoFunction>(video_module_file, video_symbol);
    if (function == nullptr)
        return fail(plain_error(ErrorKind::Unavailable,
                                path + ": writing .mp4 needs the module " + video_module_file +
                                    ", which is not here: install libopencv-videoio-dev and build "
                                    "again, with ./dev build; the package raymarchd-pictures has "
                                    "the module where it was built so; .gif and a sequence of .png "
                                    "pictures do without"));
    auto temporary = TemporaryFile::open(path);
    if (!temporary)
        return fail(temporary.error());
    // FFmpeg takes what stands before a colon for a protocol, but not in a name that begins with /.
    std::error_code ignored;
    const std::string full = std::filesystem::absolute(temporary->path(), ignored).string();
    std::unique_ptr<VideoEncoder> encoder(
        function(full.c_str(), size.width, size.height, frames_per_second));
    if (encoder == nullptr)
        return fail(plain_error(ErrorKind::InputOutput,
                                path + ": OpenCV has no encoder for an MP4 of this size"));
    return std::make_unique<Mp4Film>(path, size, *std::move(temporary), std::move(encoder));
}

} // namespace raymarch::pictures
