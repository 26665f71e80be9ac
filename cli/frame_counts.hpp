// SPDX-License-Identifier: MIT
/// @file
/// What the frames of a view cost the source's hardware: what `raymarchctl cycles` prints.
#pragma once

#include "engine/model.hpp"
#include "protocol/registers.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raymarch::cli
{

/// What each pixel of a frame costs.
struct CountedFrame
{
    std::uint32_t number = 0; ///< frames before it
    std::vector<engine::PixelCost> costs;
};

/// A picture, and the frames that were drawn of it.
struct CountedView
{
    const engine::Model* model;
    protocol::Words words;
    protocol::PictureSize size;
    std::vector<CountedFrame> frames;
};

/// Draws frame `number`; without one, the frames that a still takes, as they may differ in cost.
[[nodiscard]] CountedView count(const engine::Model& model, const protocol::Words& words,
                                protocol::PictureSize size, std::optional<std::uint32_t> number,
                                unsigned threads);

/// A mean over frames, exact.
struct Mean
{
    std::uint64_t sum = 0;
    std::uint64_t count = 1;

    [[nodiscard]] double value() const noexcept
    {
        return static_cast<double>(sum) / static_cast<double>(count);
    }
};

/// `1009945.5`: up to two decimals, cut off.
[[nodiscard]] std::string text_of(Mean mean);

[[nodiscard]] Mean rays(const CountedView& view);
[[nodiscard]] Mean steps(const CountedView& view);
[[nodiscard]] Mean cycles(const CountedView& view, unsigned units);

/// Four digits, as many of them decimals as there are places: `0.2275`, `35.91`, `4812`.
[[nodiscard]] std::string four_digits(double value);

} // namespace raymarch::cli
