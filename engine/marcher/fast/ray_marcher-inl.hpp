// SPDX-License-Identifier: MIT
/// @file
/// The ray marcher stage on vectors: many rays, all at the same number of queries, of which those
/// that have ended are taken out every few steps.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_RAY_MARCHER) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_RAY_MARCHER
#undef RAYMARCH_ENGINE_MARCHER_FAST_RAY_MARCHER
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_RAY_MARCHER
#endif

#include "engine/fast/compress-inl.hpp"
#include "engine/marcher/fast/scene_query-inl.hpp"
#include "engine/marcher/ray_marcher.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// Rays, component by component.
struct Rays
{
    static constexpr std::size_t capacity = 1024;
    static constexpr std::size_t room = capacity + lanes<I32>; ///< whole vectors are stored
    using Column = std::array<std::int32_t, room + lanes<I32>>;

    alignas(64) Column x; ///< direction, times 2^6
    alignas(64) Column y;
    alignas(64) Column z;
    alignas(64) Column t;     ///< distance gone; that of a ray that has hit: to where it hit
    alignas(64) Column slot;  ///< which it is of the pool's
    alignas(64) Column spent; ///< queries, where they are counted
};

/// Rays on their way from the front on, and those that have ended from the back on.
struct Pool
{
    Rays flying;
    std::size_t count = 0;
    Rays ended;
    std::size_t first_ended = Rays::room;
};

constexpr int direction_shift = 6;
constexpr int travel_shift = 2; ///< together 8: (D * t) >> 24 is the upper half of the product

/// Components of E + mul(D, t), the directions at `direction`. The even lanes' products end in
/// odd lanes, where they are wanted one further down.
HWY_INLINE Vec<I32> along(Vec<I32> eye, const std::int32_t* direction, Vec<I32> t_even,
                          Vec<I32> t_odd)
{
    const Vec<I32> even = hn::LoadU(I32(), direction);
    const Vec<I32> odd = hn::LoadU(I32(), direction + 1);
    return eye +
           hn::BitCast(I32(), upper({multiply_even(even, t_even), multiply_even(odd, t_odd)}));
}

HWY_INLINE Points position(const Points& eye, const Rays& rays, std::size_t at, Vec<I32> t)
{
    const Vec<I32> t_even = hn::ShiftLeft<travel_shift>(t);
    const Vec<I32> t_odd = odd_lanes(t_even);
    return {along(eye.x, &rays.x[at], t_even, t_odd), along(eye.y, &rays.y[at], t_even, t_odd),
            along(eye.z, &rays.z[at], t_even, t_odd)};
}

enum class Counting : bool { Off, On };

/// All rays have these in common.
struct View
{
    Points eye;
    Vec<I32> farthest; ///< a ray whose t is larger has missed: max_distance, or less where that is
                       ///< proved
};

/// One vector of rays on its way.
struct Flight
{
    Vec<I32> t;
    Vec<I32> d;     ///< of the last query
    Vec<I32> alive; ///< -1 where the ray goes on; counting only
    Vec<I32> spent; ///< counting only
};

/// One query. A ray that has hit stays where it is, and its d with it, until it is taken out; one
/// that has gone too far is lost whatever comes after.
template <class Scene, Counting counting>
HWY_INLINE void step(Flight& flight, const View& view, const Rays& rays, std::size_t at)
{
    flight.d = distance<Scene>(position(view.eye, rays, at, flight.t));
    const Vec<I32> clear = hn::VecFromMask(I32(), flight.d > Set<I32>(surface_distance.raw() - 1));
    if constexpr (counting == Counting::On) {
        flight.spent = flight.spent - flight.alive;
        const Vec<I32> lost = hn::VecFromMask(I32(), flight.t + flight.d > view.farthest);
        flight.alive = hn::AndNot(lost, hn::And(clear, flight.alive));
    }
    flight.t = flight.t + hn::And(clear, flight.d);
    if constexpr (Scene::far) // or some steps more would leave the numbers
        flight.t = hn::Min(flight.t, view.farthest + Set<I32>(1));
}

/// Puts the rays that go on at `kept` and the others before those that have ended. Both take whole
/// vectors: what is beyond the rays is written over later, or is not looked at.
template <Counting counting>
HWY_INLINE void sort_out(Pool& pool, const View& view, std::size_t from, std::size_t valid,
                         const Flight& flight, std::size_t& kept)
{
    const Mask<I32> blocked = flight.d < Set<I32>(surface_distance.raw());
    const Mask<I32> lost = hn::And(blocked, flight.t + flight.d > view.farthest);
    const Vec<I32> t = hn::IfThenElse(lost, view.farthest + Set<I32>(1), flight.t);
    Mask<I32> on = hn::Not(hn::Or(blocked, t > view.farthest));
    if (valid < lanes<I32>) // what fills the vector up stays behind the rays
        on = hn::Or(on, hn::Not(hn::FirstN(I32(), valid)));
    const Compress<I32> compress(on);
    const std::size_t ended = pool.first_ended - lanes<I32>;
    const auto store = [&](Vec<I32> v, Rays::Column Rays::*column) HWY_ATTR {
        const Vec<I32> sorted = compress(v);
        hn::StoreU(sorted, I32(), &(pool.flying.*column)[kept]);
        hn::StoreU(sorted, I32(), &(pool.ended.*column)[ended]);
    };
    const auto move = [&](Rays::Column Rays::*column) HWY_ATTR {
        store(hn::LoadU(I32(), &(pool.flying.*column)[from]), column);
    };
    move(&Rays::x);
    move(&Rays::y);
    move(&Rays::z);
    move(&Rays::slot);
    store(t, &Rays::t);
    if constexpr (counting == Counting::On)
        store(flight.spent, &Rays::spent);
    kept += compress.count() - (lanes<I32> - valid);
    pool.first_ended -= lanes<I32> - compress.count();
}

/// Marches `group` vectors of rays from `at` on by `steps` queries.
template <class Scene, Counting counting, std::size_t group>
HWY_INLINE void advance(Pool& pool, const View& view, std::size_t at, std::size_t& kept, int steps)
{
    Flight flights[group];
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes<I32>;
        flights[i] = {hn::LoadU(I32(), &pool.flying.t[from]), hn::Zero(I32()), Set<I32>(-1),
                      hn::Zero(I32())};
        if constexpr (counting == Counting::On)
            flights[i].spent = hn::LoadU(I32(), &pool.flying.spent[from]);
    }
    for (int s = 0; s < steps; ++s)
        for (std::size_t i = 0; i < group; ++i)
            step<Scene, counting>(flights[i], view, pool.flying, at + i * lanes<I32>);
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes<I32>;
        const std::size_t valid = group == 1 ? std::min(pool.count - from, lanes<I32>) : lanes<I32>;
        sort_out<counting>(pool, view, from, valid, flights[i], kept);
    }
}

/// Marches all rays to their ends. At the start each has made one query; those that are flying at
/// the end have made 99.
template <class Scene, Counting counting>
HWY_INLINE void march(Pool& pool, const View& view)
{
    // The hundredth query ends in a miss whatever it says: it is not made.
    for (int made = 1; pool.count != 0 && made < max_steps - 1;) {
        const int steps = std::min(Scene::steps_at_once, max_steps - 1 - made);
        std::size_t kept = 0;
        std::size_t at = 0;
        for (; at + Scene::group * lanes<I32> <= pool.count; at += Scene::group * lanes<I32>)
            advance<Scene, counting, Scene::group>(pool, view, at, kept, steps);
        for (; at < pool.count; at += lanes<I32>)
            advance<Scene, counting, 1>(pool, view, at, kept, steps);
        pool.count = kept;
        made += steps;
    }
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
