// SPDX-License-Identifier: MIT
/// @file
/// The ray generator stage on vectors: a row's directions.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_RAY_GENERATOR) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_RAY_GENERATOR
#undef RAYMARCH_ENGINE_MARCHER_FAST_RAY_GENERATOR
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_RAY_GENERATOR
#endif

#include "engine/marcher/fast/inverse_sqrt-inl.hpp"
#include "engine/marcher/frame.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// The directions before they are normalised, for `lanes` pixels side by side at a time: they are
/// linear in x, so the next ones are as far away as the last ones were.
class RowOfDirections
{
  public:
    /// From pixel (x, y) on, every `step`-th.
    HWY_INLINE RowOfDirections(const Frame& frame, PictureSize size, int x, int y, int step)
    {
        // Beyond the row sums may wrap; in it they do not (docs/engine.md, 3).
        const auto u = static_cast<std::uint32_t>(2 * x + 1 - size.width);
        const auto v = static_cast<std::uint32_t>(size.height - 1 - 2 * y);
        const auto stride = static_cast<std::uint32_t>(2 * step);
        const auto start = [&](Vec<I32>& next, Vec<I32>& to_next, std::int32_t right,
                               std::int32_t up, std::int32_t forward) HWY_ATTR {
            const auto first = u * static_cast<std::uint32_t>(right) +
                               v * static_cast<std::uint32_t>(up) -
                               size.height * static_cast<std::uint32_t>(forward);
            const std::uint32_t slope = stride * static_cast<std::uint32_t>(right);
            next = hn::BitCast(I32(), Set<U32>(first) + hn::Iota(U32(), 0) * Set<U32>(slope));
            to_next = hn::BitCast(I32(), Set<U32>(slope * static_cast<std::uint32_t>(lanes<I32>)));
        };
        start(next_.x, stride_.x, frame.right.x, frame.up.x, frame.forward.x);
        start(next_.y, stride_.y, frame.right.y, frame.up.y, frame.forward.y);
        start(next_.z, stride_.z, frame.right.z, frame.up.z, frame.forward.z);
    }

    /// Unit directions of the next pixels. Lanes beyond the row may be anything.
    HWY_INLINE Points next()
    {
        const Points direction = normalise<Squares::Any>(next_);
        next_ = add(next_, stride_);
        return direction;
    }

  private:
    Points next_;
    Points stride_;
};

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
