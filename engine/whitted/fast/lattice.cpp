// SPDX-License-Identifier: MIT
#include "engine/whitted/fast/lattice.hpp"

#include "engine/whitted/pixel.hpp"
#include "engine/whitted/ray_setup.hpp"
#include "engine/whitted/tracer.hpp"

#include <algorithm>

namespace raymarch::engine::whitted::fast
{
namespace
{

/// A sample at half pixels as a place beside a pixel.
struct Place
{
    unsigned pixel;
    std::int8_t beside;
};

Place place_of(int half_pixels) noexcept
{
    const unsigned pixel = static_cast<unsigned>(half_pixels + 1) / 2;
    return {pixel, static_cast<std::int8_t>(half_pixels - static_cast<int>(2 * pixel))};
}

Vector screen_at(const Frame& frame, PictureSize size, int u, int v) noexcept
{
    const Place x = place_of(u);
    const Place y = place_of(v);
    return screen_point(frame, size, x.pixel, y.pixel, {x.beside, y.beside, 0});
}

} // namespace

Lattice::Lattice(const Frame& frame, const Region& region, unsigned first_pixel) noexcept
    : size_(region.size)
    , first_pixel_(first_pixel)
    , step_(region.step)
    , pixels_(std::min<std::size_t>(
          tile_width, (region.x + region.width - first_pixel + region.step - 1U) / region.step))
    , to_the_right_(region.step == 1 ? 1 : pixels_)
    , anti_aliasing_(frame.anti_aliasing)
    , defects_(frame.defects)
{
    for (std::size_t i = 0; i < pixels_; ++i)
        for (const int dx : {-1, 0, 1})
            u_[first_column(dx) + i] = static_cast<int>(2 * (first_pixel_ + i * step_)) + dx;
    const Part even{0, pixels_};
    const Part odd{odd_columns, first_column(1) + pixels_};
    both_ = {even, odd};
    even_ = {even};
    odd_ = {odd};
    for (const Part& part : both_)
        for (std::size_t i = part.first; i < part.end; ++i)
            x[i] = screen_at(frame, size_, u_[i], 0).x.raw();
    z = screen_at(frame, size_, 0, 0).z;
}

void Lattice::move_to(const Frame& frame, unsigned y) noexcept
{
    const bool shares = begun_ && step_ == 1;
    begun_ = true;
    y_ = y;
    if (shares)
        std::swap(row_of_[0], row_of_[1]);
    const auto want = [&](std::size_t row, int dy) {
        const int v = static_cast<int>(2 * y) + dy;
        rows[row] = {.v = v, .y = screen_at(frame, size_, 0, v).y, .wanted = true};
    };
    want(1, 0);
    if (anti_aliasing_ == AntiAliasing::Off)
        return;
    want(row_of_[1], 1);
    if (!shares)
        want(row_of_[0], -1);
}

std::span<const Lattice::Part> Lattice::parts_of(std::size_t row) const noexcept
{
    if (anti_aliasing_ == AntiAliasing::Eight)
        return both_;
    return std::span(row == 1 ? even_ : odd_).first(1);
}

void Lattice::draw_lost(const Frame& frame, Results& results) const noexcept
{
    for (std::size_t i = 0; i < results.lost_count; ++i) {
        const auto slot = static_cast<std::size_t>(results.lost[i]);
        const Place at_x = place_of(u_[slot % row_samples]);
        const Place at_y = place_of(rows[slot / row_samples].v);
        const Sample sample = trace(frame, primary_direction(frame, size_, at_x.pixel, at_y.pixel,
                                                             {at_x.beside, at_y.beside, 0}));
        results.sums[slot] = sample.colour[0] << Packed::red | sample.colour[1] << Packed::green |
                             sample.colour[2] << Packed::blue |
                             (sample.sees_light ? Packed::sees_light : 0) |
                             (sample.ends_at_light ? Packed::ends_at_light : 0);
        results.cycles[slot] = static_cast<std::int32_t>(sample.cost.steps);
        results.rays[slot] = static_cast<std::int32_t>(sample.cost.rays);
    }
    results.lost_count = 0;
}

void Lattice::put_costs(const Results& results, const Canvas& canvas) const noexcept
{
    for (std::size_t i = 0; i < pixels_; ++i) {
        PixelCost cost;
        for (const SamplePlace& place : sample_places(anti_aliasing_)) {
            const std::size_t slot = first_slot(place) + i;
            cost.steps += static_cast<std::uint32_t>(results.cycles[slot]);
            cost.rays += static_cast<std::uint32_t>(results.rays[slot]);
        }
        canvas.costs[at(i)] = cost;
    }
}

bool drawn_without_rays(const Scene& scene, const Region& region, const Canvas& canvas) noexcept
{
    const bool black = scene.kind == Scene::Kind::Black && canvas.costs.empty();
    if (scene.kind == Scene::Kind::Tame)
        return false;
    for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += region.step)
        for (unsigned x = region.x; x < unsigned{region.x} + region.width; x += region.step) {
            const std::size_t at = std::size_t{y} * region.size.width + x;
            const Pixel pixel = black ? Pixel{} : draw_pixel(scene.frame, region.size, x, y);
            std::ranges::copy(displayed(pixel.word),
                              canvas.rgb.subspan(bytes_per_pixel * at, bytes_per_pixel).begin());
            if (!canvas.costs.empty())
                canvas.costs[at] = pixel.cost;
        }
    return true;
}

} // namespace raymarch::engine::whitted::fast
