// SPDX-License-Identifier: MIT
// The ray marcher stage on vectors: many rays, all at the same number of queries, of which those
// that have ended are taken out every few steps. Included by kernel.cpp alone, once for each
// instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

/// Rays, component by component.
struct Rays
{
    static constexpr std::size_t capacity = 1024;
    static constexpr std::size_t room = capacity + lanes; ///< whole vectors are stored
    using Column = std::array<std::int32_t, room + lanes>;

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
HWY_INLINE Ints along(Ints eye, const std::int32_t* direction, Ints t_even, Ints t_odd)
{
    const Ints even = hn::LoadU(IntTag(), direction);
    const Ints odd = hn::LoadU(IntTag(), direction + 1);
    return eye + as_ints(upper({multiply_even(even, t_even), multiply_even(odd, t_odd)}));
}

HWY_INLINE Points position(const Points& eye, const Rays& rays, std::size_t at, Ints t)
{
    const Ints t_even = hn::ShiftLeft<travel_shift>(t);
    const Ints t_odd = odd_lanes(t_even);
    return {along(eye.x, &rays.x[at], t_even, t_odd), along(eye.y, &rays.y[at], t_even, t_odd),
            along(eye.z, &rays.z[at], t_even, t_odd)};
}

enum class Counting : bool { Off, On };

/// What all rays have in common.
struct View
{
    Points eye;
    Ints farthest; ///< a ray whose t is larger has missed: max_distance, or less where that is
                   ///< proved
};

/// One vector of rays on its way.
struct Flight
{
    Ints t;
    Ints d;     ///< of the last query
    Ints alive; ///< -1 where the ray goes on; counting only
    Ints spent; ///< counting only
};

/// One query. A ray that has hit stays where it is, and its d with it, until it is taken out; one
/// that has gone too far is lost whatever comes after.
template <class Scene, Counting counting>
HWY_INLINE void step(Flight& flight, const View& view, const Rays& rays, std::size_t at)
{
    flight.d = distance<Scene>(position(view.eye, rays, at, flight.t));
    const Ints clear = hn::VecFromMask(IntTag(), flight.d > all(surface_distance.raw() - 1));
    if constexpr (counting == Counting::On) {
        flight.spent = flight.spent - flight.alive;
        const Ints lost = hn::VecFromMask(IntTag(), flight.t + flight.d > view.farthest);
        flight.alive = hn::AndNot(lost, hn::And(clear, flight.alive));
    }
    flight.t = flight.t + hn::And(clear, flight.d);
    if constexpr (Scene::far) // or some steps more would leave the numbers
        flight.t = hn::Min(flight.t, view.farthest + all(1));
}

/// Puts the rays that go on at `kept` and the others before those that have ended. Both take whole
/// vectors: what is beyond the rays is written over later, or is not looked at.
template <Counting counting>
HWY_INLINE void sort_out(Pool& pool, const View& view, std::size_t from, std::size_t valid,
                         const Flight& flight, std::size_t& kept)
{
    const Chosen blocked = flight.d < all(surface_distance.raw());
    const Chosen lost = hn::And(blocked, flight.t + flight.d > view.farthest);
    const Ints t = hn::IfThenElse(lost, view.farthest + all(1), flight.t);
    Chosen on = hn::Not(hn::Or(blocked, t > view.farthest));
    if (valid < lanes) // what fills the vector up stays behind the rays
        on = hn::Or(on, hn::Not(hn::FirstN(IntTag(), valid)));
    const Compaction compaction(on);
    const std::size_t ended = pool.first_ended - lanes;
    const auto store = [&](Ints v, Rays::Column Rays::*column) HWY_ATTR {
        const Ints sorted = compaction(v);
        hn::StoreU(sorted, IntTag(), &(pool.flying.*column)[kept]);
        hn::StoreU(sorted, IntTag(), &(pool.ended.*column)[ended]);
    };
    const auto move = [&](Rays::Column Rays::*column) HWY_ATTR {
        store(hn::LoadU(IntTag(), &(pool.flying.*column)[from]), column);
    };
    move(&Rays::x);
    move(&Rays::y);
    move(&Rays::z);
    move(&Rays::slot);
    store(t, &Rays::t);
    if constexpr (counting == Counting::On)
        store(flight.spent, &Rays::spent);
    kept += compaction.count() - (lanes - valid);
    pool.first_ended -= lanes - compaction.count();
}

/// Marches `group` vectors of rays from `at` on by `steps` queries.
template <class Scene, Counting counting, std::size_t group>
HWY_INLINE void advance(Pool& pool, const View& view, std::size_t at, std::size_t& kept, int steps)
{
    Flight flights[group];
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes;
        flights[i] = {hn::LoadU(IntTag(), &pool.flying.t[from]), hn::Zero(IntTag()), all(-1),
                      hn::Zero(IntTag())};
        if constexpr (counting == Counting::On)
            flights[i].spent = hn::LoadU(IntTag(), &pool.flying.spent[from]);
    }
    for (int s = 0; s < steps; ++s)
        for (std::size_t i = 0; i < group; ++i)
            step<Scene, counting>(flights[i], view, pool.flying, at + i * lanes);
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes;
        const std::size_t valid = group == 1 ? std::min(pool.count - from, lanes) : lanes;
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
        for (; at + Scene::group * lanes <= pool.count; at += Scene::group * lanes)
            advance<Scene, counting, Scene::group>(pool, view, at, kept, steps);
        for (; at < pool.count; at += lanes)
            advance<Scene, counting, 1>(pool, view, at, kept, steps);
        pool.count = kept;
        made += steps;
    }
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
