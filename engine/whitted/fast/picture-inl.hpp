// SPDX-License-Identifier: MIT
/// @file
/// Regions of pictures: pixel.cpp and ray_setup.cpp for a tile of a row.
///
/// The samples of neighbouring pixels coincide: (2x + 1, 2y) in half pixels is a sample of pixel x
/// and of pixel x + 1. Each is traced once and counted wherever the hardware traces it.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_PICTURE) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_PICTURE
#undef RAYMARCH_ENGINE_WHITTED_FAST_PICTURE
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_PICTURE
#endif

#include "engine/whitted/fast/bounce-inl.hpp"
#include "engine/whitted/fast/lattice.hpp"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// Adds the primary rays of the columns `first` to `end` of a row to the stream.
template <typename R>
void set_out(const Lattice& lattice, std::size_t row, std::size_t first, std::size_t end,
             Stream<R::counts>& stream, std::size_t& count, Results& results)
{
    const Vec<I32> y = Set<I32>(lattice.rows[row].y.raw());
    const Vec<I32> z = Set<I32>(lattice.z.raw());
    const Real3 rest_{hn::Zero(F32()), real(y), real(z)};
    const Vec<F32> rest = dot(rest_, rest_, hn::Zero(F32()));
    const Vec<I32> rest_low = hn::Add(hn::Mul(y, y), hn::Mul(z, z));
    for (std::size_t at = first; at < end; at += lanes<I32>) {
        const Vec<I32> x = hn::LoadU(I32(), lattice.x.data() + at);
        const Vec<F32> x_ = real(x);
        const SquaredLength squared =
            squared_length(hn::Add(hn::Mul(x, x), rest_low),
                           hn::Mul(hn::MulAdd(x_, x_, rest), Set<F32>(1.0F / 4096.0F)));
        const Triple direction = divide({x, y, z}, square_root(squared.whole));
        const Mask<I32> here = hn::FirstN(I32(), end - at);
        const Mask<I32> tame = hn::And(here, hn::AndNot(squared.too_short, squared.fits));
        const Vec<I32> slot = hn::Iota(I32(), static_cast<std::int32_t>(row * row_samples + at));
        const Compress<I32> compress(tame);
        const auto keep = [&](std::int32_t* column, Vec<I32> value) {
            compress.store(value, column + count);
        };
        keep(stream.direction_x, direction.x);
        keep(stream.direction_y, direction.y);
        keep(stream.direction_z, direction.z);
        keep(stream.slot, slot);
        count += compress.count();
        lose(results, hn::AndNot(tame, here), slot);
    }
}

/// Follows the stream's rays to their ends.
template <typename R>
void follow_all(const Scene& scene, const Lattice& lattice, Stream<R::counts>& stream,
                std::size_t count, Results& results)
{
    const unsigned reflections = scene.frame.reflections;
    count = follow<R, Generation::Primary>(scene, stream, count, reflections == 0, results);
    for (unsigned done = 1; done <= reflections && count > 0; ++done)
        count =
            follow<R, Generation::Reflected>(scene, stream, count, done == reflections, results);
    lattice.draw_lost(scene.frame, results);
}

/// Traces the rows that the lattice says are not traced yet.
template <typename R>
void trace_rows(const Scene& scene, Lattice& lattice, Stream<R::counts>& stream, Results& results)
{
    std::size_t count = 0;
    for (std::size_t row = 0; row < sample_rows; ++row) {
        if (!lattice.rows[row].wanted)
            continue;
        lattice.rows[row].wanted = false;
        for (const Lattice::Part& part : lattice.parts_of(row)) {
            if (count + part.end - part.first > stream_length) {
                follow_all<R>(scene, lattice, stream, count, results);
                count = 0;
            }
            set_out<R>(lattice, row, part.first, part.end, stream, count, results);
        }
    }
    follow_all<R>(scene, lattice, stream, count, results);
}

/// Puts the samples of the lattice's pixels together.
template <typename R>
void put_pixels(const Frame& frame, const Lattice& lattice, const Results& results,
                const Canvas& canvas)
{
    const std::span<const SamplePlace> places = sample_places(frame.anti_aliasing);
    constexpr bool by_end = R::has(Defect::LastHitIsLight);
    const SamplePlace& flag = by_end ? places.back() : places.front();
    for (std::size_t i = 0; i < lattice.pixels(); i += lanes<I32>) {
        const auto load = [&](const SamplePlace& place) {
            return hn::LoadU(I32(), results.sums.data() + lattice.first_slot(place) + i);
        };
        // Shares of 10 bits that sum up to no more than 10 bits: all channels at once.
        Vec<I32> sum = hn::Zero(I32());
        for (const SamplePlace& place : places) {
            const std::int32_t kept = Packed::channel_mask >> place.shift;
            const Vec<I32> share = hn::ShiftRightSame(load(place), place.shift);
            sum = hn::Add(sum, hn::And(share, Set<I32>(kept << Packed::red | kept << Packed::green |
                                                       kept << Packed::blue)));
        }
        // `displayed`: the upper 5 of 10 bits, and those of the light behind them.
        const auto byte = [&](Vec<I32> channels, std::int32_t place) {
            return hn::And(channels, Set<I32>(0xF8 << place));
        };
        const Vec<I32> red = byte(hn::ShiftRight<Packed::red + 2>(sum), 0);
        const Vec<I32> green = byte(hn::ShiftRight<Packed::green + 2 - 8>(sum), 8);
        const Vec<I32> blue = byte(hn::ShiftRight<Packed::blue + 2 - 16>(sum), 16);
        const Mask<I32> light = hn::Ne(
            hn::And(load(flag), Set<I32>(by_end ? Packed::ends_at_light : Packed::sees_light)),
            hn::Zero(I32()));
        Vec<I32> bytes = hn::Or(hn::Or(red, green),
                                hn::Or(blue, hn::IfThenElseZero(light, Set<I32>(0x07'07'07))));
        if (lattice.is_black())
            bytes = hn::Zero(I32());

        Storage<lanes<I32>> pixels{};
        hn::Store(bytes, I32(), pixels.data());
        for (std::size_t lane = 0; lane < std::min(lanes<I32>, lattice.pixels() - i); ++lane) {
            std::uint8_t* const to = canvas.rgb.data() + bytes_per_pixel * lattice.at(i + lane);
            to[0] = static_cast<std::uint8_t>(pixels[lane]);
            to[1] = static_cast<std::uint8_t>(pixels[lane] >> 8);
            to[2] = static_cast<std::uint8_t>(pixels[lane] >> 16);
        }
    }
}

template <typename R>
void draw_tame(const Scene& scene, const Region& region, const Canvas& canvas)
{
    Stream<R::counts> stream;
    Results results;
    const unsigned step = region.step;
    const unsigned tile = tile_width * step;
    for (unsigned x = region.x; x < unsigned{region.x} + region.width; x += tile) {
        Lattice lattice(scene.frame, region, x);
        for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += step) {
            lattice.move_to(scene.frame, y);
            trace_rows<R>(scene, lattice, stream, results);
            put_pixels<R>(scene.frame, lattice, results, canvas);
            if constexpr (R::counts)
                lattice.put_costs(results, canvas);
        }
    }
}

template <Profile profile>
void draw_profile(const Scene& scene, const Region& region, const Canvas& canvas)
{
    if (canvas.costs.empty())
        draw_tame<Rules<profile, Counting::Off>>(scene, region, canvas);
    else
        draw_tame<Rules<profile, Counting::On>>(scene, region, canvas);
}

/// See Kernel.
void draw(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const Scene scene = make_scene(frame_of<Frame>(picture));
    if (drawn_without_rays(scene, region, canvas))
        return;
    if (scene.frame.defects == Defects(Profile::Measured))
        draw_profile<Profile::Measured>(scene, region, canvas);
    else
        draw_profile<Profile::Repaired>(scene, region, canvas);
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
