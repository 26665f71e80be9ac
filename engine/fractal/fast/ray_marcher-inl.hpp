// SPDX-License-Identifier: MIT
/// @file
/// The stage of ray_marcher.hpp in vectors. Rays that need many steps more than their neighbours
/// are put aside and marched together.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_RAY_MARCHER) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_RAY_MARCHER
#undef RAYMARCH_ENGINE_FRACTAL_FAST_RAY_MARCHER
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_RAY_MARCHER
#endif

#include "engine/fast/compress-inl.hpp"
#include "engine/fractal/fast/scenes-inl.hpp"
#include "engine/fractal/fast/shading-inl.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

/// Vectors of rays in flight: the steps of one ray wait for each other, those of others do not.
inline constexpr std::size_t in_flight = 3;

enum class Surface : bool { Plain, Brick };

/// Marches the rays of one scene from the first query on.
template <class Rays>
class Marcher
{
    using Tag = typename Rays::Tag;
    using Lane = hn::TFromD<Tag>;
    using V = Vec<Tag>;

  public:
    /// Rays that are begun together.
    static constexpr std::size_t batch = in_flight * lanes<Tag>;

    /// `first` is the distance of `origin`: of a ray that goes on. Endings go to `endings`.
    Marcher(const Point& origin, Number first, Surface surface, Ending* endings) noexcept
        : origin_(origin)
        , first_(first)
        , surface_(surface)
        , endings_(endings)
    {}

    /// One vector of rays.
    struct Bundle
    {
        Rays rays;
        V depth;
        V alive; ///< -1, else 0
    };
    using Bundles = std::array<Bundle, in_flight>;

    /// Marches `count` rays, whose endings stand one after another from `place` on.
    struct Start
    {
        std::array<Directions, Rays::parts> directions;
        std::size_t place; ///< of the endings
        std::size_t count; ///< of the lanes that are rays
    };
    HWY_INLINE void march(const std::array<Start, in_flight>& starts)
    {
        const Tag d;
        Bundles bundles;
        for (std::size_t i = 0; i < in_flight; ++i) {
            Bundle& bundle = bundles[i];
            bundle.rays.aim(starts[i].directions);
            bundle.rays.start(origin_);
            // The first query is the same for all rays, and none of them ends at it.
            bundle.rays.step(hn::Set(d, static_cast<Lane>(first_.raw())));
            bundle.depth = hn::Set(d, 1);
            bundle.alive = hn::VecFromMask(d, hn::FirstN(d, starts[i].count));
        }
        run<Depths::Same>(bundles, enough_to_go_on);
        for (std::size_t i = 0; i < in_flight && starts[i].count > 0; ++i) {
            hn::StoreU(ended(bundles[i]), EndingTag(), endings_ + starts[i].place);
            const V places = hn::Iota(d, static_cast<Lane>(starts[i].place));
            put_aside(bundles[i], places);
        }
        while (waiting_ >= batch)
            take_up(enough_to_go_on);
    }

    /// Marches what was put aside to its end.
    HWY_INLINE void finish()
    {
        while (waiting_ > 0)
            take_up(0);
    }

  private:
    using EndingTag = hn::Rebind<Ending, Tag>;
    /// So few rays of a batch do not go on: they wait for others.
    static constexpr std::size_t enough_to_go_on = batch / 6;

    /// Says whether all rays have made as many steps.
    enum class Depths : bool { Same, Own };

    /// Steps until at most `few` are alive. Beyond the last depth there is no query: who gets there
    /// is lost, and where all get there at once, nobody need look.
    template <Depths depths>
    static HWY_INLINE void run(Bundles& bundles, std::size_t few)
    {
        const Tag d;
        std::size_t alive = 0;
        unsigned left = max_depth;
        do {
            alive = 0;
            for (Bundle& bundle : bundles) {
                const V s = bundle.rays.distance();
                if constexpr (depths == Depths::Own)
                    bundle.alive = hn::And(
                        bundle.alive,
                        hn::VecFromMask(d, hn::Ne(bundle.depth, hn::Set(d, max_depth + 1))));
                bundle.alive = bundle.rays.going_on(s, bundle.alive);
                bundle.rays.step(hn::And(s, bundle.alive));
                bundle.depth = hn::Sub(bundle.depth, bundle.alive);
                alive += hn::CountTrue(d, hn::MaskFromVec(bundle.alive));
            }
        } while (alive > few && (depths == Depths::Own || --left > 0));
        if (depths == Depths::Same && left == 0)
            for (Bundle& bundle : bundles)
                bundle.alive = hn::Zero(d);
    }

    /// The endings of rays that are not alive.
    HWY_INLINE Vec<EndingTag> ended(const Bundle& bundle) const
    {
        const EndingTag d;
        const auto depth = Rays::shortened(bundle.depth);
        const auto last = hn::Set(d, max_depth);
        const auto queries = hn::Add(hn::Min(depth, last), hn::Set(d, 1));
        const auto shaded =
            surface_ == Surface::Brick
                ? brick(d, bundle.rays.texel(0), bundle.rays.texel(1), bundle.rays.texel(2), depth)
                : depth;
        const auto lost = hn::Or(bundle.rays.missed(), hn::VecFromMask(d, hn::Gt(depth, last)));
        const auto level = hn::IfThenElse(hn::MaskFromVec(lost), hn::Set(d, dark), shaded);
        return hn::Or(level, hn::ShiftLeft<queries_shift>(queries));
    }

    HWY_INLINE void put_aside(Bundle& bundle, V places)
    {
        const Compress<Tag> alive(hn::MaskFromVec(bundle.alive));
        if (alive.count() == 0)
            return;
        std::size_t field = 0;
        const auto put = [&](V v) { alive.store(v, aside_[field++].data() + waiting_); };
        bundle.rays.each_field(put);
        put(bundle.depth);
        put(places);
        waiting_ += alive.count();
    }

    HWY_INLINE void take_up(std::size_t few)
    {
        const Tag d;
        const std::size_t taken = std::min(waiting_, batch);
        waiting_ -= taken;
        Bundles bundles;
        std::array<V, in_flight> places;
        for (std::size_t i = 0; i < in_flight; ++i) {
            const std::size_t first = i * lanes<Tag>;
            std::size_t field = 0;
            const auto take = [&](V& v) {
                v = hn::LoadU(d, aside_[field++].data() + waiting_ + first);
            };
            bundles[i].rays.each_field(take);
            take(bundles[i].depth);
            take(places[i]);
            bundles[i].alive = hn::VecFromMask(d, hn::FirstN(d, taken - std::min(taken, first)));
        }
        run<Depths::Own>(bundles, few);
        for (std::size_t i = 0; i < in_flight; ++i) {
            HWY_ALIGN std::array<Ending, lanes<Tag>> endings;
            HWY_ALIGN std::array<Lane, lanes<Tag>> at;
            hn::Store(ended(bundles[i]), EndingTag(), endings.data());
            hn::Store(places[i], d, at.data());
            for (std::size_t lane = 0; i * lanes<Tag> + lane < taken && lane < lanes<Tag>; ++lane)
                endings_[static_cast<std::size_t>(at[lane])] = endings[lane];
            put_aside(bundles[i], places[i]);
        }
    }

    Point origin_;
    Number first_;
    Surface surface_;
    Ending* endings_;
    std::size_t waiting_ = 0;
    /// Fields of rays, their depth and the place of their ending; a store writes a whole vector.
    HWY_ALIGN std::array<std::array<Lane, 3 * batch>, Rays::fields + 2> aside_;
};

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
