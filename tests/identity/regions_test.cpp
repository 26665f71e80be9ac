// SPDX-License-Identifier: MIT
/// @file
/// Every accelerator, drawn in parts: the same pixels as in one piece, and no others.
#include "identity.hpp"
#include "protocol/registers.hpp"

#include <array>

namespace raymarch::engine::identity
{
namespace
{

constexpr PictureSize size{37, 29};

class EveryModel : public testing::TestWithParam<const Model*>
{
  protected:
    const Model& model = *GetParam();
    protocol::Words words =
        protocol::pack(*model.description, protocol::initial_state(*model.description));
};

TEST_P(EveryModel, PartsHoldThePixelsOfTheWhole)
{
    const Drawn all = draw_region(model, nullptr, words, whole(size), Costs::Wanted);
    const Drawn none =
        draw_region(model, nullptr, words, {.size = size, .width = 0, .height = 0}, Costs::Wanted);
    const std::array regions = {
        Region{.size = size, .x = 3, .y = 5, .width = 20, .height = 17},
        Region{.size = size, .x = 0, .y = 1, .width = 37, .height = 28, .step = 4},
        Region{.size = size, .x = 36, .y = 28, .width = 1, .height = 1, .step = 8},
    };
    for (const Region& region : regions) {
        const Drawn part = draw_region(model, nullptr, words, region, Costs::Wanted);
        for (unsigned y = 0; y < size.height; ++y)
            for (unsigned x = 0; x < size.width; ++x) {
                const bool inside = x >= region.x && x < region.x + region.width && y >= region.y &&
                                    y < region.y + region.height &&
                                    (x - region.x) % region.step == 0 &&
                                    (y - region.y) % region.step == 0;
                const std::size_t i = std::size_t{y} * size.width + x;
                const Drawn& expected = inside ? all : none;
                ASSERT_EQ(part.costs[i], expected.costs[i]) << x << "," << y;
                for (std::size_t byte = 3 * i; byte < 3 * i + 3; ++byte)
                    ASSERT_EQ(part.rgb[byte], expected.rgb[byte]) << x << "," << y;
            }
        expect_identity(model, words, region);
    }
}

TEST_P(EveryModel, AnyNumberOfThreadsDrawsTheSame)
{
    for (const Kernel* const kernel : {static_cast<const Kernel*>(nullptr), kernel_of(model)}) {
        Image one(size);
        Painter alone(1);
        draw_still(alone, {model, words, kernel}, one);
        for (const unsigned threads : {2U, 3U, 7U}) {
            Image many(size);
            Painter painter(threads);
            for (int again = 0; again < 3; ++again) {
                draw_still(painter, {model, words, kernel}, many);
                EXPECT_EQ(many.rgb, one.rgb) << threads;
            }
        }
    }
}

constexpr auto every_model = [] {
    std::array<const Model*, models.size()> all{};
    for (std::size_t i = 0; i < models.size(); ++i)
        all[i] = &models[i];
    return all;
}();
INSTANTIATE_TEST_SUITE_P(Identity, EveryModel, testing::ValuesIn(every_model),
                         [](const auto& of) { return std::string(of.param->description->name); });

} // namespace
} // namespace raymarch::engine::identity
