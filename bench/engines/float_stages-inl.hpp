// SPDX-License-Identifier: MIT
// The marcher's stages on vectors of float, as fast as they come. Included by float_simd.cpp alone,
// once for each instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

using FloatTag = hn::ScalableTag<float>;
using Floats = hn::Vec<FloatTag>;

struct FloatPoints
{
    Floats x;
    Floats y;
    Floats z;
};

HWY_INLINE Floats all(float value)
{
    return hn::Set(FloatTag(), value);
}

HWY_INLINE FloatPoints all_units(const Point& p)
{
    constexpr float unit = 1.0F / (1 << 24);
    return {all(unit * static_cast<float>(p.x.raw())), all(unit * static_cast<float>(p.y.raw())),
            all(unit * static_cast<float>(p.z.raw()))};
}

HWY_INLINE Floats dot(const FloatPoints& a, const FloatPoints& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}

/// 1 / sqrt(s), by the estimate and one step of Newton's.
HWY_INLINE Floats inverse_root(Floats s)
{
    const Floats guess = hn::ApproximateReciprocalSqrt(s);
    return guess * hn::NegMulAdd(s * all(0.5F), guess * guess, all(1.5F));
}

HWY_INLINE FloatPoints normalise(const FloatPoints& v)
{
    const Floats factor = inverse_root(dot(v, v));
    return {v.x * factor, v.y * factor, v.z * factor};
}

struct FloatSphere
{
    using Term = Floats;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 3;

    static HWY_INLINE Term term(Floats c) { return c * c; }
    static HWY_INLINE Floats combine(Term x, Term y, Term z)
    {
        const Floats s = x + y + z;
        return hn::MulSub(s, inverse_root(s), all(1.0F));
    }
};

struct FloatCube
{
    using Term = Floats;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 5;

    static HWY_INLINE Term term(Floats c) { return hn::Abs(c); }
    static HWY_INLINE Floats combine(Term x, Term y, Term z)
    {
        return hn::Max(hn::Max(x, y), z) - all(0.5F);
    }
};

/// How far c is from the nearest multiple of a cell, in cells.
HWY_INLINE Floats from_nearest(Floats c, float cells_a_unit)
{
    const Floats cells = c * all(cells_a_unit);
    return hn::Abs(cells - hn::Round(cells));
}

struct FloatInfiniteCube
{
    using Term = Floats;
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    static HWY_INLINE Term term(Floats c) { return hn::Abs(c - hn::Round(c)); }
    static HWY_INLINE Floats combine(Term x, Term y, Term z)
    {
        return hn::Max(hn::Max(x, y), z) - all(0.25F);
    }
};

struct FloatTunnel
{
    static constexpr std::size_t group = 4;
    static constexpr int steps_at_once = 6;

    struct Term
    {
        Floats cell2, cell1, cell_half, cell_eighth;
    };
    static HWY_INLINE Term term(Floats c)
    {
        return {from_nearest(c, 0.5F), from_nearest(c, 1.0F), from_nearest(c, 2.0F),
                from_nearest(c, 8.0F)};
    }
    /// The middle of a cell is its half from a multiple.
    static HWY_INLINE Floats generation(Floats x, Floats y, Floats z, float cell, float bar)
    {
        const Floats median = hn::Max(hn::Min(x, y), hn::Min(hn::Max(x, y), z));
        return hn::NegMulAdd(median, all(cell), all(cell / 2 - bar));
    }
    static HWY_INLINE Floats combine(const Term& x, const Term& y, const Term& z)
    {
        return hn::Max(
            hn::Max(generation(x.cell2, y.cell2, z.cell2, 2.0F, 0.45F),
                    generation(x.cell1, y.cell1, z.cell1, 1.0F, 0.28333F)),
            hn::Max(generation(x.cell_half, y.cell_half, z.cell_half, 0.5F, 0.18167F),
                    generation(x.cell_eighth, y.cell_eighth, z.cell_eighth, 0.125F, 0.05F)));
    }
};

template <class Scene>
HWY_INLINE Floats distance(const FloatPoints& p)
{
    return Scene::combine(Scene::term(p.x), Scene::term(p.y), Scene::term(p.z));
}

template <class Scene>
HWY_INLINE FloatPoints surface_normal(const FloatPoints& p)
{
    using Term = typename Scene::Term;
    const Floats h = all(0.01F);
    const Term x_up = Scene::term(p.x + h);
    const Term x_down = Scene::term(p.x - h);
    const Term y_up = Scene::term(p.y + h);
    const Term y_down = Scene::term(p.y - h);
    const Term z_up = Scene::term(p.z + h);
    const Term z_down = Scene::term(p.z - h);
    const Floats right = Scene::combine(x_up, y_down, z_down);
    const Floats back = Scene::combine(x_down, y_down, z_up);
    const Floats above = Scene::combine(x_down, y_up, z_down);
    const Floats corner = Scene::combine(x_up, y_up, z_up);
    return normalise({(corner + right) - (back + above), (corner + above) - (right + back),
                      (corner + back) - (right + above)});
}

HWY_INLINE Words shade(const std::array<std::uint16_t, 3>& colour, const FloatPoints& normal,
                       const FloatPoints& light)
{
    const Floats none = hn::Zero(FloatTag());
    const Floats diffuse = hn::Max(dot(normal, light), none);
    const Floats sky = hn::Max(normal.y, none);
    const Floats brightness =
        hn::MulAdd(diffuse, all(0.75F), hn::MulAdd(sky, all(0.125F), all(0.125F)));
    const auto channel = [&](std::uint16_t c) HWY_ATTR {
        const Floats level = brightness * all(static_cast<float>(c) * 0.25F);
        return as_words(hn::ConvertTo(IntTag(), hn::Min(level, all(255.0F))));
    };
    return hn::Or(channel(colour[0]), hn::Or(hn::ShiftLeft<8>(channel(colour[1])),
                                             hn::ShiftLeft<16>(channel(colour[2]))));
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
