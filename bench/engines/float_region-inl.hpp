// SPDX-License-Identifier: MIT
/// @file
/// The stages of float composed, as the kernel's are: rays by rows, a pool at a time, sorted every
/// few steps, shaded where they end.
#if defined(RAYMARCH_BENCH_ENGINES_FLOAT_REGION) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_BENCH_ENGINES_FLOAT_REGION
#undef RAYMARCH_BENCH_ENGINES_FLOAT_REGION
#else
#define RAYMARCH_BENCH_ENGINES_FLOAT_REGION
#endif

#include "engine/fast/compress-inl.hpp"
#include "engine/marcher/fast/outline.hpp"
#include "engine/marcher/fast/pixels-inl.hpp"
#include "engine/marcher/ray_marcher.hpp"
#include "engines/float_stages-inl.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// Rays on their way from the front on, and those that have ended from the back on.
struct FloatPool
{
    static constexpr std::size_t capacity = 1024;
    static constexpr std::size_t room = capacity + lanes<I32>;
    using Column = std::array<float, room + lanes<I32>>;
    using Slots = std::array<std::int32_t, room + lanes<I32>>;
    struct Rays
    {
        alignas(64) Column x;
        alignas(64) Column y;
        alignas(64) Column z;
        alignas(64) Column t;
        alignas(64) Slots slot;
    };
    Rays flying;
    std::size_t count = 0;
    Rays ended;
    std::size_t first_ended = room;
};

constexpr float float_surface_distance = 0.01F;
constexpr float float_max_distance = 20.0F;

template <class Scene, class Outline>
class FloatRegionDrawing
{
  public:
    FloatRegionDrawing(const Frame& frame, const Region& region, const Canvas& canvas) noexcept
        : frame_(frame)
        , region_(region)
        , pixels_(canvas, 1)
        , outline_(frame, region.size)
        , eye_(all_units(frame.eye))
        , light_(all_units(frame.light))
    {}

    void draw() noexcept
    {
        first_t_ = hn::GetLane(distance<Scene>(eye_));
        for (int y = region_.y; y < region_.y + region_.height; ++y)
            draw_row(y);
        finish_rays();
    }

  private:
    void draw_row(int y) noexcept
    {
        const Span span = outline_.of_row(y);
        const std::size_t begin = static_cast<std::size_t>(y) * region_.size.width;
        auto first = static_cast<std::size_t>(span.first);
        const auto end = static_cast<std::size_t>(std::max(span.end, span.first));
        pixels_.fill(begin, first, 0);
        pixels_.fill(begin + end, region_.size.width - end, 0);
        while (first < end) {
            if (pool_.count + lanes < I32 >> FloatPool::capacity || run_count_ == runs_.size())
                finish_rays();
            const std::size_t room = (FloatPool::capacity - pool_.count) / lanes<I32> * lanes<I32>;
            const std::size_t count = std::min(end - first, room);
            runs_[run_count_++] = {begin + first, count};
            add_rays(static_cast<int>(first), y, count);
            first += count;
        }
    }

    HWY_INLINE void add_rays(int x, int y, std::size_t count) noexcept
    {
        const auto u = static_cast<float>(2 * x + 1 - region_.size.width);
        const auto v = static_cast<float>(region_.size.height - 1 - 2 * y);
        const auto f = static_cast<float>(region_.size.height);
        const Vec<F32> columns = hn::Iota(F32(), 0) * Set<F32>(2.0F);
        const auto component = [&](std::int32_t right, std::int32_t up,
                                   std::int32_t forward) HWY_ATTR {
            return hn::MulAdd(columns, Set<F32>(static_cast<float>(right)),
                              Set<F32>(u * static_cast<float>(right) + v * static_cast<float>(up) -
                                       f * static_cast<float>(forward)));
        };
        FloatPoints next = {component(frame_.right.x, frame_.up.x, frame_.forward.x),
                            component(frame_.right.y, frame_.up.y, frame_.forward.y),
                            component(frame_.right.z, frame_.up.z, frame_.forward.z)};
        const float stride = 2.0F * lanes<I32>;
        const FloatPoints to_next = {Set<F32>(stride * static_cast<float>(frame_.right.x)),
                                     Set<F32>(stride * static_cast<float>(frame_.right.y)),
                                     Set<F32>(stride * static_cast<float>(frame_.right.z))};
        FloatPool::Rays& rays = pool_.flying;
        for (std::size_t at = pool_.count; at < pool_.count + count; at += lanes<I32>) {
            const FloatPoints direction = normalise(next);
            hn::StoreU(direction.x, F32(), &rays.x[at]);
            hn::StoreU(direction.y, F32(), &rays.y[at]);
            hn::StoreU(direction.z, F32(), &rays.z[at]);
            hn::StoreU(Set<F32>(first_t_), F32(), &rays.t[at]);
            hn::StoreU(hn::Iota(I32(), static_cast<std::int32_t>(at)), I32(), &rays.slot[at]);
            next = {next.x + to_next.x, next.y + to_next.y, next.z + to_next.z};
        }
        pool_.count += count;
    }

    HWY_INLINE FloatPoints position(const FloatPool::Rays& rays, std::size_t at, Vec<F32> t) const
    {
        return {hn::MulAdd(hn::LoadU(F32(), &rays.x[at]), t, eye_.x),
                hn::MulAdd(hn::LoadU(F32(), &rays.y[at]), t, eye_.y),
                hn::MulAdd(hn::LoadU(F32(), &rays.z[at]), t, eye_.z)};
    }

    template <std::size_t group>
    HWY_INLINE void advance(std::size_t at, std::size_t& kept, int steps) noexcept
    {
        Vec<F32> t[group];
        Vec<F32> d[group];
        for (std::size_t i = 0; i < group; ++i)
            t[i] = hn::LoadU(F32(), &pool_.flying.t[at + i * lanes<I32>]);
        const Vec<F32> surface = Set<F32>(float_surface_distance);
        for (int s = 0; s < steps; ++s)
            for (std::size_t i = 0; i < group; ++i) {
                d[i] = distance<Scene>(position(pool_.flying, at + i * lanes<I32>, t[i]));
                t[i] = t[i] + hn::IfThenElseZero(d[i] >= surface, d[i]);
            }
        for (std::size_t i = 0; i < group; ++i) {
            const std::size_t from = at + i * lanes<I32>;
            const std::size_t valid =
                group == 1 ? std::min(pool_.count - from, lanes<I32>) : lanes<I32>;
            sort_out(from, valid, t[i], d[i], kept);
        }
    }

    HWY_INLINE void sort_out(std::size_t from, std::size_t valid, Vec<F32> t, Vec<F32> d,
                             std::size_t& kept) noexcept
    {
        const auto goes_on =
            hn::And(d >= Set<F32>(float_surface_distance), t <= Set<F32>(float_max_distance));
        Mask<I32> on = hn::RebindMask(I32(), goes_on);
        if (valid < lanes<I32>)
            on = hn::Or(on, hn::Not(hn::FirstN(I32(), valid)));
        const Compress<I32> compress(on);
        const std::size_t ended = pool_.first_ended - lanes<I32>;
        const auto store = [&](Vec<F32> v, FloatPool::Column FloatPool::Rays::*column) HWY_ATTR {
            const Vec<F32> sorted = hn::BitCast(F32(), compress(hn::BitCast(I32(), v)));
            hn::StoreU(sorted, F32(), &(pool_.flying.*column)[kept]);
            hn::StoreU(sorted, F32(), &(pool_.ended.*column)[ended]);
        };
        store(hn::LoadU(F32(), &pool_.flying.x[from]), &FloatPool::Rays::x);
        store(hn::LoadU(F32(), &pool_.flying.y[from]), &FloatPool::Rays::y);
        store(hn::LoadU(F32(), &pool_.flying.z[from]), &FloatPool::Rays::z);
        store(t, &FloatPool::Rays::t);
        const Vec<I32> slot = compress(hn::LoadU(I32(), &pool_.flying.slot[from]));
        hn::StoreU(slot, I32(), &pool_.flying.slot[kept]);
        hn::StoreU(slot, I32(), &pool_.ended.slot[ended]);
        kept += compress.count() - (lanes<I32> - valid);
        pool_.first_ended -= lanes<I32> - compress.count();
    }

    void march() noexcept
    {
        for (int made = 1; pool_.count != 0 && made < max_steps - 1;) {
            const int steps = std::min(Scene::steps_at_once, max_steps - 1 - made);
            std::size_t kept = 0;
            std::size_t at = 0;
            for (; at + Scene::group * lanes<I32> <= pool_.count; at += Scene::group * lanes<I32>)
                advance<Scene::group>(at, kept, steps);
            for (; at < pool_.count; at += lanes<I32>)
                advance<1>(at, kept, steps);
            pool_.count = kept;
            made += steps;
        }
    }

    void finish_rays() noexcept
    {
        march();
        for (std::size_t i = 0; i < pool_.count; ++i)
            colours_[static_cast<std::uint32_t>(pool_.flying.slot[i])] = 0;
        pool_.count = 0;
        for (std::size_t at = pool_.first_ended; at < FloatPool::room; at += lanes<I32>)
            shade_ended(at, std::min(lanes<I32>, FloatPool::room - at));
        pool_.first_ended = FloatPool::room;
        std::size_t slot = 0;
        for (std::size_t i = 0; i < run_count_; ++i) {
            pixels_.colours(runs_[i].pixel, runs_[i].count, &colours_[slot]);
            slot += runs_[i].count;
        }
        run_count_ = 0;
    }

    void shade_ended(std::size_t at, std::size_t count) noexcept
    {
        const FloatPool::Rays& rays = pool_.ended;
        const Vec<F32> t = hn::LoadU(F32(), &rays.t[at]);
        const FloatPoints p = position(rays, at, t);
        const FloatPoints light = normalise({light_.x - p.x, light_.y - p.y, light_.z - p.z});
        const Vec<U32> colour = shade(frame_.colour, surface_normal<Scene>(p), light);
        const Vec<I32> lost =
            hn::VecFromMask(I32(), hn::RebindMask(I32(), t > Set<F32>(float_max_distance)));
        alignas(64) std::array<std::uint32_t, lanes<I32>> colours;
        hn::Store(hn::AndNot(hn::BitCast(U32(), lost), colour), U32(), colours.data());
        for (std::size_t i = 0; i < count; ++i)
            colours_[static_cast<std::uint32_t>(rays.slot[at + i])] = colours[i];
    }

    struct Run
    {
        std::size_t pixel;
        std::size_t count;
    };
    const Frame& frame_;
    const Region& region_;
    PixelWriter pixels_;
    Outline outline_;
    FloatPoints eye_;
    FloatPoints light_;
    float first_t_ = 0;
    FloatPool pool_;
    std::array<std::uint32_t, FloatPool::capacity> colours_;
    std::array<Run, 64> runs_;
    std::size_t run_count_ = 0;
};

/// Whole rows only.
void draw_float(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const auto& frame = frame_of<Frame>(picture);
    switch (frame.scene) {
    case marcher::Scene::Sphere:
        return FloatRegionDrawing<FloatSphere, BallOutline>(frame, region, canvas).draw();
    case marcher::Scene::Cube:
        return FloatRegionDrawing<FloatCube, BoxOutline>(frame, region, canvas).draw();
    case marcher::Scene::InfiniteCube:
        return FloatRegionDrawing<FloatInfiniteCube, NoOutline>(frame, region, canvas).draw();
    case marcher::Scene::Tunnel:
        return FloatRegionDrawing<FloatTunnel, NoOutline>(frame, region, canvas).draw();
    }
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
