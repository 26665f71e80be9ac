// SPDX-License-Identifier: MIT
#include "engine/draw.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace raymarch::engine
{

std::vector<PixelCost> draw(const Model& model, WordSpan words, Image& image, unsigned threads,
                            std::uint32_t frame, const std::stop_token& stop)
{
    if (threads == 0)
        threads = std::max(1U, std::thread::hardware_concurrency());
    const PictureSize size = image.size;
    std::vector<PixelCost> costs(std::size_t{size.width} * size.height);
    std::atomic<unsigned> next_row = 0;

    // Rows differ in cost, so each thread takes the next one that is free.
    const auto work = [&] {
        for (unsigned y = next_row++; y < size.height && !stop.stop_requested(); y = next_row++)
            model.draw_row(words, {size, static_cast<std::uint16_t>(y), frame}, image.row(y),
                           std::span(costs).subspan(std::size_t{y} * size.width, size.width));
    };
    {
        std::vector<std::jthread> others;
        for (unsigned i = 1; i < threads; ++i)
            others.emplace_back(work);
        work();
    }
    if (model.finish != nullptr && !stop.stop_requested())
        model.finish(words, image, costs);
    return costs;
}

void draw_still(const Model& model, WordSpan words, Image& image, unsigned threads)
{
    const unsigned frames = frames_of_a_still(model, words);
    Image other(frames > 1 ? image.size : PictureSize{});
    for (unsigned frame = 0; frame < frames; ++frame) {
        if (frame > 0)
            std::swap(image, other);
        draw(model, words, image, threads, frame);
    }
}

std::uint64_t frame_cycles(const Model& model, WordSpan words, PictureSize size,
                           std::uint32_t frame, std::span<const PixelCost> costs)
{
    const auto last = static_cast<std::uint16_t>(size.height - 1);
    return model.frame_cycles(words, {size, last, frame}, costs, model.description->ray_units);
}

} // namespace raymarch::engine
