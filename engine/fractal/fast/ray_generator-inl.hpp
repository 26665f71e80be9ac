// SPDX-License-Identifier: MIT
/// @file
/// The stage of ray_generator.hpp in vectors: what the pixels of a row or a column share is
/// computed once.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_RAY_GENERATOR) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_RAY_GENERATOR
#undef RAYMARCH_ENGINE_FRACTAL_FAST_RAY_GENERATOR
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_RAY_GENERATOR
#endif

#include "engine/fractal/fast/inverse_sqrt-inl.hpp"
#include "engine/fractal/fast/lanes-inl.hpp"
#include "engine/fractal/ray_generator.hpp"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

/// Columns that are drawn together.
inline constexpr unsigned max_columns = 128;

/// Raised by spare_bits, so that the sum of a row's and a column's share wraps as a word does.
[[nodiscard]] inline std::int32_t raised(Number n) noexcept
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(n.raw()) << spare_bits);
}

/// Columns add this to a ray before it is normalised; they add nothing in y.
struct Columns
{
    HWY_ALIGN std::array<std::int32_t, max_columns> x;
    HWY_ALIGN std::array<std::int32_t, max_columns> z;
};

/// A row adds this, which includes the forward vector.
struct Row
{
    Vec3<std::int32_t> ray;
    std::int32_t y_squared; ///< a word
};

[[nodiscard]] inline Row row_at(const Camera& camera, const Plane& plane, std::uint16_t y) noexcept
{
    const Number up = along(plane.top, plane.step, y);
    const Point ray = map(camera.up, [&](Number c) { return multiply(c, up); }) + camera.forward;
    return {map(ray, raised), multiply(ray.y, ray.y).raw()};
}

/// The columns first, first + step, ….
inline void fill(Columns& columns, const Camera& camera, const Plane& plane, unsigned first,
                 unsigned step) noexcept
{
    for (unsigned i = 0; i < max_columns; ++i) {
        const auto x = static_cast<std::uint16_t>(first + i * step);
        const Number right = along(plane.left, plane.step, x);
        columns.x[i] = raised(multiply(camera.right.x, right));
        columns.z[i] = raised(multiply(camera.right.z, right));
    }
}

/// Directions of as many rays as there are lanes. Beyond `far` a component counts modulo 2^22.
struct Directions
{
    Vec<I32> x;
    Vec<I32> y;
    Vec<I32> z;
};

/// The components of the directions that rays are marched with here are below it: 1.75. A word is a
/// direction of length 1, unless the squared length of the ray wrapped, or is too small to be
/// normalised.
inline constexpr std::int32_t longest = 7 << 14;

/// The directions at columns i, i + 1, … of a row; `bounded` becomes false where a component is not
/// below `longest`, or a ray too short for the inverse square root: the rays are not to be used.
HWY_INLINE Directions directions(const Columns& columns, std::size_t i, const Row& row,
                                 bool& bounded)
{
    const I32 d;
    const Vec<I32> vx = hn::Add(hn::LoadU(d, &columns.x[i]), Set<I32>(row.ray.x));
    const Vec<I32> vy = Set<I32>(row.ray.y);
    const Vec<I32> vz = hn::Add(hn::LoadU(d, &columns.z[i]), Set<I32>(row.ray.z));

    constexpr int fraction = Number::fraction_bits;
    const auto square = [](Vec<I32> v) { // of at most 26 bits
        constexpr int drop = fraction + 2 * spare_bits - 32;
        return hn::BitCast(I32(), hn::ShiftRight<drop>(hn::BitCast(U32(), product<32>(v, v))));
    };
    const Vec<I32> sum = hn::Add(square(vx), hn::Add(Set<I32>(row.y_squared), square(vz)));
    const Vec<I32> radicand = hn::And(sum, Set<I32>((1 << Number::width) - 1));
    const Vec<I32> n = inverse_sqrt(radicand);

    const Directions to = {product<fraction + spare_bits>(vx, n),
                           hn::Neg(product<fraction + spare_bits>(vy, n)),
                           product<fraction + spare_bits>(vz, n)};
    const Vec<I32> largest = hn::Max(hn::Abs(to.x), hn::Max(hn::Abs(to.y), hn::Abs(to.z)));
    const auto fits =
        hn::And(hn::Gt(Set<I32>(longest), largest), hn::Gt(radicand, Set<I32>(least_radicand - 1)));
    bounded = bounded && hn::AllTrue(d, fits);
    return to;
}

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
