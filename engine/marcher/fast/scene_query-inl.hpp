// SPDX-License-Identifier: MIT
/// @file
/// The scene query stage on vectors. Each scene is split in two: `term` of one coordinate, and
/// `combine` of three terms to a distance. A normal's four taps share their six terms.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_SCENE_QUERY) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_SCENE_QUERY
#undef RAYMARCH_ENGINE_MARCHER_FAST_SCENE_QUERY
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_SCENE_QUERY
#endif

#include "engine/marcher/fast/inverse_sqrt-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// With Squares::Small: at points less than 4 units from the middle.
template <Squares squares>
struct SphereOf
{
    using Near = SphereOf<Squares::Small>; ///< the same scene where its surface is
    using Term = Wide;
    static constexpr bool far = true; ///< a distance may be as large as the world
    // How many vectors are marched together, and how many steps between two compactions: as
    // measured. A step of the sphere is long enough to fill the processor with two.
    static constexpr std::size_t group = 2;
    static constexpr int steps_at_once = 3;

    static HWY_INLINE Term term(Vec<I32> c) { return square(c); }
    static HWY_INLINE Vec<I32> combine(const Term& x, const Term& y, const Term& z)
    {
        return length<squares>(add(add(x, y), z)) - Set<I32>(ratio(1, 1).raw());
    }
};

struct Cube
{
    using Near = Cube;
    using Term = Vec<I32>;
    static constexpr bool far = true;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 5;

    static HWY_INLINE Term term(Vec<I32> c) { return hn::Abs(c); }
    static HWY_INLINE Vec<I32> combine(Term x, Term y, Term z)
    {
        return hn::Max(hn::Max(x, y), z) - Set<I32>(ratio(1, 2).raw());
    }
};

/// How far `c` is from the nearest multiple of a power of two, times 2^shift: the shift drops the
/// cell's number and makes the rest signed.
template <int shift>
HWY_INLINE Vec<U32> from_nearest(Vec<I32> c)
{
    return hn::BitCast(U32(),
                       hn::Abs(hn::ShiftLeft<shift>(c))); // up to 2^31, which only unsigned holds
}

struct InfiniteCube
{
    using Near = InfiniteCube;
    using Term = Vec<U32>; ///< Q0.32
    static constexpr bool far = false;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    static HWY_INLINE Term term(Vec<I32> c) { return from_nearest<8>(c); }
    static HWY_INLINE Vec<I32> combine(Term x, Term y, Term z)
    {
        return hn::BitCast(I32(), hn::ShiftRight<8>(hn::Max(hn::Max(x, y), z))) -
               Set<I32>(ratio(1, 4).raw());
    }
};

struct Tunnel
{
    using Near = Tunnel;
    /// One a generation: the shift that makes 32 bits of its cell, and what the middle of a cell
    /// is from a bar. Measured from a multiple of the cell in place of its middle, so that the
    /// largest distance is where the scene's is least.
    template <int shift, std::int32_t bar>
    struct Generation
    {
        static HWY_INLINE Vec<I32> distance(Vec<U32> x, Vec<U32> y, Vec<U32> z)
        {
            const Vec<U32> median = hn::Max(hn::Min(x, y), hn::Min(hn::Max(x, y), z));
            return Set<I32>((std::int32_t{1} << (31 - shift)) - bar) -
                   hn::BitCast(I32(), hn::ShiftRight<shift>(median));
        }
    };
    using Cell2 = Generation<7, ratio(45, 100).raw()>;
    using Cell1 = Generation<8, ratio(28'333, 100'000).raw()>;
    using CellHalf = Generation<9, ratio(18'167, 100'000).raw()>;
    using CellEighth = Generation<11, ratio(5, 100).raw()>;

    struct Term
    {
        Vec<U32> cell2;
        Vec<U32> cell1;
        Vec<U32> cell_half;
        Vec<U32> cell_eighth;
    };
    static constexpr bool far = false;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    static HWY_INLINE Term term(Vec<I32> c)
    {
        return {from_nearest<7>(c), from_nearest<8>(c), from_nearest<9>(c), from_nearest<11>(c)};
    }
    static HWY_INLINE Vec<I32> combine(const Term& x, const Term& y, const Term& z)
    {
        return hn::Max(hn::Max(Cell2::distance(x.cell2, y.cell2, z.cell2),
                               Cell1::distance(x.cell1, y.cell1, z.cell1)),
                       hn::Max(CellHalf::distance(x.cell_half, y.cell_half, z.cell_half),
                               CellEighth::distance(x.cell_eighth, y.cell_eighth, z.cell_eighth)));
    }
};

template <class Scene>
HWY_INLINE Vec<I32> distance(const Points& p)
{
    return Scene::combine(Scene::term(p.x), Scene::term(p.y), Scene::term(p.z));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
