// SPDX-License-Identifier: MIT
/// @file
/// The names that all kernels share, which are Highway's: tags, vectors, masks. A file whose name
/// ends in -inl.hpp is compiled once for each instruction set; its guard is a toggle, as those of
/// Highway's own headers are.
#if defined(RAYMARCH_ENGINE_FAST_VECTORS) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FAST_VECTORS
#undef RAYMARCH_ENGINE_FAST_VECTORS
#else
#define RAYMARCH_ENGINE_FAST_VECTORS
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fast::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
using hn::Mask;
using hn::Vec;

// A tag names the type of the lanes.
using U8 = hn::ScalableTag<std::uint8_t>;
using I16 = hn::ScalableTag<std::int16_t>;
using U16 = hn::ScalableTag<std::uint16_t>;
using I32 = hn::ScalableTag<std::int32_t>;
using U32 = hn::ScalableTag<std::uint32_t>;
using I64 = hn::ScalableTag<std::int64_t>;
using U64 = hn::ScalableTag<std::uint64_t>;
using F32 = hn::ScalableTag<float>;
#if HWY_HAVE_FLOAT64
using F64 = hn::ScalableTag<double>;
#endif

/// The number of lanes of a vector.
template <class D>
inline constexpr std::size_t lanes = hn::MaxLanes(D());

/// Sets every lane to the number, converted to the lanes' type as static_cast does it.
template <class D, typename Number>
HWY_INLINE Vec<D> Set(Number number)
{
    return hn::Set(D(), static_cast<hn::TFromD<D>>(number));
}

} // namespace raymarch::engine::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
