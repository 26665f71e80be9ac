// SPDX-License-Identifier: MIT
// The stages composed, as mandelbulb.cpp does it, for rays in vectors. Highway compiles this file
// once for each instruction set.
#include "engine/fast/kernels.hpp"

#include "engine/fast/targets.hpp"
#include "engine/mandelbulb/colouring.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/mandelbulb/fast/kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h. The plain C++ that Highway may end with is not used.
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "engine/mandelbulb/fast/filter-inl.hpp"
#include "engine/mandelbulb/fast/orbits-inl.hpp"

#include <algorithm>
#include <array>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

/// The pixels and costs that rays end in.
class Output
{
  public:
    Output(const Frame& frame, PictureSize size, const Canvas& canvas)
        : frame_(frame)
        , size_(size)
        , canvas_(canvas)
    {}

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

    /// Through the pixel, of any length.
    [[nodiscard]] Direction vector(std::size_t pixel) const
    {
        return ray_vector(frame_, size_, static_cast<std::uint16_t>(pixel % size_.width),
                          static_cast<std::uint16_t>(pixel / size_.width));
    }

  private:
    const Frame& frame_;
    PictureSize size_;
    const Canvas& canvas_;
};

/// The pixels of a region, one after the other.
class Pixels
{
  public:
    explicit Pixels(const Region& region) : region_(region), x_(region.x), y_(region.y) {}

    bool next(std::size_t& pixel)
    {
        if (x_ >= unsigned{region_.x} + region_.width) {
            x_ = region_.x;
            y_ += region_.step;
        }
        if (region_.width == 0 || y_ >= unsigned{region_.y} + region_.height)
            return false;
        pixel = std::size_t{y_} * region_.size.width + x_;
        x_ += region_.step;
        return true;
    }

  private:
    const Region& region_;
    unsigned x_;
    unsigned y_;
};

/// The pixels that the filter has not decided: those that it left, and, once it is given up, all
/// that come after.
class Undecided
{
  public:
    static constexpr std::size_t capacity = 4096;

    explicit Undecided(Pixels& all) : all_(all) {}

    void add(std::size_t pixel) { left_[count_++] = static_cast<std::uint32_t>(pixel); }
    void add_all() { whole_ = true; }
    [[nodiscard]] std::size_t room() const { return capacity - count_; }

    bool next(std::size_t& pixel)
    {
        if (count_ == 0)
            return whole_ && all_.next(pixel);
        pixel = left_[--count_];
        return true;
    }

  private:
    Pixels& all_;
    bool whole_ = false;
    std::size_t count_ = 0;
    std::array<std::uint32_t, capacity> left_; // NOLINT(*-member-init): up to count_
};

/// Rays for the reference's arithmetic.
struct ExactRays
{
    Undecided& source;
    Output& output;

    bool next(Ray& ray)
    {
        if (!source.next(ray.pixel))
            return false;
        ray.direction = unit_vector(output.vector(ray.pixel));
        return true;
    }
    void finish(std::size_t pixel, Outcome outcome, int evaluations, int index)
    {
        output.finish(pixel, outcome, evaluations, index);
    }
};

/// Rays for the filter, as long as it is worth while and there is room for those that it leaves.
class FilteredRays
{
  public:
    FilteredRays(Pixels& source, Output& output, Undecided& undecided)
        : source_(source)
        , output_(output)
        , undecided_(undecided)
    {}

    bool next(Ray& ray)
    {
        if (undecided_.room() <= batch || done())
            return false;
        if (!source_.next(ray.pixel)) {
            drained_ = true;
            return false;
        }
        ray.direction = output_.vector(ray.pixel);
        return true;
    }
    void finish(std::size_t pixel, Outcome outcome, int evaluations, int index)
    {
        output_.finish(pixel, outcome, evaluations, index);
        ++decided_;
    }
    void leave(std::size_t pixel)
    {
        undecided_.add(pixel);
        ++given_up_;
    }
    /// A ray that is left has cost about a fifth of its exact way.
    [[nodiscard]] bool worthwhile() const { return given_up_ < 4 * decided_ + 64; }
    [[nodiscard]] bool done() const { return drained_ || !worthwhile(); }

  private:
    Pixels& source_;
    Output& output_;
    Undecided& undecided_;
    std::size_t decided_ = 0;
    std::size_t given_up_ = 0;
    bool drained_ = false;
};

/// Marches the rays one by one where their numbers have more bits than a lane.
template <class Rays>
void march_all(const Course<Q64<Int128>>& course, Rays& rays)
{
    for (Ray ray; rays.next(ray);) {
        const auto end =
            march<Q64<Int128>>(course.origin, ray.direction, course.with, course.limits);
        rays.finish(ray.pixel, end.outcome, end.evaluations, end.index);
    }
}
template <class Rays>
void march_all(const Course<Q57<Int128>>& course, Rays& rays)
{
    Marcher<Rays>(course, rays).run();
}

template <typename Format>
void draw_in(const Frame& frame, const Region& region, const Canvas& canvas)
{
    const Point<Format> origin = position_in<Format>(frame.position);
    const auto [first, index] = estimate<Format>(origin, frame.arithmetic);
    const typename Format::Coordinate least{1};
    const Course<Format> course{
        .with = frame.arithmetic,
        .limits = {frame.epsilon_shift, frame.max_evaluations},
        .origin = origin,
        .first = first,
        .epsilon = std::max<typename Format::Coordinate>(least, first >> frame.epsilon_shift)};
    Output output(frame, region.size, canvas);
    Pixels pixels(region);
    const bool hit = first <= course.epsilon;
    const bool miss = first > farthest<Format>;
    if (hit || miss || frame.max_evaluations == 1) {
        const Outcome outcome = hit ? Outcome::Hit : miss ? Outcome::Miss : Outcome::Limit;
        for (std::size_t pixel = 0; pixels.next(pixel);)
            output.finish(pixel, outcome, 1, index);
        return;
    }
    Undecided undecided(pixels);
    ExactRays exact{undecided, output};
#if HWY_HAVE_FLOAT64
    const RealCourse real = real_course(course);
    // Else no hit can be told from a ray that has yet to come to it.
    if (bounded(course.with) && 4 * real.bounds.q < real.epsilon) {
        FilteredRays filtered(pixels, output, undecided);
        while (!filtered.done()) {
            Filter<FilteredRays>(real, filtered).run();
            if (!filtered.worthwhile())
                undecided.add_all();
            march_all(course, exact);
        }
        return;
    }
#endif
    undecided.add_all();
    march_all(course, exact);
}

void draw(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const auto& frame = frame_of<Frame>(picture);
    if (frame.form == Form::Q8_57)
        draw_in<Q57<Int128>>(frame, region, canvas);
    else
        draw_in<Q64<Int128>>(frame, region, canvas);
}

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "engine/fast/kernel_table.hpp"
RAYMARCH_DEFINE_KERNELS(mandelbulb)
#endif
