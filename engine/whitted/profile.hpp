// SPDX-License-Identifier: MIT
/// @file
/// TABLE: what the original machine does wrong, and which profile still does it. A profile is a
/// set of defects; everything that no defect names is common to all of them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace raymarch::engine::whitted
{

/// R1 to R10 of docs/engine/whitted.md, in that order.
enum class Defect : std::uint8_t {
    MovingOrigin,
    StaleSphere,
    UnsignedDistance,
    WrappedHighlight,
    ShadowDistance,
    UnsignedPixel,
    UnsignedEye,
    LastHitIsLight,
    ExtraPixels,
    UnshadedInside,
};

enum class Profile : std::uint8_t { Measured, Repaired };

struct DefectRow
{
    Defect defect;
    std::string_view what;
    bool measured;
    bool repaired;
};

// clang-format off
// One row a defect.
inline constexpr std::array defects = {
    DefectRow{Defect::MovingOrigin, "a reflected ray is tested from the last point kept", true, false},
    DefectRow{Defect::StaleSphere, "the sphere last hit, or sphere 0, blocks the light", true, false},
    DefectRow{Defect::UnsignedDistance, "a negative distance is a far one", true, false},
    DefectRow{Defect::WrappedHighlight, "the light's cosine wraps at 1", true, false},
    DefectRow{Defect::ShadowDistance, "nearer than the light is told by squared lengths", true, false},
    DefectRow{Defect::UnsignedPixel, "pixels left of 0 or above it are far away; row 0 is black", true, false},
    DefectRow{Defect::UnsignedEye, "an eye at z >= 0 breaks the view", true, false},
    DefectRow{Defect::LastHitIsLight, "the light flag is that of the last sphere hit", true, false},
    DefectRow{Defect::ExtraPixels, "one more column and one more row are drawn", true, false},
    DefectRow{Defect::UnshadedInside, "an eye inside a sphere sees one before it unshaded", false, false},
};
// clang-format on

class Defects
{
  public:
    constexpr explicit Defects(Profile profile) noexcept
    {
        for (const DefectRow& row : defects)
            if (profile == Profile::Measured ? row.measured : row.repaired)
                bits_ |= bit(row.defect);
    }
    [[nodiscard]] constexpr bool has(Defect defect) const noexcept
    {
        return (bits_ & bit(defect)) != 0;
    }
    /// For tests: the same set with one defect more.
    [[nodiscard]] constexpr Defects with(Defect defect) const noexcept
    {
        Defects both = *this;
        both.bits_ |= bit(defect);
        return both;
    }
    bool operator==(const Defects&) const = default;

  private:
    static constexpr std::uint16_t bit(Defect defect) noexcept
    {
        return static_cast<std::uint16_t>(1U << static_cast<unsigned>(defect));
    }
    std::uint16_t bits_ = 0;
};

} // namespace raymarch::engine::whitted
