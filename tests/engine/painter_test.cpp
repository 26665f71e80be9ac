// SPDX-License-Identifier: MIT
#include "engine/painter.hpp"

#include "engine/models.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace raymarch::engine
{
namespace
{

/// A kernel that counts how often each pixel is drawn, in the first byte.
void count_pixels(const Picture& /*picture*/, const Region& region, const Canvas& canvas) noexcept
{
    for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += region.step)
        for (unsigned x = region.x; x < unsigned{region.x} + region.width; x += region.step)
            ++canvas.rgb[3 * (std::size_t{y} * region.size.width + x)];
}
constexpr Kernel counting{Isa::Scalar, count_pixels};

const protocol::Words painted_words =
    protocol::pack(*models[0].description, protocol::initial_state(*models[0].description));

TEST(Painter, DrawsEveryPixelOnceInEachOfManyPictures)
{
    constexpr PictureSize size{7, 150};
    for (const unsigned threads : {1U, 2U, 5U}) {
        Painter painter(threads);
        EXPECT_EQ(painter.threads(), threads);
        for (int picture = 0; picture < 200; ++picture) {
            Image image(size);
            painter.draw({models[0], painted_words, &counting}, whole(size), {image.rgb});
            for (std::size_t i = 0; i < image.rgb.size(); ++i)
                ASSERT_EQ(image.rgb[i], i % 3 == 0 ? 1 : 0) << i;
        }
    }
}

TEST(Painter, BandsOfALatticeStayOnIt)
{
    constexpr PictureSize size{9, 200};
    Painter painter(3);
    Image image(size);
    painter.draw({models[0], painted_words, &counting},
                 {.size = size, .x = 1, .y = 3, .width = 8, .height = 190, .step = 5}, {image.rgb});
    for (unsigned y = 0; y < size.height; ++y)
        for (unsigned x = 0; x < size.width; ++x) {
            const bool drawn = x % 5 == 1 && y % 5 == 3 && y < 193;
            EXPECT_EQ(image.row(y)[std::size_t{3} * x], drawn ? 1 : 0) << x << "," << y;
        }
}

TEST(Painter, AStopLeavesTheRest)
{
    constexpr PictureSize size{4, 4};
    Painter painter(2);
    std::stop_source stop;
    stop.request_stop();
    Image image(size);
    painter.draw({models[0], painted_words, &counting}, whole(size), {image.rgb}, stop.get_token());
    EXPECT_EQ(image.rgb, Image(size).rgb);
}

TEST(Painter, ItsListenerHearsHowFarThePictureIs)
{
    constexpr PictureSize size{3, 100}; // seven bands
    for (const unsigned threads : {1U, 3U}) {
        Painter painter(threads);
        std::vector<unsigned> heard;
        painter.listen([&](unsigned taken, unsigned parts) {
            EXPECT_EQ(parts, 7U);
            heard.push_back(taken);
        });
        Image image(size);
        painter.draw({models[0], painted_words, &counting}, whole(size), {image.rgb});
        EXPECT_TRUE(std::ranges::is_sorted(heard));
        if (threads == 1) {
            EXPECT_EQ(heard, (std::vector<unsigned>{1, 2, 3, 4, 5, 6, 7}));
        }
        for (const unsigned taken : heard)
            EXPECT_TRUE(taken >= 1 && taken <= 7) << taken;
        painter.listen({});
        heard.clear();
        painter.draw({models[0], painted_words, &counting}, whole(size), {image.rgb});
        EXPECT_EQ(heard, std::vector<unsigned>());
    }
}

TEST(Painter, WithoutWorkItEnds)
{
    const Painter painter(4);
    EXPECT_EQ(painter.threads(), 4U);
}

} // namespace
} // namespace raymarch::engine
