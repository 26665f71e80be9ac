// SPDX-License-Identifier: MIT
// The stages composed, as fractal.cpp does it, for pixels in vectors. Highway compiles this file
// once for each instruction set.
#include "engine/fast/kernels.hpp"

#include "engine/fast/targets.hpp"
#include "engine/fractal/checkerboard.hpp"
#include "engine/fractal/display.hpp"
#include "engine/fractal/frame.hpp"
#include "engine/fractal/ray_generator.hpp"
#include "engine/fractal/ray_marcher.hpp"
#include "engine/fractal/shading.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/fractal/fast/kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h. The plain C++ that Highway may end with is not used.
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "engine/fractal/fast/ray_generator-inl.hpp"
#include "engine/fractal/fast/ray_marcher-inl.hpp"
#include "engine/fractal/fast/scenes-inl.hpp"
#include "engine/fractal/fast/shading-inl.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

constexpr unsigned max_rows = 16;

/// The pixels of a row that this frame draws, of the tile's columns.
struct Line
{
    std::uint16_t y;
    unsigned first; ///< column
    unsigned step;
    std::size_t count;
    std::size_t columns; ///< which of the tile's
    Row row;
};

/// All pixels of a region share these numbers.
struct Scenery
{
    const Frame& frame;
    Camera camera;
    Plane plane;
    Paint paint;
    const SceneRow& scene;
    Number first; ///< the distance of the camera, which all rays ask first
};

/// A part of the region: rows of up to max_columns drawn pixels, and how their rays ended.
struct Tile
{
    std::array<Columns, 2> columns; ///< a checkerboard's rows take two in turn
    std::array<Line, max_rows> lines;
    std::size_t line_count = 0;
    HWY_ALIGN std::array<Ending, max_rows * max_columns> endings;

    [[nodiscard]] Ending* endings_of(std::size_t line) { return &endings[line * max_columns]; }
};

Ending ending_of(const Frame& frame, const March& ray) noexcept
{
    const unsigned level = !ray.hit        ? dark
                           : frame.texture ? fractal::brick(ray.point, ray.depth)
                                           : ray.depth;
    return static_cast<Ending>(level | (ray.depth + 1U) << queries_shift);
}

/// Rays of a direction that the vectors do not hold, one by one.
void march_alone(const Scenery& scenery, const Line& line, std::size_t first, std::size_t count,
                 Ending* endings) noexcept
{
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<std::uint16_t>(line.first + (first + i) * line.step);
        const Point direction = ray_direction(scenery.camera, scenery.plane, x, line.y);
        endings[i] = ending_of(scenery.frame, fractal::march(scenery.frame.position, direction,
                                                             scenery.scene.distance));
    }
}

template <class Rays>
void march_tile(const Scenery& scenery, Tile& tile)
{
    using March = Marcher<Rays>;
    constexpr std::size_t count = lanes<typename Rays::Tag>;
    const Surface surface = scenery.frame.texture ? Surface::Brick : Surface::Plain;
    March marcher(scenery.frame.position, scenery.first, surface, tile.endings.data());

    std::array<typename March::Start, in_flight> starts;
    std::size_t started = 0;
    for (std::size_t at = 0; at < max_columns; at += count)
        for (std::size_t i = 0; i < tile.line_count; ++i) {
            const Line& line = tile.lines[i];
            if (line.count <= at)
                continue;
            auto& start = starts[started];
            start.place = i * max_columns + at;
            start.count = std::min(line.count - at, count);
            bool bounded = true;
            for (std::size_t part = 0; part < Rays::parts; ++part)
                start.directions[part] = directions(tile.columns[line.columns],
                                                    at + part * lanes<I32>, line.row, bounded);
            if (!bounded) {
                march_alone(scenery, line, at, start.count, &tile.endings[start.place]);
                continue;
            }
            if (++started == in_flight) {
                marcher.march(starts);
                started = 0;
            }
        }
    if (started > 0) {
        for (std::size_t i = started; i < in_flight; ++i) {
            starts[i] = starts[0];
            starts[i].count = 0;
        }
        marcher.march(starts);
    }
    marcher.finish();
}

/// All rays end where they begin.
void end_at_once(const Scenery& scenery, Tile& tile)
{
    const Point nowhere{};
    const Ending ending = ending_of(
        scenery.frame, fractal::march(scenery.frame.position, nowhere, scenery.scene.distance));
    tile.endings.fill(ending);
}

void march_tile(const Scenery& scenery, Tile& tile)
{
    if (scenery.first < hit_limit || scenery.first > five)
        return end_at_once(scenery, tile);
    switch (scenery.scene.scene) {
    case Scene::Menger:
        return march_tile<MengerRays>(scenery, tile);
    case Scene::Cubes:
        return march_tile<CubesRays>(scenery, tile);
    case Scene::Cube:
        return march_tile<CubeRays>(scenery, tile);
    case Scene::Maze:
        return march_tile<MazeRays>(scenery, tile);
    }
}

void show(const Scenery& scenery, const Line& line, const Ending* endings, PictureSize size,
          const Canvas& canvas)
{
    constexpr std::size_t pixels = lanes<U8>;
    const Parity parity{.first = ((line.first ^ line.y) & 1) != 0,
                        .alternates = line.step % 2 != 0};
    const std::size_t row = std::size_t{line.y} * size.width + line.first;
    std::uint8_t* const rgb = canvas.rgb.data() + bytes_per_pixel * row;
    for (std::size_t i = 0; i < line.count; i += pixels) {
        if (line.step == 1 && line.count - i >= pixels) {
            show(scenery.paint, parity, endings + i, rgb + bytes_per_pixel * i);
            continue;
        }
        HWY_ALIGN std::array<std::uint8_t, bytes_per_pixel * pixels> shown;
        show(scenery.paint, parity, endings + i, shown.data());
        const std::size_t count = std::min(line.count - i, pixels);
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t byte = 0; byte < bytes_per_pixel; ++byte)
                rgb[bytes_per_pixel * (i + j) * line.step + byte] =
                    shown[bytes_per_pixel * j + byte];
    }
    if (!canvas.costs.empty())
        for (std::size_t i = 0; i < line.count; ++i)
            canvas.costs[row + i * line.step] = {
                .steps = static_cast<std::uint32_t>(endings[i] >> queries_shift), .rays = 1};
}

void draw(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const auto& frame = frame_of<Frame>(picture);
    const SceneRow& scene = scene_row(frame.scene);
    const Scenery scenery{
        .frame = frame,
        .camera = camera_along(frame.forward),
        .plane = plane_of(region.size),
        .paint = paint_of(palette(frame.colour ? Colouring::Hue : Colouring::Grey, frame.hue),
                          frame.dither),
        .scene = scene,
        .first = scene.distance(frame.position)};
    const unsigned right = unsigned{region.x} + region.width;
    const unsigned bottom = unsigned{region.y} + region.height;
    // Of a checkerboard every other pixel, or, where the region's step is even, none or all of a
    // row.
    const bool alternates = frame.checker && region.step % 2 != 0;
    const unsigned step = region.step * (alternates ? 2U : 1U);
    if (frame.checker && !canvas.costs.empty())
        for (unsigned y = region.y; y < bottom; y += region.step)
            for (unsigned x = region.x; x < right; x += region.step)
                canvas.costs[std::size_t{y} * region.size.width + x] = {};

    Tile tile;
    for (unsigned left = region.x; left < right; left += step * max_columns) {
        for (std::size_t i = 0; i < tile.columns.size(); ++i)
            fill(tile.columns[i], scenery.camera, scenery.plane,
                 left + static_cast<unsigned>(i) * region.step, step);
        for (unsigned y = region.y; y < bottom;) {
            for (tile.line_count = 0; tile.line_count < max_rows && y < bottom; y += region.step) {
                const bool now = !frame.checker || in_half(region.frame, left, y);
                if (!now && !alternates)
                    continue;
                const unsigned first = now ? left : left + region.step;
                const std::size_t count = first < right ? (right - first + step - 1) / step : 0;
                tile.lines[tile.line_count++] = {
                    .y = static_cast<std::uint16_t>(y),
                    .first = first,
                    .step = step,
                    .count = std::min<std::size_t>(count, max_columns),
                    .columns = now ? 0U : 1U,
                    .row = row_at(scenery.camera, scenery.plane, static_cast<std::uint16_t>(y))};
            }
            march_tile(scenery, tile);
            for (std::size_t i = 0; i < tile.line_count; ++i)
                show(scenery, tile.lines[i], tile.endings_of(i), region.size, canvas);
        }
    }
}

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "engine/fast/kernel_table.hpp"
RAYMARCH_DEFINE_KERNELS(fractal)
#endif
