// SPDX-License-Identifier: MIT
// The stages composed: a region's pixels from rays that are generated row by row, marched a pool at
// a time, and shaded where they hit. Included by kernel.cpp alone, once for each instruction set:
// no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

inline void put(const Canvas& canvas, std::size_t pixel, std::uint32_t colour) noexcept
{
    std::uint8_t* const to = &canvas.rgb[bytes_per_pixel * pixel];
    to[0] = static_cast<std::uint8_t>(colour);
    to[1] = static_cast<std::uint8_t>(colour >> 8);
    to[2] = static_cast<std::uint8_t>(colour >> 16);
}

/// The scene, its outline, and what the drawing of one region needs beside them.
template <class Scene, class Outline, Counting counting>
class RegionDrawing
{
  public:
    RegionDrawing(const Frame& frame, const Region& region, const Canvas& canvas) noexcept
        : frame_(frame)
        , region_(region)
        , canvas_(canvas)
        , outline_(frame, region.size)
    {}

    void draw() noexcept
    {
        // Each ray's first query is at the eye.
        const Coordinate d = scene_row(frame_.scene).distance(frame_.eye);
        if (d > max_distance || d < surface_distance)
            return draw_all(first_colour(d));
        first_t_ = d.raw();
        for (unsigned y = region_.y; y < unsigned{region_.y} + region_.height; y += region_.step)
            draw_row(static_cast<int>(y));
        finish_rays();
    }

  private:
    /// What all rays see that end at the eye.
    std::uint32_t first_colour(Coordinate d) const noexcept
    {
        if (d > max_distance)
            return 0;
        const auto& eye = frame_.eye;
        const auto rgb = marcher::shade(
            frame_.colour,
            marcher::brightness(marcher::surface_normal(eye, scene_row(frame_.scene).distance),
                                marcher::light_direction(eye, frame_.light)));
        return rgb[0] | std::uint32_t{rgb[1]} << 8 | std::uint32_t{rgb[2]} << 16;
    }

    void draw_all(std::uint32_t colour) noexcept
    {
        for (unsigned y = region_.y; y < unsigned{region_.y} + region_.height; y += region_.step)
            for (unsigned x = region_.x; x < unsigned{region_.x} + region_.width; x += region_.step)
                finish_pixel(std::size_t{y} * region_.size.width + x, colour, 1);
    }

    void finish_pixel(std::size_t pixel, std::uint32_t colour, std::int32_t queries) noexcept
    {
        put(canvas_, pixel, colour);
        if constexpr (counting == Counting::On)
            canvas_.costs[pixel] = {.steps = static_cast<std::uint32_t>(queries), .rays = 1};
    }

    /// Black first; then the rays of the pixels inside the outline, those that the step leaves.
    void draw_row(int y) noexcept
    {
        const int step = region_.step;
        const int end = region_.x + region_.width;
        const std::size_t row = static_cast<std::size_t>(y) * region_.size.width;
        if (step == 1)
            std::memset(&canvas_.rgb[bytes_per_pixel * (row + region_.x)], 0,
                        bytes_per_pixel * region_.width);
        else
            for (int x = region_.x; x < end; x += step)
                put(canvas_, row + static_cast<std::size_t>(x), 0);

        Span span = counting == Counting::On ? Span{0, region_.size.width} : outline_.of_row(y);
        const int before = std::max(span.first - region_.x, 0);
        span.first = region_.x + (before + step - 1) / step * step;
        span.end = std::min(span.end, end);
        if (span.first >= span.end)
            return;
        RowOfDirections directions(frame_, region_.size, span.first, y, step);
        Ints pixel = as_ints(
            hn::Iota(WordTag(), 0) * all_words(static_cast<std::uint32_t>(step)) +
            all_words(static_cast<std::uint32_t>(row) + static_cast<std::uint32_t>(span.first)));
        const Ints stride = all(step * static_cast<int>(lanes));
        for (int left = (span.end - span.first + step - 1) / step; left > 0;
             left -= static_cast<int>(lanes)) {
            if (pool_.count > Rays::capacity - lanes)
                finish_rays();
            add_rays(directions.next(), pixel);
            pool_.count += std::min(lanes, static_cast<std::size_t>(left));
            pixel = pixel + stride;
        }
    }

    HWY_INLINE void add_rays(const Points& direction, Ints pixel) noexcept
    {
        Rays& rays = pool_.flying;
        const std::size_t at = pool_.count;
        hn::StoreU(hn::ShiftLeft<direction_shift>(direction.x), IntTag(), &rays.x[at]);
        hn::StoreU(hn::ShiftLeft<direction_shift>(direction.y), IntTag(), &rays.y[at]);
        hn::StoreU(hn::ShiftLeft<direction_shift>(direction.z), IntTag(), &rays.z[at]);
        hn::StoreU(all(first_t_), IntTag(), &rays.t[at]);
        hn::StoreU(pixel, IntTag(), &rays.pixel[at]);
        if constexpr (counting == Counting::On)
            hn::StoreU(all(1), IntTag(), &rays.spent[at]);
    }

    /// Marches the rays that there are to their ends, and colours the pixels of those that hit.
    void finish_rays() noexcept
    {
        march<Scene, counting>(pool_, all(frame_.eye));
        if constexpr (counting == Counting::On)
            for (std::size_t i = 0; i < pool_.count; ++i)
                finish_pixel(static_cast<std::uint32_t>(pool_.flying.pixel[i]), 0, max_steps);
        pool_.count = 0;
        for (std::size_t at = pool_.first_ended; at < Rays::room; at += lanes)
            shade_ended(at);
        pool_.first_ended = Rays::room;
    }

    void shade_ended(std::size_t at) noexcept
    {
        const Rays& rays = pool_.ended;
        const Ints t = hn::LoadU(IntTag(), &rays.t[at]);
        const Points p = position(all(frame_.eye), rays, at, t);
        const Points normal = HWY_NAMESPACE::surface_normal<Scene>(p);
        const Points light = HWY_NAMESPACE::light_direction(p, all(frame_.light));
        const Words colour =
            HWY_NAMESPACE::shade(frame_.colour, HWY_NAMESPACE::brightness(normal, light));
        const Ints lost = hn::VecFromMask(IntTag(), t > all(max_distance.raw()));
        alignas(64) std::array<std::uint32_t, lanes> colours;
        hn::Store(hn::AndNot(as_words(lost), colour), WordTag(), colours.data());
        const std::size_t count = std::min(lanes, Rays::room - at);
        for (std::size_t i = 0; i < count; ++i)
            finish_pixel(static_cast<std::uint32_t>(rays.pixel[at + i]), colours[i],
                         rays.spent[at + i]);
    }

    const Frame& frame_;
    const Region& region_;
    const Canvas& canvas_;
    Outline outline_;
    std::int32_t first_t_ = 0;
    Pool pool_;
};

template <Counting counting>
void draw_counting(const Frame& frame, const Region& region, const Canvas& canvas) noexcept
{
    switch (frame.scene) {
    case marcher::Scene::Sphere:
        return RegionDrawing<Sphere, BallOutline, counting>(frame, region, canvas).draw();
    case marcher::Scene::Cube:
        return RegionDrawing<Cube, BoxOutline, counting>(frame, region, canvas).draw();
    case marcher::Scene::InfiniteCube:
        return RegionDrawing<InfiniteCube, NoOutline, counting>(frame, region, canvas).draw();
    case marcher::Scene::Tunnel:
        return RegionDrawing<Tunnel, NoOutline, counting>(frame, region, canvas).draw();
    }
}

void draw(WordSpan words, const Region& region, const Canvas& canvas) noexcept
{
    const Frame frame = latch(words);
    if (canvas.costs.empty())
        draw_counting<Counting::Off>(frame, region, canvas);
    else
        draw_counting<Counting::On>(frame, region, canvas);
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
