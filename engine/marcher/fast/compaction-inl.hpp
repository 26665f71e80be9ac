// SPDX-License-Identifier: MIT
// The chosen lanes of several vectors moved to the front, all in the same way. Included by
// kernel.cpp alone, once for each instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

/// An order of the lanes: the chosen ones first, then the others.
class Compaction
{
  public:
    HWY_INLINE explicit Compaction(Chosen chosen)
    {
#if HWY_TARGET == HWY_AVX3
        const __mmask16 first = chosen.raw;
        const auto others = static_cast<__mmask16>(~first);
        count_ = static_cast<std::size_t>(std::popcount(static_cast<std::uint16_t>(first)));
        const __m512i numbers = hn::Iota(IntTag(), 0).raw;
        order_ = hn::IndicesFromVec(
            IntTag(), Ints{_mm512_mask_expand_epi32(_mm512_maskz_compress_epi32(first, numbers),
                                                    static_cast<__mmask16>(0xFFFFU << count_),
                                                    _mm512_maskz_compress_epi32(others, numbers))});
#else
        // hn::Compress would look this up again for each vector, in a table that gcc 12 copies to
        // the stack each time.
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(IntTag(), chosen, bits);
        count_ = static_cast<std::size_t>(std::popcount(bits[0]));
        const hn::Rebind<std::uint8_t, IntTag> bytes;
        const std::uint8_t* const row = lane_orders<lanes>[bits[0]].data();
        order_ = hn::IndicesFromVec(IntTag(), hn::PromoteTo(IntTag(), hn::LoadU(bytes, row)));
#endif
    }

    /// How many are chosen.
    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        return count_;
    }

    [[nodiscard]] HWY_INLINE Ints operator()(Ints v) const
    {
        return hn::TableLookupLanes(v, order_);
    }

  private:
    decltype(hn::IndicesFromVec(IntTag(), Ints())) order_;
    std::size_t count_;
};

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
