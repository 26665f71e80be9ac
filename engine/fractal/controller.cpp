// SPDX-License-Identifier: MIT
#include "engine/fractal/controller.hpp"

#include "engine/fractal/checkerboard.hpp"
#include "engine/fractal/ray_marcher.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace raymarch::engine::fractal
{
namespace
{

constexpr unsigned overhead = 20; ///< two clocks of hand-over, eighteen of the ray generator
constexpr unsigned most_units = 255;

/// When the rotating index next meets each unit that is idle by then: one bit a clock, in a ring.
/// Two units never share a clock, and no visit lies further ahead than the longest pixel and one
/// turn of the index.
class Visits
{
  public:
    /// At first every unit is idle, and unit 0 is met at clock 0.
    explicit Visits(unsigned units) noexcept
    {
        for (unsigned unit = 0; unit < units; ++unit)
            add(unit);
    }

    void add(std::uint64_t clock) noexcept { word_of(clock) |= bit_of(clock); }

    /// Takes the visit at `clock` away; whether there was one.
    bool take(std::uint64_t clock) noexcept
    {
        const bool there = (word_of(clock) & bit_of(clock)) != 0;
        word_of(clock) &= ~bit_of(clock);
        return there;
    }

    /// The first at `clock` or later. There always is one.
    [[nodiscard]] std::uint64_t next(std::uint64_t clock) noexcept
    {
        std::uint64_t later = word_of(clock) >> clock % 64;
        while (later == 0) {
            clock += 64 - clock % 64;
            later = word_of(clock);
        }
        return clock + static_cast<unsigned>(std::countr_zero(later));
    }

  private:
    static constexpr std::uint64_t bit_of(std::uint64_t clock) noexcept
    {
        return std::uint64_t{1} << clock % 64;
    }
    std::uint64_t& word_of(std::uint64_t clock) noexcept
    {
        return ring_[static_cast<std::size_t>(clock / 64 % ring_.size())];
    }

    std::array<std::uint64_t, 8> ring_{};
};

} // namespace

std::uint64_t frame_cycles(const Frame& frame, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept
{
    units = std::clamp(units, 1U, most_units);
    const unsigned a_query = scene_row(frame.scene).latency + 1U;
    Visits visits(units);
    std::uint64_t clock = 0;
    std::uint64_t all_idle = 0;
    for (unsigned y = 0; y < last_row.size.height; ++y) {
        const auto row = costs.subspan(std::size_t{y} * last_row.size.width, last_row.size.width);
        for (unsigned x = 0; x < last_row.size.width; ++x) {
            clock = visits.next(clock);
            visits.take(clock);
            unsigned turns = 1; // of the index, until it meets this unit idle again
            if (!frame.checker || in_half(last_row.frame, x, y)) {
                const unsigned queries = std::min<std::uint32_t>(row[x].steps, max_depth + 1U);
                const unsigned busy = overhead + queries * a_query;
                all_idle = std::max(all_idle, clock + busy);
                turns = (busy + units - 1) / units;
            }
            visits.add(clock + std::uint64_t{turns} * units);
            ++clock;
        }
        // The clock of the row change hands nothing out: a unit that is met then waits a turn.
        if (visits.take(clock))
            visits.add(clock + units);
        ++clock;
    }
    return std::max(all_idle, clock) + 1; // and one that starts the next frame
}

} // namespace raymarch::engine::fractal
