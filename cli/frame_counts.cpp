// SPDX-License-Identifier: MIT
#include "cli/frame_counts.hpp"

#include "engine/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raymarch::cli
{
namespace
{

/// Returns the mean of `value(frame)` over the frames.
template <typename Value>
Mean mean_of(const CountedView& view, Value value)
{
    Mean mean{.sum = 0, .count = view.frames.size()};
    for (const CountedFrame& frame : view.frames)
        mean.sum += value(frame);
    return mean;
}

/// The sum needs 64 bits, because the part of one pixel has 32.
std::uint64_t sum_of(const CountedFrame& frame, std::uint32_t engine::PixelCost::*part)
{
    std::uint64_t sum = 0;
    for (const engine::PixelCost& cost : frame.costs)
        sum += cost.*part;
    return sum;
}

} // namespace

CountedView count(const engine::Model& model, const protocol::Words& words,
                  protocol::PictureSize size, std::optional<std::uint32_t> number, unsigned threads)
{
    const unsigned frames = number ? 1 : engine::frames_of_a_still(model, words);
    CountedView view{.model = &model, .words = words, .size = size, .frames = {}};
    engine::Image image(size);
    engine::Painter painter(threads);
    for (std::uint32_t i = 0; i < frames; ++i) {
        const std::uint32_t frame = number.value_or(i);
        std::vector<engine::PixelCost> costs(std::size_t{size.width} * size.height);
        engine::draw_frame(painter, {model, words, engine::kernel_of(model)},
                           engine::whole(size, frame), {image.rgb, costs});
        view.frames.push_back({.number = frame, .costs = std::move(costs)});
    }
    return view;
}

std::string text_of(Mean mean)
{
    std::string text = fmt::format("{}", mean.sum / mean.count);
    const std::uint64_t hundredths = mean.sum % mean.count * 100 / mean.count;
    if (hundredths != 0)
        text += hundredths % 10 == 0 ? fmt::format(".{}", hundredths / 10)
                                     : fmt::format(".{:02}", hundredths);
    return text;
}

Mean rays(const CountedView& view)
{
    return mean_of(view, [&](const CountedFrame& frame) {
        return view.model->latch(view.words)->rays(view.size, frame.costs);
    });
}

Mean steps(const CountedView& view)
{
    return mean_of(
        view, [](const CountedFrame& frame) { return sum_of(frame, &engine::PixelCost::steps); });
}

Mean cycles(const CountedView& view, unsigned units)
{
    const auto last = static_cast<std::uint16_t>(view.size.height - 1);
    return mean_of(view, [&](const CountedFrame& frame) {
        return view.model->latch(view.words)
            ->cycles({view.size, last, frame.number}, frame.costs, units);
    });
}

std::string four_digits(double value)
{
    constexpr int digits = 4;
    const int whole = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
    return fmt::format("{:.{}f}", value, std::max(digits - whole, 0));
}

} // namespace raymarch::cli
