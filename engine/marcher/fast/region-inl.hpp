// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: a region's rays are generated row by row, marched a pool at a time, shaded
/// where they end, and written to the picture.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_REGION) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_REGION
#undef RAYMARCH_ENGINE_MARCHER_FAST_REGION
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_REGION
#endif

#include "engine/marcher/fast/outline.hpp"
#include "engine/marcher/fast/pixels-inl.hpp"
#include "engine/marcher/fast/ray_generator-inl.hpp"
#include "engine/marcher/fast/ray_marcher-inl.hpp"
#include "engine/marcher/fast/shading-inl.hpp"
#include "engine/marcher/fast/surface_vectors-inl.hpp"
#include "engine/marcher/frame.hpp"
#include "engine/marcher/scene_query.hpp"
#include "engine/marcher/shading.hpp"
#include "engine/marcher/surface_vectors.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// Pixels side by side (a step apart) whose rays have slots side by side.
struct Run
{
    std::size_t pixel; ///< the first one's place in the picture
    std::size_t count;
};

/// Draws one region: `Outline` says which pixels may show the scene.
template <class Scene, class Outline, Counting counting>
class RegionDrawing
{
  public:
    RegionDrawing(const Frame& frame, const Region& region, const Canvas& canvas,
                  const Outline& outline) noexcept
        : frame_(frame)
        , region_(region)
        , pixels_(canvas, region.step)
        , outline_(outline)
        , view_{points(frame.eye),
                Set<I32>(counting == Counting::On ? max_distance.raw() : outline.farthest().raw())}
        , light_(points(frame.light))
    {}

    void draw() noexcept
    {
        // Each ray's first query is at the eye: they all have the same answer.
        const Coordinate d = scene_row(frame_.scene).distance(frame_.eye);
        const bool lost = d > max_distance;
        const bool hit = !lost && d < surface_distance;
        const std::uint32_t colour = hit ? colour_at_eye() : 0;
        first_t_ = Set<I32>(d.raw());
        for (int y = region_.y; y < region_.y + region_.height; y += region_.step)
            if (lost || hit)
                finish({row_begin(y), columns()}, colour, 1);
            else
                draw_row(y);
        finish_rays();
    }

  private:
    std::uint32_t colour_at_eye() const noexcept
    {
        const Distance distance = scene_row(frame_.scene).distance;
        const std::array<std::uint8_t, 3> rgb = marcher::shade(
            frame_.colour, marcher::brightness(marcher::surface_normal(frame_.eye, distance),
                                               marcher::light_direction(frame_.eye, frame_.light)));
        return rgb[0] | std::uint32_t{rgb[1]} << 8 | std::uint32_t{rgb[2]} << 16;
    }

    /// The first pixel of the region's row, and how many it has.
    std::size_t row_begin(int y) const noexcept
    {
        return static_cast<std::size_t>(y) * region_.size.width + region_.x;
    }
    std::size_t columns() const noexcept
    {
        return (region_.width + std::size_t{region_.step} - 1) / region_.step;
    }

    /// All pixels of a run alike.
    void finish(const Run& run, std::uint32_t colour, std::int32_t queries) const noexcept
    {
        pixels_.fill(run.pixel, run.count, colour);
        if constexpr (counting == Counting::On)
            for (std::size_t i = 0; i < run.count; ++i)
                pixels_.cost(run.pixel + i * region_.step, queries);
    }

    /// Black left and right of the outline, rays inside. Where queries are counted, all are made.
    void draw_row(int y) noexcept
    {
        std::size_t before = 0;
        std::size_t after = columns();
        if constexpr (counting == Counting::Off) {
            const Span span = outline_.of_row(y);
            const auto column = [&](int x) { // the first that is not left of x
                const int from = std::max(x - region_.x, 0);
                return static_cast<std::size_t>((from + region_.step - 1) / region_.step);
            };
            after = std::min(after, column(span.end));
            before = std::min(after, column(span.first));
        }
        const std::size_t begin = row_begin(y);
        const std::size_t step = region_.step;
        pixels_.fill(begin, before, 0);
        pixels_.fill(begin + after * step, columns() - after, 0);
        RowOfDirections directions(frame_, region_.size,
                                   static_cast<int>(region_.x + before * step), y, region_.step);
        while (before < after) {
            if (pool_.count + lanes < I32 >> Rays::capacity || run_count_ == runs_.size())
                finish_rays();
            const std::size_t room = Rays::capacity - pool_.count;
            const std::size_t count = std::min(after - before, room / lanes<I32> * lanes<I32>);
            runs_[run_count_++] = {begin + before * step, count};
            add_rays(directions, count);
            before += count;
        }
    }

    HWY_INLINE void add_rays(RowOfDirections& directions, std::size_t count) noexcept
    {
        Rays& rays = pool_.flying;
        for (std::size_t at = pool_.count; at < pool_.count + count; at += lanes<I32>) {
            const Points direction = directions.next();
            hn::StoreU(hn::ShiftLeft<direction_shift>(direction.x), I32(), &rays.x[at]);
            hn::StoreU(hn::ShiftLeft<direction_shift>(direction.y), I32(), &rays.y[at]);
            hn::StoreU(hn::ShiftLeft<direction_shift>(direction.z), I32(), &rays.z[at]);
            hn::StoreU(first_t_, I32(), &rays.t[at]);
            hn::StoreU(hn::Iota(I32(), static_cast<std::int32_t>(at)), I32(), &rays.slot[at]);
            if constexpr (counting == Counting::On)
                hn::StoreU(Set<I32>(1), I32(), &rays.spent[at]);
        }
        pool_.count += count;
    }

    /// Marches the rays that there are to their ends and writes what they have come to.
    void finish_rays() noexcept
    {
        march<Scene, counting>(pool_, view_);
        for (std::size_t i = 0; i < pool_.count; ++i)
            set(pool_.flying.slot[i], 0, max_steps);
        pool_.count = 0;
        for (std::size_t at = pool_.first_ended; at < Rays::room; at += lanes<I32>)
            shade_ended(at, std::min(lanes<I32>, Rays::room - at));
        pool_.first_ended = Rays::room;

        std::size_t slot = 0;
        for (std::size_t i = 0; i < run_count_; ++i) {
            const Run& run = runs_[i];
            pixels_.colours(run.pixel, run.count, &colours_[slot]);
            if constexpr (counting == Counting::On)
                for (std::size_t j = 0; j < run.count; ++j)
                    pixels_.cost(run.pixel + j * region_.step, queries_[slot + j]);
            slot += run.count;
        }
        run_count_ = 0;
    }

    void shade_ended(std::size_t at, std::size_t count) noexcept
    {
        const Rays& rays = pool_.ended;
        const Vec<I32> t = hn::LoadU(I32(), &rays.t[at]);
        const Points p = position(view_.eye, rays, at, t);
        const Vec<I32> bright =
            HWY_NAMESPACE::brightness(HWY_NAMESPACE::surface_normal<typename Scene::Near>(p),
                                      HWY_NAMESPACE::light_direction(p, light_));
        const Vec<I32> lost = hn::VecFromMask(I32(), t > view_.farthest);
        alignas(64) std::array<std::uint32_t, lanes<I32>> colours;
        hn::Store(hn::AndNot(hn::BitCast(U32(), lost), HWY_NAMESPACE::shade(frame_.colour, bright)),
                  U32(), colours.data());
        for (std::size_t i = 0; i < count; ++i)
            set(rays.slot[at + i], colours[i], rays.spent[at + i]);
    }

    HWY_INLINE void set(std::int32_t slot, std::uint32_t colour, std::int32_t queries) noexcept
    {
        const auto at = static_cast<std::uint32_t>(slot);
        colours_[at] = colour;
        if constexpr (counting == Counting::On)
            queries_[at] = queries;
    }

    const Frame& frame_;
    const Region& region_;
    PixelWriter pixels_;
    Outline outline_;
    View view_;
    Points light_;
    Vec<I32> first_t_{};
    Pool pool_;
    // The pool's rays have come to this, by the slots that they were given in turn.
    std::array<std::uint32_t, Rays::capacity> colours_;
    std::array<std::int32_t, Rays::capacity> queries_; ///< where they are counted
    std::array<Run, 64> runs_;
    std::size_t run_count_ = 0;
};

template <class Scene, Counting counting, class Outline>
void draw_inside(const Outline& outline, const Frame& frame, const Region& region,
                 const Canvas& canvas) noexcept
{
    RegionDrawing<Scene, Outline, counting>(frame, region, canvas, outline).draw();
}

template <Counting counting>
void draw_scene(const Frame& frame, const Region& region, const Canvas& canvas) noexcept
{
    const NoOutline everywhere(frame, region.size);
    switch (frame.scene) {
    case marcher::Scene::Sphere:
        if (const BallOutline ball(frame, region.size); counting == Counting::Off && ball.near())
            draw_inside<SphereOf<Squares::Small>, Counting::Off>(ball, frame, region, canvas);
        else
            draw_inside<SphereOf<Squares::Any>, counting>(ball, frame, region, canvas);
        return;
    case marcher::Scene::Cube:
        return draw_inside<Cube, counting>(BoxOutline(frame, region.size), frame, region, canvas);
    case marcher::Scene::InfiniteCube:
        return draw_inside<InfiniteCube, counting>(everywhere, frame, region, canvas);
    case marcher::Scene::Tunnel:
        return draw_inside<Tunnel, counting>(everywhere, frame, region, canvas);
    }
}

/// See Kernel.
void draw(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const auto& frame = frame_of<Frame>(picture);
    if (canvas.costs.empty())
        draw_scene<Counting::Off>(frame, region, canvas);
    else
        draw_scene<Counting::On>(frame, region, canvas);
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
