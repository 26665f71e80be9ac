// SPDX-License-Identifier: MIT
// The ray marcher stage on vectors: many rays, all at the same number of queries, of which those
// that have ended are taken out every few steps. Included by kernel.cpp alone, once for each
// instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

/// Rays in flight, or rays that have hit: component by component.
struct Rays
{
    static constexpr std::size_t capacity = 512;
    static constexpr std::size_t room = capacity + lanes; ///< the last store may be a whole vector
    using Column = std::array<std::int32_t, room>;

    alignas(64) Column x; ///< direction, times 2^6
    alignas(64) Column y;
    alignas(64) Column z;
    alignas(64) Column t;     ///< distance gone
    alignas(64) Column pixel; ///< which it belongs to
    alignas(64) Column spent; ///< queries, where they are counted
    std::size_t count = 0;
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

/// One vector of rays on its way.
struct Flight
{
    Ints t;
    Ints d;     ///< of the last query
    Ints alive; ///< -1 where the ray goes on; counting only
    Ints spent; ///< counting only
};

/// One query. A ray that has hit stays where it is, and its d with it, until it is taken out; one
/// that has gone past max_distance is lost whatever comes after.
template <class Scene, Counting counting>
HWY_INLINE void step(Flight& flight, const Points& eye, const Rays& rays, std::size_t at)
{
    const Ints surface = all(surface_distance.raw());
    flight.d = distance<Scene>(position(eye, rays, at, flight.t));
    const Ints blocked = hn::VecFromMask(IntTag(), flight.d < surface);
    if constexpr (counting == Counting::On) {
        flight.spent = flight.spent - flight.alive;
        const Ints lost = hn::VecFromMask(IntTag(), flight.t + flight.d > all(max_distance.raw()));
        flight.alive = hn::AndNot(hn::Or(blocked, lost), flight.alive);
    }
    flight.t = flight.t + hn::AndNot(blocked, flight.d);
    if constexpr (Scene::far) // or some steps more would leave the 32 bits
        flight.t = hn::Min(flight.t, all(max_distance.raw() + 1));
}

/// Marches `group` vectors of rays from `at` on by `steps` queries, then appends those that hit to
/// `hits` and those that go on to the first `kept` rays.
template <class Scene, Counting counting, std::size_t group, class Lost>
HWY_INLINE void advance(Rays& rays, std::size_t at, std::size_t& kept, int steps, const Points& eye,
                        Rays& hits, const Lost& lost)
{
    Flight flights[group];
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes;
        flights[i] = {hn::LoadU(IntTag(), &rays.t[from]), hn::Zero(IntTag()), all(-1),
                      hn::Zero(IntTag())};
        if constexpr (counting == Counting::On)
            flights[i].spent = hn::LoadU(IntTag(), &rays.spent[from]);
    }
    for (int s = 0; s < steps; ++s)
        for (std::size_t i = 0; i < group; ++i)
            step<Scene, counting>(flights[i], eye, rays, at + i * lanes);

    const Ints too_far = all(max_distance.raw() + 1);
    for (std::size_t i = 0; i < group; ++i) {
        const std::size_t from = at + i * lanes;
        const Flight& flight = flights[i];
        const Ints x = hn::LoadU(IntTag(), &rays.x[from]);
        const Ints y = hn::LoadU(IntTag(), &rays.y[from]);
        const Ints z = hn::LoadU(IntTag(), &rays.z[from]);
        const Ints pixel = hn::LoadU(IntTag(), &rays.pixel[from]);
        const Chosen near = flight.t < too_far;
        const Chosen blocked = flight.d < all(surface_distance.raw());
        const Chosen hit = hn::And(hn::And(near, blocked), flight.t + flight.d < too_far);
        const Chosen on = hn::AndNot(blocked, near);
        if constexpr (counting == Counting::On)
            lost(hn::AndNot(hn::Or(hit, on), hn::FirstN(IntTag(), rays.count - from)), pixel,
                 flight.spent);
        const auto keep = [&](Chosen which, Rays& to, std::size_t& count) HWY_ATTR {
            const Compaction compaction(which);
            compaction.store(x, &to.x[count]);
            compaction.store(y, &to.y[count]);
            compaction.store(z, &to.z[count]);
            compaction.store(flight.t, &to.t[count]);
            compaction.store(pixel, &to.pixel[count]);
            if constexpr (counting == Counting::On)
                compaction.store(flight.spent, &to.spent[count]);
            count += compaction.count();
        };
        if (!hn::AllFalse(IntTag(), hit))
            keep(hit, hits, hits.count);
        keep(on, rays, kept);
    }
}

/// Marches all rays to their ends. At the start each has made one query.
template <class Scene, Counting counting, class Lost>
HWY_INLINE void march(Rays& rays, const Points& eye, Rays& hits, const Lost& lost)
{
    constexpr int steps_at_once = 4;
    constexpr std::size_t group = 4;
    // The hundredth query ends in a miss whatever it says: it is not made.
    for (int made = 1; rays.count != 0 && made < max_steps - 1;) {
        const int steps = std::min(steps_at_once, max_steps - 1 - made);
        hn::StoreU(all(max_distance.raw() + 1), IntTag(), &rays.t[rays.count]); // filled up: lost
        std::size_t kept = 0;
        std::size_t at = 0;
        for (; at + group * lanes <= rays.count; at += group * lanes)
            advance<Scene, counting, group>(rays, at, kept, steps, eye, hits, lost);
        for (; at < rays.count; at += lanes)
            advance<Scene, counting, 1>(rays, at, kept, steps, eye, hits, lost);
        rays.count = kept;
        made += steps;
    }
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
