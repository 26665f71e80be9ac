// SPDX-License-Identifier: MIT
#include "tools/research/cycle_tables.hpp"

#include "engine/marcher/frame.hpp"
#include "engine/marcher/scene_query.hpp"
#include "tools/research/counted_views.hpp"
#include "tools/research/source_figures.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace raymarch::tools
{

std::string marcher_tables(unsigned threads)
{
    const Accelerator& accelerator = protocol::marcher::description;
    const PictureSize size = accelerator.size;
    std::string text = fmt::format("\nViews, {}x{} at {} MHz:\n\n", size.width, size.height,
                                   accelerator.clock_hz / 1'000'000);
    text += head("preset | clocks a query | queries a ray | fps, 1 unit | fps, 4 units");
    double sphere_queries = 0; // the queries of the first row
    unsigned sphere_clocks = 1;
    for (const std::string_view preset :
         {"", "sphere", "cube", "lattice", "lattice_diagonal", "tunnel", "tunnel_turn"}) {
        const auto words = words_with(
            accelerator, {preset.empty() ? "OBJ=sphere" : settings_of(accelerator, preset)});
        const CountedView view = drawn(accelerator, words, size, threads);
        const unsigned clocks =
            engine::marcher::scene_row(engine::marcher::latch(words).scene).clock_cycles;
        const double queries = steps(view).value() / rays(view).value();
        if (preset.empty()) {
            sphere_queries = queries;
            sphere_clocks = clocks;
        }
        text += fmt::format(
            "| {} | {} | {:.2f} | {} | {} |\n",
            preset.empty() ? "none: the defaults, a sphere" : fmt::format("`{}`", preset), clocks,
            queries, four_digits(accelerator.clock_hz / cycles(view, 1).value()),
            four_digits(accelerator.clock_hz / cycles(view, 4).value()));
    }
    text += "\nTable 9 of the source, a sphere from an unknown distance, beside the defaults; in "
            "clocks "
            "of a unit for a pixel:\n\n";
    text += head("hardware | units | source, fps | source, clocks | model, clocks | queries that "
                 "would fill the source's clocks");
    for (const source::MarcherFigure& row : source::marcher_figures) {
        const double clocks = accelerator.clock_hz * row.units / (row.fps * pixels_of(size));
        text +=
            fmt::format("| {} | {} | {} | {:.1f} | {:.1f} | {:.2f} |\n", row.hardware, row.units,
                        row.fps, clocks, sphere_queries * sphere_clocks, clocks / sphere_clocks);
    }
    return text + "\n";
}

} // namespace raymarch::tools
