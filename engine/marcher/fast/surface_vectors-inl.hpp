// SPDX-License-Identifier: MIT
/// @file
/// The surface vectors stage on vectors.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_SURFACE_VECTORS) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_SURFACE_VECTORS
#undef RAYMARCH_ENGINE_MARCHER_FAST_SURFACE_VECTORS
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_SURFACE_VECTORS
#endif

#include "engine/marcher/fast/inverse_sqrt-inl.hpp"
#include "engine/marcher/surface_vectors.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// The unit normals, by the four taps of the model: (+--), (--+), (-+-), (+++). Points that are no
/// surface points may have any. A distance changes by at most 2h between two taps (the sphere's by
/// a few raws more), so that no component of their sum is above 2^20 and its square not above 2^42.
template <class Scene>
HWY_INLINE Points surface_normal(const Points& p)
{
    using Term = typename Scene::Term;
    const Vec<I32> h = Set<I32>(normal_step.raw());
    const Term x_up = Scene::term(p.x + h);
    const Term x_down = Scene::term(p.x - h);
    const Term y_up = Scene::term(p.y + h);
    const Term y_down = Scene::term(p.y - h);
    const Term z_up = Scene::term(p.z + h);
    const Term z_down = Scene::term(p.z - h);
    const Vec<I32> right = Scene::combine(x_up, y_down, z_down);
    const Vec<I32> back = Scene::combine(x_down, y_down, z_up);
    const Vec<I32> above = Scene::combine(x_down, y_up, z_down);
    const Vec<I32> corner = Scene::combine(x_up, y_up, z_up);
    return normalise<Squares::Small>({(corner + right) - (back + above),
                                      (corner + above) - (right + back),
                                      (corner + back) - (right + above)});
}

HWY_INLINE Points light_direction(const Points& p, const Points& light)
{
    return normalise<Squares::Any>(subtract(light, p));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
