// SPDX-License-Identifier: MIT
#include "engine/painter.hpp"

#include <algorithm>
#include <system_error>

namespace raymarch::engine
{
namespace
{

/// Rows that one thread takes at a time: enough to repay a kernel's set-up, and few enough that the
/// threads end together.
constexpr unsigned band_rows = 16;

/// Rows of the region's lattice.
unsigned lattice_rows(const Region& region) noexcept
{
    return (region.height + region.step - 1U) / region.step;
}

/// Rows `first` to `first + count` of the region's lattice.
Region rows_of(const Region& region, unsigned first, unsigned count) noexcept
{
    Region band = region;
    band.y = static_cast<std::uint16_t>(region.y + first * region.step);
    band.height = static_cast<std::uint16_t>(
        std::min<unsigned>(count * region.step, region.height - first * region.step));
    return band;
}

void draw_by_reference(const Drawing& drawing, const Region& region, const Canvas& canvas) noexcept
{
    const Columns columns{region.x, static_cast<std::uint16_t>(region.x + region.width),
                          region.step};
    const std::size_t width = region.size.width;
    for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += region.step)
        drawing.picture->draw(
            {region.size, static_cast<std::uint16_t>(y), region.frame, columns},
            canvas.rgb.subspan(bytes_per_pixel * width * y, bytes_per_pixel * width),
            canvas.costs.subspan(width * y, width));
}

/// Looks a few times before it sleeps: pictures follow one another within microseconds, and to be
/// woken takes tens of them.
void wait_for_change(const std::atomic<unsigned>& value, unsigned from) noexcept
{
    constexpr int looks = 100;
    for (int i = 0; i < looks && value == from; ++i)
        std::this_thread::yield();
    value.wait(from);
}

} // namespace

Painter::Painter(unsigned threads)
{
    if (threads == 0)
        threads = std::max(1U, std::thread::hardware_concurrency());
    try {
        for (unsigned i = 1; i < threads; ++i)
            helpers_.emplace_back([this] { help(); });
    } catch (const std::system_error&) { // no more are to be had; those that are here will do
    }
}

Painter::~Painter()
{
    closing_ = true;
    ++round_;
    round_.notify_all();
}

void Painter::draw(const Drawing& drawing, const Region& region, const Canvas& canvas,
                   const std::stop_token& stop)
{
    Canvas to = canvas;
    if (drawing.kernel == nullptr && canvas.costs.empty()) {
        unwanted_.resize(std::size_t{region.size.width} * region.size.height);
        to.costs = unwanted_;
    }
    // A row of the reference can take seconds: one at a time, so that a stop is soon seen.
    const unsigned rows = drawing.kernel == nullptr ? 1 : band_rows;
    share((lattice_rows(region) + rows - 1) / rows, [&](unsigned part) {
        if (stop.stop_requested())
            return;
        const Region band = rows_of(region, part * rows, rows);
        if (drawing.kernel == nullptr)
            draw_by_reference(drawing, band, to);
        else
            drawing.kernel->draw(*drawing.picture, band, to);
    });
}

/// A helper that wakes up late is not waited for: it finds the job shut.
void Painter::share(unsigned parts, const std::function<void(unsigned)>& work)
{
    work_ = &work;
    parts_ = parts;
    next_ = 0;
    inside_ &= ~shut;
    ++round_;
    round_.notify_all();
    take_parts(listener_);
    inside_ |= shut;
    for (unsigned inside = inside_; inside != shut; inside = inside_)
        wait_for_change(inside_, inside);
}

/// Parts differ in cost, so each thread takes the next one that is free.
void Painter::take_parts(const Listener& listener)
{
    for (unsigned part = next_++; part < parts_; part = next_++) {
        (*work_)(part);
        if (listener)
            listener(std::min<unsigned>(next_, parts_), parts_);
    }
}

void Painter::help()
{
    for (unsigned seen = 0;;) {
        wait_for_change(round_, seen);
        seen = round_;
        if (closing_)
            return;
        if ((inside_++ & shut) == 0)
            take_parts({});
        if (--inside_ == shut)
            inside_.notify_one();
    }
}

} // namespace raymarch::engine
