// SPDX-License-Identifier: MIT
/// @file
/// Counts the cycles, rays and steps of a view's frames in the source's hardware.
#pragma once

#include "engine/model.hpp"
#include "protocol/registers.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raymarch::cli
{

struct CountedFrame
{
    std::uint32_t number = 0; ///< counts from 0 at the reset
    std::vector<engine::PixelCost> costs;
};

/// A view and its drawn frames.
struct CountedView
{
    const engine::Model* model;
    protocol::Words words;
    protocol::PictureSize size;
    std::vector<CountedFrame> frames;
};

/// Draws frame `number`. Without a number, draws all frames of a still, because their costs may
/// differ.
[[nodiscard]] CountedView count(const engine::Model& model, const protocol::Words& words,
                                protocol::PictureSize size, std::optional<std::uint32_t> number,
                                unsigned threads);

/// An exact mean over frames.
struct Mean
{
    std::uint64_t sum = 0;
    std::uint64_t count = 1;

    [[nodiscard]] double value() const noexcept
    {
        return static_cast<double>(sum) / static_cast<double>(count);
    }
};

/// Writes up to two decimals without rounding: `1009945.5`.
[[nodiscard]] std::string text_of(Mean mean);

[[nodiscard]] Mean rays(const CountedView& view);
[[nodiscard]] Mean steps(const CountedView& view);
[[nodiscard]] Mean cycles(const CountedView& view, unsigned units);

/// Writes four significant digits: `0.2275`, `35.91`, `4812`.
[[nodiscard]] std::string four_digits(double value);

} // namespace raymarch::cli
