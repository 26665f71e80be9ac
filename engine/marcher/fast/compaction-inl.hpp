// SPDX-License-Identifier: MIT
// The chosen lanes of several vectors moved together, side by side. Included by kernel.cpp alone,
// once for each instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

#if HWY_TARGET == HWY_AVX3

class Compaction
{
  public:
    HWY_INLINE explicit Compaction(Chosen chosen) : chosen_(chosen) {}

    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        return hn::CountTrue(IntTag(), chosen_);
    }

    /// Writes a whole vector, of which the first count() lanes are the chosen ones.
    HWY_INLINE void store(Ints v, std::int32_t* to) const
    {
        hn::StoreU(hn::Compress(v, chosen_), IntTag(), to);
    }

  private:
    Chosen chosen_;
};

#else

/// By a table of permutations: hn::Compress looks its own one up again for each vector, and gcc 12
/// copies that table to the stack each time.
class Compaction
{
  public:
    HWY_INLINE explicit Compaction(Chosen chosen)
    {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(IntTag(), chosen, bits);
        const hn::Rebind<std::uint8_t, IntTag> bytes;
        order_ = hn::IndicesFromVec(
            IntTag(), hn::PromoteTo(IntTag(), hn::LoadU(bytes, orders[bits[0]].data())));
        count_ = static_cast<std::size_t>(std::popcount(bits[0]));
    }

    [[nodiscard]] HWY_INLINE std::size_t count() const { return count_; }

    HWY_INLINE void store(Ints v, std::int32_t* to) const
    {
        hn::StoreU(hn::TableLookupLanes(v, order_), IntTag(), to);
    }

  private:
    decltype(hn::IndicesFromVec(IntTag(), Ints())) order_;
    std::size_t count_;
};

#endif

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
