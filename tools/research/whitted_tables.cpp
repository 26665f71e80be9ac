// SPDX-License-Identifier: MIT
#include "tools/research/cycle_tables.hpp"

#include "tools/research/counted_views.hpp"
#include "tools/research/source_figures.hpp"

#include <fmt/format.h>

#include <string>

namespace raymarch::tools
{

std::string whitted_tables(unsigned threads)
{
    const Accelerator& accelerator = protocol::whitted::description;
    std::string text =
        fmt::format("\nThe seventeen frames of Fig. 12 with `PROFILE=measured`, at {} MHz:\n\n",
                    accelerator.clock_hz / 1'000'000);
    text += head("preset | PLANES | AA | REFLECTIONS | size | source, rays | rays | source, clocks "
                 "| clocks | source, fps | fps");
    for (const source::WhittedFigure& row : source::whitted_figures) {
        const std::string changes = fmt::format("PROFILE=measured,PLANES={},AA={},REFLECTIONS={}",
                                                row.planes, row.anti_aliasing, row.reflections);
        const auto words = words_with(accelerator, {settings_of(accelerator, row.preset), changes});
        const CountedView view = drawn(accelerator, words, {row.width, row.height}, threads);
        const Mean taken = cycles(view, accelerator.ray_units);
        text += fmt::format("| `{}` | {} | {} | {} | {}x{} | {} | {} | {} | {} | {} | {:.3f} |\n",
                            row.preset, row.planes, row.anti_aliasing, row.reflections, row.width,
                            row.height, row.rays, text_of(rays(view)), row.cycles, text_of(taken),
                            row.fps, accelerator.clock_hz / taken.value());
    }
    return text + "\n";
}

} // namespace raymarch::tools
