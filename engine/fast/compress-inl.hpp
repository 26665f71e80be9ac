// SPDX-License-Identifier: MIT
/// @file
/// Moves the lanes that a mask selects to the front of any number of vectors. Highway's Compress
/// would find the order of the lanes again for each vector, in a table that gcc 12 copies to the
/// stack each time. This file is compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_FAST_COMPRESS) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FAST_COMPRESS
#undef RAYMARCH_ENGINE_FAST_COMPRESS
#else
#define RAYMARCH_ENGINE_FAST_COMPRESS
#endif

#include "engine/fast/lane_orders.hpp"
#include "engine/fast/vectors-inl.hpp"

#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fast::HWY_NAMESPACE
{

/// D is I32 or U16.
template <class D>
class Compress;

template <>
class Compress<I32>
{
  public:
    HWY_INLINE explicit Compress(Mask<I32> wanted)
    {
#if HWY_TARGET == HWY_AVX3
        const __mmask16 first = wanted.raw;
        const auto others = static_cast<__mmask16>(~first);
        count_ = static_cast<std::size_t>(std::popcount(static_cast<std::uint16_t>(first)));
        const __m512i numbers = hn::Iota(I32(), 0).raw;
        order_ = hn::IndicesFromVec(I32(), Vec<I32>{_mm512_mask_expand_epi32(
                                               _mm512_maskz_compress_epi32(first, numbers),
                                               static_cast<__mmask16>(0xFFFFU << count_),
                                               _mm512_maskz_compress_epi32(others, numbers))});
#else
        static_assert(lanes<I32> <= 8);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(I32(), wanted, bits);
        count_ = static_cast<std::size_t>(std::popcount(bits[0]));
        const hn::Rebind<std::uint8_t, I32> bytes;
        order_ = hn::IndicesFromVec(
            I32(), hn::PromoteTo(I32(), hn::LoadU(bytes, lane_orders[bits[0]].data())));
#endif
    }

    /// How many lanes are wanted.
    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        return count_;
    }

    /// The wanted lanes first, then the others.
    [[nodiscard]] HWY_INLINE Vec<I32> operator()(Vec<I32> v) const
    {
        return hn::TableLookupLanes(v, order_);
    }

    /// Writes a whole vector, of which only the wanted lanes matter.
    HWY_INLINE void store(Vec<I32> v, std::int32_t* to) const
    {
        hn::StoreU((*this)(v), I32(), to);
    }

  private:
    decltype(hn::IndicesFromVec(I32(), Vec<I32>())) order_;
    std::size_t count_;
};

#if HWY_TARGET != HWY_SCALAR // it has no blocks of 16 bytes

/// Bytes are moved inside of blocks of 16: each block is stored where the one before it ended.
template <>
class Compress<U16>
{
  public:
    HWY_INLINE explicit Compress(Mask<U16> wanted)
    {
        std::array<std::uint8_t, (lanes<U16> + 63) / 64 * 8> bits{};
        hn::StoreMaskBits(U16(), wanted, bits.data());
        for (std::size_t i = 0; i < blocks; ++i) {
            counts_[i] = static_cast<std::size_t>(std::popcount(bits[i]));
            const auto order = hn::PromoteTo(
                Block(), hn::LoadU(hn::Rebind<std::uint8_t, Block>(), lane_orders[bits[i]].data()));
            // Lane n is made of the bytes 2n and 2n + 1.
            const auto bytes =
                hn::Add(hn::Mul(order, hn::Set(Block(), 0x0202)), hn::Set(Block(), 0x0100));
            hn::Store(bytes, Block(), orders_[i].data());
        }
    }

    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        std::size_t sum = 0;
        for (const std::size_t count : counts_)
            sum += count;
        return sum;
    }

    HWY_INLINE void store(Vec<U16> v, std::uint16_t* to) const
    {
        HWY_ALIGN std::array<std::uint16_t, lanes<U16>> from;
        hn::Store(v, U16(), from.data());
        for (std::size_t i = 0; i < blocks; ++i) {
            const auto block = hn::Load(Block(), &from[i * block_lanes]);
            const auto order = hn::Load(Block(), orders_[i].data());
            hn::StoreU(hn::TableLookupBytes(block, order), Block(), to);
            to += counts_[i];
        }
    }

  private:
    static constexpr std::size_t block_lanes = 8;
    static constexpr std::size_t blocks = lanes<U16> / block_lanes;
    using Block = hn::FixedTag<std::uint16_t, block_lanes>;

    HWY_ALIGN std::array<std::array<std::uint16_t, block_lanes>, blocks> orders_;
    std::array<std::size_t, blocks> counts_;
};

#endif

} // namespace raymarch::engine::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
