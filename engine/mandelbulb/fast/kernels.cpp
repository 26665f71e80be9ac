// SPDX-License-Identifier: MIT
// The stages composed, as mandelbulb.cpp does it, for rays in vectors. Highway compiles this file
// once for each instruction set.
#include "engine/mandelbulb/fast/kernels.hpp"

#include "engine/mandelbulb/colouring.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"

// No Isa names it.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/mandelbulb/fast/kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h. The plain C++ that Highway may end with is not used.
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "engine/mandelbulb/fast/orbits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
{

/// The pixels of a region: where rays come from, and where their ends go.
class Pixels
{
  public:
    Pixels(const Frame& frame, const Region& region, const Canvas& canvas)
        : frame_(frame)
        , region_(region)
        , canvas_(canvas)
        , x_(region.x)
        , y_(region.y)
    {}

    bool next(Ray& ray)
    {
        if (x_ >= unsigned{region_.x} + region_.width) {
            x_ = region_.x;
            y_ += region_.step;
        }
        if (region_.width == 0 || y_ >= unsigned{region_.y} + region_.height)
            return false;
        ray.direction = ray_direction(frame_, region_.size, static_cast<std::uint16_t>(x_),
                                      static_cast<std::uint16_t>(y_));
        ray.pixel = std::size_t{y_} * region_.size.width + x_;
        x_ += region_.step;
        return true;
    }

    void finish(std::size_t pixel, Outcome outcome, int evaluations, int index)
    {
        const Rgb colour = outcome == Outcome::Miss ? step_colours[0]
                                                    : colour_of(frame_.colour, evaluations, index);
        std::uint8_t* const to = &canvas_.rgb[3 * pixel];
        to[0] = static_cast<std::uint8_t>(colour >> 16);
        to[1] = static_cast<std::uint8_t>(colour >> 8);
        to[2] = static_cast<std::uint8_t>(colour);
        if (!canvas_.costs.empty())
            canvas_.costs[pixel] = {.steps = static_cast<std::uint32_t>(evaluations), .rays = 1};
    }

  private:
    const Frame& frame_;
    const Region& region_;
    const Canvas& canvas_;
    unsigned x_;
    unsigned y_;
};

/// Rays whose numbers have more bits than a lane, one by one.
template <typename Format>
void march_alone(const Frame& frame, Pixels& pixels)
{
    const Point<Format> origin = position_in<Format>(frame.position);
    const Limits limits{frame.epsilon_shift, frame.max_evaluations};
    for (Ray ray; pixels.next(ray);) {
        const March<Format> end = march<Format>(origin, ray.direction, frame.arithmetic, limits);
        pixels.finish(ray.pixel, end.outcome, end.evaluations, end.index);
    }
}

void draw(WordSpan words, const Region& region, const Canvas& canvas) noexcept
{
    using Format = Q57<Int128>;
    const Frame frame = latch(words);
    Pixels pixels(frame, region, canvas);
    if (frame.form != Form::Q8_57)
        return march_alone<Q64<Int128>>(frame, pixels);
    const Point<Format> origin = position_in<Format>(frame.position);
    const auto [first, index] = estimate<Format>(origin, frame.arithmetic);
    const Course course{.with = frame.arithmetic,
                        .limits = {frame.epsilon_shift, frame.max_evaluations},
                        .origin = origin,
                        .first = first,
                        .epsilon = std::max<std::int64_t>(1, first >> frame.epsilon_shift)};
    if (first <= course.epsilon || first > farthest<Format> || frame.max_evaluations == 1) {
        const Outcome outcome = first <= course.epsilon    ? Outcome::Hit
                                : first > farthest<Format> ? Outcome::Miss
                                                           : Outcome::Limit;
        for (Ray ray; pixels.next(ray);)
            pixels.finish(ray.pixel, outcome, 1, index);
        return;
    }
    Marcher<Pixels>(course, pixels).run();
}

} // namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "engine/kernel_table.hpp"

namespace raymarch::engine::mandelbulb
{

std::span<const Kernel> kernels() noexcept
{
    static constexpr std::array table = {RAYMARCH_KERNELS(draw)};
    return table;
}

} // namespace raymarch::engine::mandelbulb
#endif
