// SPDX-License-Identifier: MIT
/// @file
/// The marcher's stages on vectors of float, as fast as they come.
#if defined(RAYMARCH_BENCH_ENGINES_FLOAT_STAGES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_BENCH_ENGINES_FLOAT_STAGES
#undef RAYMARCH_BENCH_ENGINES_FLOAT_STAGES
#else
#define RAYMARCH_BENCH_ENGINES_FLOAT_STAGES
#endif

#include "engine/marcher/fast/lanes-inl.hpp"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

struct FloatPoints
{
    Vec<F32> x;
    Vec<F32> y;
    Vec<F32> z;
};

HWY_INLINE FloatPoints all_units(const Point& p)
{
    constexpr float unit = 1.0F / (1 << 24);
    return {Set<F32>(unit * static_cast<float>(p.x.raw())),
            Set<F32>(unit * static_cast<float>(p.y.raw())),
            Set<F32>(unit * static_cast<float>(p.z.raw()))};
}

HWY_INLINE Vec<F32> dot(const FloatPoints& a, const FloatPoints& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}

/// 1 / sqrt(s), by the estimate and one step of Newton's.
HWY_INLINE Vec<F32> inverse_root(Vec<F32> s)
{
    const Vec<F32> guess = hn::ApproximateReciprocalSqrt(s);
    return guess * hn::NegMulAdd(s * Set<F32>(0.5F), guess * guess, Set<F32>(1.5F));
}

HWY_INLINE FloatPoints normalise(const FloatPoints& v)
{
    const Vec<F32> factor = inverse_root(dot(v, v));
    return {v.x * factor, v.y * factor, v.z * factor};
}

struct FloatSphere
{
    using Term = Vec<F32>;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 3;

    static HWY_INLINE Term term(Vec<F32> c) { return c * c; }
    static HWY_INLINE Vec<F32> combine(Term x, Term y, Term z)
    {
        const Vec<F32> s = x + y + z;
        return hn::MulSub(s, inverse_root(s), Set<F32>(1.0F));
    }
};

struct FloatCube
{
    using Term = Vec<F32>;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 5;

    static HWY_INLINE Term term(Vec<F32> c) { return hn::Abs(c); }
    static HWY_INLINE Vec<F32> combine(Term x, Term y, Term z)
    {
        return hn::Max(hn::Max(x, y), z) - Set<F32>(0.5F);
    }
};

/// How far c is from the nearest multiple of a cell, in cells.
HWY_INLINE Vec<F32> from_nearest(Vec<F32> c, float cells_a_unit)
{
    const Vec<F32> cells = c * Set<F32>(cells_a_unit);
    return hn::Abs(cells - hn::Round(cells));
}

struct FloatInfiniteCube
{
    using Term = Vec<F32>;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    static HWY_INLINE Term term(Vec<F32> c) { return hn::Abs(c - hn::Round(c)); }
    static HWY_INLINE Vec<F32> combine(Term x, Term y, Term z)
    {
        return hn::Max(hn::Max(x, y), z) - Set<F32>(0.25F);
    }
};

struct FloatTunnel
{
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    struct Term
    {
        Vec<F32> cell2, cell1, cell_half, cell_eighth;
    };
    static HWY_INLINE Term term(Vec<F32> c)
    {
        return {from_nearest(c, 0.5F), from_nearest(c, 1.0F), from_nearest(c, 2.0F),
                from_nearest(c, 8.0F)};
    }
    /// The middle of a cell is its half from a multiple.
    static HWY_INLINE Vec<F32> generation(Vec<F32> x, Vec<F32> y, Vec<F32> z, float cell, float bar)
    {
        const Vec<F32> median = hn::Max(hn::Min(x, y), hn::Min(hn::Max(x, y), z));
        return hn::NegMulAdd(median, Set<F32>(cell), Set<F32>(cell / 2 - bar));
    }
    static HWY_INLINE Vec<F32> combine(const Term& x, const Term& y, const Term& z)
    {
        return hn::Max(
            hn::Max(generation(x.cell2, y.cell2, z.cell2, 2.0F, 0.45F),
                    generation(x.cell1, y.cell1, z.cell1, 1.0F, 0.28333F)),
            hn::Max(generation(x.cell_half, y.cell_half, z.cell_half, 0.5F, 0.18167F),
                    generation(x.cell_eighth, y.cell_eighth, z.cell_eighth, 0.125F, 0.05F)));
    }
};

template <class Scene>
HWY_INLINE Vec<F32> distance(const FloatPoints& p)
{
    return Scene::combine(Scene::term(p.x), Scene::term(p.y), Scene::term(p.z));
}

template <class Scene>
HWY_INLINE FloatPoints surface_normal(const FloatPoints& p)
{
    using Term = typename Scene::Term;
    const Vec<F32> h = Set<F32>(0.01F);
    const Term x_up = Scene::term(p.x + h);
    const Term x_down = Scene::term(p.x - h);
    const Term y_up = Scene::term(p.y + h);
    const Term y_down = Scene::term(p.y - h);
    const Term z_up = Scene::term(p.z + h);
    const Term z_down = Scene::term(p.z - h);
    const Vec<F32> right = Scene::combine(x_up, y_down, z_down);
    const Vec<F32> back = Scene::combine(x_down, y_down, z_up);
    const Vec<F32> above = Scene::combine(x_down, y_up, z_down);
    const Vec<F32> corner = Scene::combine(x_up, y_up, z_up);
    return normalise({(corner + right) - (back + above), (corner + above) - (right + back),
                      (corner + back) - (right + above)});
}

HWY_INLINE Vec<U32> shade(const std::array<std::uint16_t, 3>& colour, const FloatPoints& normal,
                          const FloatPoints& light)
{
    const Vec<F32> none = hn::Zero(F32());
    const Vec<F32> diffuse = hn::Max(dot(normal, light), none);
    const Vec<F32> sky = hn::Max(normal.y, none);
    const Vec<F32> brightness =
        hn::MulAdd(diffuse, Set<F32>(0.75F), hn::MulAdd(sky, Set<F32>(0.125F), Set<F32>(0.125F)));
    const auto channel = [&](std::uint16_t c) HWY_ATTR {
        const Vec<F32> level = brightness * Set<F32>(static_cast<float>(c) * 0.25F);
        return hn::BitCast(U32(), hn::ConvertTo(I32(), hn::Min(level, Set<F32>(255.0F))));
    };
    return hn::Or(channel(colour[0]), hn::Or(hn::ShiftLeft<8>(channel(colour[1])),
                                             hn::ShiftLeft<16>(channel(colour[2]))));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
