// SPDX-License-Identifier: MIT
#include "engine/draw.hpp"

#include <utility>

namespace raymarch::engine
{

const Kernel* kernel_of(const Model& model, std::optional<Isa> isa) noexcept
{
    const Kernel* best = nullptr;
    for (const Kernel& kernel : model.kernels())
        if (kernel.draw != nullptr && supported(kernel.isa) &&
            (isa ? kernel.isa == *isa : best == nullptr || best->isa < kernel.isa))
            best = &kernel;
    return best;
}

void draw_frame(Painter& painter, const Drawing& drawing, const Region& region,
                const Canvas& canvas, const std::stop_token& stop)
{
    if (!drawing.model.ordered) {
        painter.draw(drawing, region, canvas, stop);
        return;
    }
    std::vector<PixelCost> costs(
        canvas.costs.empty() ? std::size_t{region.size.width} * region.size.height : 0);
    const Canvas to{canvas.rgb, costs.empty() ? canvas.costs : std::span(costs)};
    painter.draw(drawing, whole(region.size, region.frame), to, stop);
    if (!stop.stop_requested())
        drawing.picture->complete(to);
}

std::vector<PixelCost> draw(const Model& model, WordSpan words, Image& image, unsigned threads,
                            std::uint32_t frame, const std::stop_token& stop)
{
    std::vector<PixelCost> costs(std::size_t{image.size.width} * image.size.height);
    Painter painter(threads);
    draw_frame(painter, {model, words}, whole(image.size, frame), {image.rgb, costs}, stop);
    return costs;
}

void draw_still(Painter& painter, const Drawing& drawing, const Region& tile, Image& image)
{
    const unsigned frames = drawing.picture->frames();
    Image other(frames > 1 ? image.size : PictureSize{});
    for (unsigned frame = 0; frame < frames; ++frame) {
        if (frame > 0)
            std::swap(image, other);
        Region region = tile;
        region.frame = frame;
        draw_frame(painter, drawing, region, {image.rgb});
    }
}

std::uint64_t frame_cycles(const Model& model, WordSpan words, PictureSize size,
                           std::uint32_t frame, std::span<const PixelCost> costs)
{
    const auto last = static_cast<std::uint16_t>(size.height - 1);
    return model.latch(words)->cycles({size, last, frame}, costs, model.description->ray_units);
}

} // namespace raymarch::engine
