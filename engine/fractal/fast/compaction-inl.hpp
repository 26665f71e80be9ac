// SPDX-License-Identifier: MIT
/// @file
/// Some lanes of vectors, stored without the gaps between them. Highway's CompressStore of version
/// 1.0 does the same, but where the instruction set has no such instruction gcc copies its tables
/// to the stack each time. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_COMPACTION) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_COMPACTION
#undef RAYMARCH_ENGINE_FRACTAL_FAST_COMPACTION
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_COMPACTION
#endif

#include "engine/fractal/fast/compaction_table.hpp"
#include "engine/fractal/fast/lanes-inl.hpp"

#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::HWY_NAMESPACE
{

/// Which lanes, of 16 or 32 bits: the same for all fields of rays.
class Compaction
{
  public:
    /// The lanes of `chosen` that are -1; the others are 0.
    template <class Vec>
    explicit HWY_INLINE Compaction(Vec chosen)
    {
        const Narrow d;
        // A lane of 32 bits is two neighbours of 16.
        hn::StoreMaskBits(d, hn::MaskFromVec(hn::BitCast(d, chosen)), bits_.data());
    }

    [[nodiscard]] std::size_t bytes() const noexcept
    {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < blocks; ++i)
            sum += sizeof(std::uint16_t) * static_cast<std::size_t>(std::popcount(bits_[i]));
        return sum;
    }

    /// Writes as much as a whole vector holds.
    template <class D>
    HWY_INLINE void store(hn::Vec<D> v, D d, hn::TFromD<D>* to) const
    {
        const hn::FixedTag<std::uint8_t, block_bytes> block;
        HWY_ALIGN std::array<std::uint8_t, blocks * block_bytes> bytes;
        hn::Store(hn::BitCast(hn::Repartition<std::uint8_t, D>(), v),
                  hn::Repartition<std::uint8_t, D>(), bytes.data());
        static_cast<void>(d);
        auto* out = reinterpret_cast<std::uint8_t*>(to);
        for (std::size_t i = 0; i < blocks; ++i) {
            const auto order = hn::Load(block, compaction_table[bits_[i]].data());
            hn::StoreU(hn::TableLookupBytes(hn::Load(block, &bytes[i * block_bytes]), order), block,
                       out);
            out += sizeof(std::uint16_t) * static_cast<std::size_t>(std::popcount(bits_[i]));
        }
    }

  private:
    static constexpr std::size_t block_bytes = 16;
    static constexpr std::size_t blocks = HWY_LANES(std::uint8_t) / block_bytes;

    std::array<std::uint8_t, blocks> bits_;
};

} // namespace raymarch::engine::fractal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
