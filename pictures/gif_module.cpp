// SPDX-License-Identifier: MIT
/// @file
/// GIF for the picture module: giflib does the format and its compression.
#include "pictures/module.hpp"

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace raymarch::pictures
{
namespace
{

struct FreeMap
{
    void operator()(ColorMapObject* map) const noexcept { ::GifFreeMapObject(map); }
};
using Map = std::unique_ptr<ColorMapObject, FreeMap>;

/// A GIF's palette has a power of two of colours, at least two; what is over stays black.
Map make_map(const GifFrame& frame)
{
    int size = 2;
    while (size < frame.colours)
        size *= 2;
    Map map(::GifMakeMapObject(size, nullptr));
    const std::uint8_t* colour = frame.palette;
    for (int i = 0; map && i < frame.colours; ++i, colour += 3)
        map->Colors[i] = {colour[0], colour[1], colour[2]};
    return map;
}

class Encoder final : public GifEncoder
{
  public:
    Encoder(int width, int height, ByteSink sink, void* context)
        : width_(width)
        , height_(height)
        , sink_(sink)
        , context_(context)
    {
        int ignored = 0; // a missing handle says enough
        gif_ = ::EGifOpen(this, write, &ignored);
    }
    ~Encoder() override { close(); }

    /// What stands before the first frame: the size, and that the film plays for ever.
    bool begin()
    {
        static constexpr std::array<std::uint8_t, 3> for_ever = {1, 0, 0};
        if (gif_ == nullptr)
            return false;
        ::EGifSetGifVersion(gif_, true); // 89a: it has extensions
        return ::EGifPutScreenDesc(gif_, width_, height_, 8, 0, nullptr) == GIF_OK &&
               ::EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               ::EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_OK &&
               ::EGifPutExtensionBlock(gif_, for_ever.size(), for_ever.data()) == GIF_OK &&
               ::EGifPutExtensionTrailer(gif_) == GIF_OK;
    }

    bool add(const GifFrame& frame) override
    {
        const Map map = make_map(frame);
        // Each frame covers the one before it: left in place, nothing transparent.
        const std::array<std::uint8_t, 4> control = {
            DISPOSE_DO_NOT << 2, static_cast<std::uint8_t>(frame.delay),
            static_cast<std::uint8_t>(frame.delay >> 8), 0};
        return gif_ != nullptr && map &&
               ::EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, control.size(), control.data()) ==
                   GIF_OK &&
               ::EGifPutImageDesc(gif_, 0, 0, width_, height_, false, map.get()) == GIF_OK &&
               put_rows(frame.indices);
    }

    bool finish() override { return close(); }

  private:
    bool put_rows(const std::uint8_t* indices)
    {
        std::vector<GifPixelType> row(static_cast<std::size_t>(width_)); // giflib writes into it
        for (int y = 0; y < height_; ++y, indices += width_) {
            std::copy_n(indices, width_, row.begin());
            if (::EGifPutLine(gif_, row.data(), width_) != GIF_OK)
                return false;
        }
        return true;
    }

    bool close()
    {
        int ignored = 0;
        GifFileType* const gif = std::exchange(gif_, nullptr);
        return gif != nullptr && ::EGifCloseFile(gif, &ignored) == GIF_OK;
    }

    static int write(GifFileType* gif, const GifByteType* bytes, int count)
    {
        const auto* const self = static_cast<const Encoder*>(gif->UserData);
        self->sink_(self->context_, bytes, static_cast<std::size_t>(count));
        return count;
    }

    int width_;
    int height_;
    ByteSink sink_;
    void* context_;
    GifFileType* gif_ = nullptr;
};

} // namespace
} // namespace raymarch::pictures

extern "C" raymarch::pictures::GifEncoder*
raymarch_open_gif(int width, int height, raymarch::pictures::ByteSink sink, void* context)
{
    using raymarch::pictures::Encoder;
    std::unique_ptr<Encoder> encoder(new (std::nothrow) Encoder(width, height, sink, context));
    return encoder && encoder->begin() ? encoder.release() : nullptr;
}
