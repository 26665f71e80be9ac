// SPDX-License-Identifier: MIT
/// @file
/// iteration.hpp and ray_marcher.hpp for many rays at once. Orbits end after different numbers of
/// iterations, and rays after different numbers of evaluations: each stage packs those that need
/// it into full vectors, and whatever ends makes room for the next.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_ORBITS) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_ORBITS
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_ORBITS
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_ORBITS
#endif

#include "engine/mandelbulb/fast/cordic-inl.hpp"
#include "engine/mandelbulb/fast/distance-inl.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

inline constexpr std::size_t slots = 64;                 ///< rays under way
using Column = std::array<std::uint64_t, slots + batch>; ///< one value a slot, and some beyond
using Axes = std::array<Column, 3>;

/// Some of the slots, padded to whole batches by a slot beyond them all.
class Selection
{
  public:
    void add_if(bool wanted, std::size_t slot) noexcept
    {
        indices_[count_] = static_cast<std::int64_t>(slot);
        count_ += wanted ? 1 : 0;
    }
    void pad() noexcept
    {
        std::fill_n(indices_.begin() + static_cast<std::ptrdiff_t>(count_), batch,
                    static_cast<std::int64_t>(slots));
    }
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] std::size_t slot(std::size_t at) const noexcept
    {
        return static_cast<std::size_t>(indices_[at]);
    }

    [[nodiscard]] HWY_INLINE Batch gather(const Column& column, std::size_t at) const
    {
        Batch result;
        for (std::size_t j = 0; j < in_flight; ++j)
            result[j] = hn::GatherIndex(U64(), column.data(), vector(at, j));
        return result;
    }
    HWY_INLINE void scatter(const Batch& values, Column& column, std::size_t at) const
    {
        for (std::size_t j = 0; j < in_flight; ++j)
            hn::ScatterIndex(values[j], U64(), column.data(), vector(at, j));
    }

  private:
    [[nodiscard]] HWY_INLINE Vec<I64> vector(std::size_t at, std::size_t j) const
    {
        return hn::LoadU(I64(), indices_.data() + at + j * lanes<U64>);
    }

    std::array<std::int64_t, slots + batch> indices_; // NOLINT(*-member-init): up to count_
    std::size_t count_ = 0;
};

/// One ray and where it belongs.
struct Ray
{
    Direction direction;
    std::size_t pixel;
};

/// All rays share these numbers.
template <typename Format>
struct Course
{
    Arithmetic with;
    Limits limits;
    Point<Format> origin;
    typename Format::Coordinate first; ///< the distance at the origin: every ray's first evaluation
    typename Format::Coordinate epsilon;
};

/// Marches rays from their second evaluation on. `Rays` gives the next ray, or says that there is
/// none: bool next(Ray&); it takes how one ended: void finish(pixel, outcome, evaluations, index).
template <class Rays>
class Marcher
{
  public:
    using Format = Q57<Int128>;

    Marcher(const Course<Format>& course, Rays& rays)
        : course_(course)
        , cordic_(course.with.steps)
        , rays_(rays)
    {}

    void run()
    {
        while (count_ < slots && start(count_))
            ++count_;
        while (count_ > 0) {
            measure();
            Selection going;
            Selection ended;
            choose(going, ended);
            iterate(going);
            evaluate(ended);
        }
    }

  private:
    /// Radius and angles of all points.
    void measure()
    {
        for (std::size_t at = 0; at < count_; at += batch) {
            const PolarBatch flat = to_polar(cordic_, load(&w_[0][at]), load(&w_[1][at]));
            const PolarBatch space = to_polar(cordic_, load(&w_[2][at]), flat.magnitude);
            store(space.magnitude, &r_[at]);
            store(space.angle, &theta_[at]);
            store(flat.angle, &phi_[at]);
        }
    }

    void choose(Selection& going, Selection& ended) const
    {
        const std::int64_t radius = escape_radius<Format>(course_.with.power);
        const auto last = static_cast<std::uint64_t>(course_.with.iterations - 1);
        for (std::size_t slot = 0; slot < count_; ++slot) {
            const bool stops =
                (static_cast<std::int64_t>(r_[slot]) > radius) | (index_[slot] == last);
            going.add_if(!stops, slot);
            ended.add_if(stops, slot);
        }
        going.pad();
        ended.pad();
    }

    /// The rest of a core, where the orbit goes on.
    void iterate(const Selection& going)
    {
        const Arithmetic& with = course_.with;
        const Vec<U64> turns = Set<U64>(with.power);
        const auto turned = [&](Batch angle) {
            for (Vec<U64>& each : angle)
                each = multiply_low(each, turns);
            return angle;
        };
        for (std::size_t at = 0; at < going.count(); at += batch) {
            const PowersBatch power = powers(going.gather(r_, at), with.power, with.kept_bits);
            const DerivativeBatch dr =
                next_derivative({going.gather(mantissa_, at), going.gather(fraction_bits_, at)},
                                power.kept_lower, with.power, with.kept_bits, with.derivative);
            going.scatter(dr.mantissa, mantissa_, at);
            going.scatter(dr.fraction_bits, fraction_bits_, at);
            const CartesianBatch up =
                to_cartesian(cordic_, power.upper, turned(going.gather(theta_, at)));
            const CartesianBatch flat = to_cartesian(cordic_, up.y, turned(going.gather(phi_, at)));
            const std::array<const Batch*, 3> point = {&flat.x, &flat.y, &up.x};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Batch moved = going.gather(c_[axis], at);
                for (std::size_t j = 0; j < in_flight; ++j)
                    moved[j] = hn::Add(moved[j], (*point[axis])[j]);
                going.scatter(moved, w_[axis], at);
            }
        }
        for (std::size_t at = 0; at < going.count(); ++at)
            ++index_[going.slot(at)];
    }

    /// The distance where the orbit stopped, and the next point of the ray.
    void evaluate(const Selection& ended)
    {
        Column distances;
        for (std::size_t at = 0; at < ended.count(); at += batch)
            store(distance_of(ended.gather(r_, at),
                              {ended.gather(mantissa_, at), ended.gather(fraction_bits_, at)},
                              course_.with),
                  &distances[at]);
        // From the last slot on: what moves into a slot that falls free has had its turn.
        for (std::size_t at = ended.count(); at-- > 0;)
            advance(ended.slot(at), static_cast<std::int64_t>(distances[at]));
    }

    void advance(std::size_t slot, std::int64_t distance)
    {
        ++evaluations_[slot];
        t_[slot] += distance;
        const bool hit = distance <= course_.epsilon;
        const bool miss = t_[slot] > farthest<Format>;
        if (!hit && !miss && evaluations_[slot] < course_.limits.evaluations)
            return place(slot);
        rays_.finish(pixel_[slot],
                     hit    ? Outcome::Hit
                     : miss ? Outcome::Miss
                            : Outcome::Limit,
                     evaluations_[slot], static_cast<int>(index_[slot]));
        if (!start(slot))
            free(slot);
    }

    /// Puts the next ray into the slot, behind its first evaluation. False: there is none.
    bool start(std::size_t slot)
    {
        Ray ray;
        if (!rays_.next(ray))
            return false;
        directions_[slot] = ray.direction;
        pixel_[slot] = ray.pixel;
        t_[slot] = course_.first;
        evaluations_[slot] = 1;
        place(slot);
        return true;
    }

    /// An orbit at the ray's point.
    void place(std::size_t slot)
    {
        const Point<Format> point =
            point_at<Format>(course_.origin, directions_[slot], t_[slot], course_.with.scale);
        const std::array<std::int64_t, 3> axes = {point.x, point.y, point.z};
        for (std::size_t axis = 0; axis < 3; ++axis)
            w_[axis][slot] = c_[axis][slot] = static_cast<std::uint64_t>(axes[axis]);
        const Derivative dr;
        mantissa_[slot] = dr.mantissa;
        fraction_bits_[slot] = static_cast<std::uint64_t>(dr.fraction_bits);
        index_[slot] = 0;
    }

    /// Moves the last ray into the slot.
    void free(std::size_t slot)
    {
        const std::size_t last = --count_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            w_[axis][slot] = w_[axis][last];
            c_[axis][slot] = c_[axis][last];
        }
        mantissa_[slot] = mantissa_[last];
        fraction_bits_[slot] = fraction_bits_[last];
        index_[slot] = index_[last];
        directions_[slot] = directions_[last];
        pixel_[slot] = pixel_[last];
        t_[slot] = t_[last];
        evaluations_[slot] = evaluations_[last];
    }

    const Course<Format>& course_;
    Cordic cordic_;
    Rays& rays_;
    std::size_t count_ = 0; ///< slots in use, from 0 on

    Axes w_{};
    Axes c_{};
    Column r_{};
    Column theta_{};
    Column phi_{};
    Column mantissa_{}; ///< of the derivative
    Column fraction_bits_{};
    Column index_{};
    std::array<Direction, slots> directions_{};
    std::array<std::size_t, slots> pixel_{};
    std::array<std::int64_t, slots> t_{};
    std::array<int, slots> evaluations_{};
};

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
