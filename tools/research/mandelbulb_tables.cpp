// SPDX-License-Identifier: MIT
#include "tools/research/cycle_tables.hpp"

#include "engine/models.hpp"
#include "tools/research/counted_views.hpp"
#include "tools/research/source_figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace raymarch::tools
{
namespace
{

/// A view whose mean evaluations are measured on a small picture.
struct MandelbulbView
{
    std::string_view preset;
    PictureSize measured;
    PictureSize drawn; ///< the size on the board
};
constexpr std::array mandelbulb_views = {
    MandelbulbView{"front", {160, 90}, {1280, 720}},
    MandelbulbView{"whole", {160, 90}, {1280, 720}},
    MandelbulbView{"a_z12", {160, 90}, {1280, 720}},
    MandelbulbView{"a_z21", {160, 90}, {1280, 720}},
    MandelbulbView{"a_z26", {160, 90}, {1280, 720}},
    MandelbulbView{"small_board", {160, 120}, {640, 480}},
    MandelbulbView{"small_board_zoom", {160, 120}, {640, 480}},
};

/// Returns the clocks of a frame with that number of evaluations.
std::uint64_t mandelbulb_cycles(const protocol::Words& words, PictureSize size, double evaluations)
{
    const Accelerator& accelerator = protocol::mandelbulb::description;
    const std::array cost = {engine::PixelCost{.steps = static_cast<std::uint32_t>(evaluations)}};
    return engine::model_of(accelerator)
        .latch(words)
        ->cycles({.size = size}, cost, accelerator.ray_units);
}

} // namespace

std::string mandelbulb_tables(unsigned threads)
{
    const Accelerator& accelerator = protocol::mandelbulb::description;
    std::string text = fmt::format("\nViews, at {} MHz; the evaluations of a ray are the mean of a "
                                   "small picture of the same view:\n\n",
                                   accelerator.clock_hz / 1'000'000);
    text += head("preset | measured at | evaluations a ray | frame | clocks | fps");
    for (const MandelbulbView& row : mandelbulb_views) {
        const auto words = words_with(accelerator, {settings_of(accelerator, row.preset)});
        const CountedView view = drawn(accelerator, words, row.measured, threads);
        const double mean = steps(view).value() / rays(view).value();
        const std::uint64_t taken =
            mandelbulb_cycles(words, row.drawn, std::round(mean * pixels_of(row.drawn)));
        text += fmt::format("| `{}` | {}x{} | {:.2f} | {}x{} | {} | {} |\n", row.preset,
                            row.measured.width, row.measured.height, mean, row.drawn.width,
                            row.drawn.height, taken,
                            four_digits(accelerator.clock_hz / static_cast<double>(taken)));
    }

    text += "\nThe source's figures, with the evaluations a ray that they mean:\n\n";
    text += head("board | frame | | source, fps | evaluations a ray");
    const auto words = words_with(accelerator, {});
    for (const source::MandelbulbFigure& row : source::mandelbulb_figures) {
        const PictureSize size{row.width, row.height};
        const double fill = static_cast<double>(mandelbulb_cycles(words, size, 0));
        const double one_each =
            static_cast<double>(mandelbulb_cycles(words, size, pixels_of(size))) - fill;
        text += fmt::format("| {} | {}x{} | {} | {} | {:.1f} |\n", row.board, row.width, row.height,
                            row.claim, row.fps, (accelerator.clock_hz / row.fps - fill) / one_each);
    }
    return text + "\n";
}

} // namespace raymarch::tools
