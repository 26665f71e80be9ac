// SPDX-License-Identifier: MIT
/// @file
/// A film as a GIF: each frame with a palette of its own.
#include "base/temporary_file.hpp"
#include "pictures/film_writers.hpp"
#include "pictures/load_module.hpp"
#include "pictures/module.hpp"
#include "pictures/palette.hpp"

namespace raymarch::pictures
{
namespace
{

class GifFilm final : public FilmWriter
{
  public:
    GifFilm(const std::string& path, engine::PictureSize size, unsigned frames_per_second,
            TemporaryFile file)
        : FilmWriter(path, size)
        , frames_per_second_(frames_per_second)
        , file_(std::move(file))
    {}

    Result<void> open(OpenGifFunction function, engine::PictureSize size)
    {
        encoder_.reset(function(size.width, size.height, sink, this));
        return outcome(encoder_ != nullptr);
    }

  private:
    Result<void> write(const engine::Image& image) override
    {
        const IndexedImage picture = indexed(image);
        return outcome(encoder_->add({.palette = picture.palette.front().data(),
                                      .colours = static_cast<int>(picture.palette.size()),
                                      .indices = picture.indices.data(),
                                      .delay = gif_delay(frames(), frames_per_second_)}));
    }

    Result<void> complete() override
    {
        if (auto result = outcome(encoder_->finish()); !result)
            return result;
        return file_.commit();
    }

    /// What the file said comes first: the encoder does not know of it.
    Result<void> outcome(bool encoded)
    {
        if (!written_)
            return written_;
        if (!encoded)
            return fail(plain_error(ErrorKind::InputOutput,
                                    path() + ": giflib could not encode the frame"));
        return {};
    }

    static void sink(void* context, const std::uint8_t* bytes, std::size_t count)
    {
        auto* const self = static_cast<GifFilm*>(context);
        if (self->written_)
            self->written_ = self->file_.write({bytes, count});
    }

    unsigned frames_per_second_;
    TemporaryFile file_; // open until the encoder, which ends the file when it goes, is gone
    Result<void> written_;
    std::unique_ptr<GifEncoder> encoder_;
};

} // namespace

Result<std::unique_ptr<FilmWriter>> open_gif(const std::string& path, engine::PictureSize size,
                                             unsigned frames_per_second)
{
    const auto function = module_function<OpenGifFunction>(module_file, gif_symbol);
    if (function == nullptr)
        return fail(plain_error(ErrorKind::Unavailable,
                                path + ": writing .gif needs the module " + module_file +
                                    ", which is not installed; a sequence of .ppm or .tga "
                                    "pictures does not"));
    auto file = TemporaryFile::open(path);
    if (!file)
        return fail(file.error());
    auto film = std::make_unique<GifFilm>(path, size, frames_per_second, *std::move(file));
    if (auto begun = film->open(function, size); !begun)
        return fail(begun.error());
    return film;
}

} // namespace raymarch::pictures
