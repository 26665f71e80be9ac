// SPDX-License-Identifier: MIT
/// @file
/// Holds the kernels to the reference: every byte and every cost, in whole pictures and in parts.
#pragma once

#include "engine/draw.hpp"
#include "engine/models.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

namespace raymarch::protocol
{

/// A preset's name stands for it in the output of GoogleTest.
inline void PrintTo(const Preset& preset, std::ostream* stream)
{
    *stream << preset.name;
}

} // namespace raymarch::protocol

namespace raymarch::engine
{

/// The name of a model's accelerator stands for it in the output of GoogleTest.
inline void PrintTo(const Model* model, std::ostream* stream)
{
    *stream << (model != nullptr ? model->description->name : "none");
}

} // namespace raymarch::engine

namespace raymarch::engine::identity
{

/// The model's kernels that this machine runs.
inline std::vector<const Kernel*> kernels_here(const Model& model)
{
    std::vector<const Kernel*> kernels;
    for (const IsaRow& row : isa_rows)
        if (const Kernel* const kernel = kernel_of(model, row.isa))
            kernels.push_back(kernel);
    return kernels;
}

/// What a region's drawing leaves in a picture that was grey before.
struct Drawn
{
    std::vector<std::uint8_t> rgb;
    std::vector<PixelCost> costs; ///< empty: not asked for
};

enum class Costs : bool { Unwanted, Wanted };

inline Drawn draw_region(const Model& model, const Kernel* kernel, WordSpan words,
                         const Region& region, Costs wanted)
{
    constexpr std::uint8_t grey = 0x5A;
    const std::size_t pixels = std::size_t{region.size.width} * region.size.height;
    Drawn drawn{std::vector(bytes_per_pixel * pixels, grey),
                std::vector(wanted == Costs::Wanted ? pixels : 0, PixelCost{grey, grey})};
    Painter painter(1);
    painter.draw({model, words, kernel}, region, {drawn.rgb, drawn.costs});
    return drawn;
}

/// FNV-1a, to name a picture by.
inline std::uint64_t hash_of(const std::vector<std::uint8_t>& bytes)
{
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325;
    for (const std::uint8_t byte : bytes)
        hash = (hash ^ byte) * 0x100'0000'01B3;
    return hash;
}

inline std::string text_of(WordSpan words)
{
    std::string text;
    for (const std::uint32_t word : words)
        text += testing::PrintToString(word) + " ";
    return text;
}

/// Fails with the hashes and the first pixel or cost that differs.
inline testing::AssertionResult same(const Drawn& expected, const Drawn& drawn, unsigned width)
{
    if (expected.rgb == drawn.rgb && (drawn.costs.empty() || expected.costs == drawn.costs))
        return testing::AssertionSuccess();
    const std::size_t pixels = expected.rgb.size() / bytes_per_pixel;
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto pixel = [&](const Drawn& of) {
            return std::vector<int>(of.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i),
                                    of.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
        };
        const bool costs_differ = !drawn.costs.empty() && drawn.costs[i] != expected.costs[i];
        if (pixel(expected) == pixel(drawn) && !costs_differ)
            continue;
        auto failure = testing::AssertionFailure();
        failure << "pixel " << i % width << "," << i / width << ": expected "
                << testing::PrintToString(pixel(expected)) << ", drawn "
                << testing::PrintToString(pixel(drawn));
        if (costs_differ)
            failure << "; steps " << expected.costs[i].steps << ", drawn " << drawn.costs[i].steps
                    << "; rays " << expected.costs[i].rays << ", drawn " << drawn.costs[i].rays;
        return failure << "; hash " << std::hex << hash_of(expected.rgb) << ", drawn "
                       << hash_of(drawn.rgb);
    }
    return testing::AssertionSuccess();
}

/// Every kernel that runs here against the reference, with costs and without.
inline void expect_identity(const Model& model, WordSpan words, const Region& region)
{
    const Drawn expected = draw_region(model, nullptr, words, region, Costs::Wanted);
    for (const Kernel* const kernel : kernels_here(model))
        for (const Costs wanted : {Costs::Unwanted, Costs::Wanted})
            EXPECT_TRUE(same(expected, draw_region(model, kernel, words, region, wanted),
                             region.size.width))
                << name_of(kernel->isa) << (wanted == Costs::Wanted ? ", counted" : "") << ", "
                << region.size.width << "x" << region.size.height << " from " << region.x << ","
                << region.y << ": " << region.width << "x" << region.height << " step "
                << region.step << " frame " << region.frame << "; words " << text_of(words);
}

} // namespace raymarch::engine::identity
