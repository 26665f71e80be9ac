// SPDX-License-Identifier: MIT
#include "tools/research/cycle_tables.hpp"

#include "engine/sphere/timeline.hpp"
#include "tools/research/counted_views.hpp"
#include "tools/research/source_figures.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace raymarch::tools
{

std::string sphere_tables(unsigned threads)
{
    using engine::sphere::Outcome;
    const Accelerator& accelerator = protocol::sphere::description;
    const double pixels = pixels_of(accelerator.size);
    const auto fps_at = [&](double clocks_a_pixel) {
        return four_digits(accelerator.clock_hz / (clocks_a_pixel * pixels));
    };
    const auto period = [](Outcome outcome) { return engine::sphere::row_of(outcome).period; };

    std::string text =
        fmt::format("\nWhole screens of one outcome, {}x{} at {} MHz:\n\n", accelerator.size.width,
                    accelerator.size.height, accelerator.clock_hz / 1'000'000);
    text += head("every pixel | clocks a pixel | fps");
    text += fmt::format("| misses | {} | {} |\n", period(Outcome::Missed),
                        fps_at(period(Outcome::Missed)));
    text += fmt::format("| lit | {} | {} |\n", period(Outcome::LitClear),
                        fps_at(period(Outcome::LitClear)));
    text += fmt::format("| in shadow | {} | {} |\n", period(Outcome::Shadowed),
                        fps_at(period(Outcome::Shadowed)));

    text += "\nFrames:\n\n";
    text += head("view | settings | sphere, share of the screen | clocks | fps");
    struct View
    {
        std::string_view name;
        std::string_view settings;
    };
    for (const View& row : {View{"the first after power-up", "S1.X=325"},
                            View{"the same, corrected", "S1.X=325,FAULTS=corrected"},
                            View{"a small sphere", "S1.X=325,S1.R=60"}, View{"none", "N=0"}}) {
        const CountedView view =
            drawn(accelerator, words_with(accelerator, {row.settings}), accelerator.size, threads);
        double covered = 0;
        for (const engine::PixelCost& cost : view.frames.front().costs)
            covered += cost.steps == period(Outcome::Missed) ? 0 : 1;
        const Mean taken = cycles(view, accelerator.ray_units);
        text += fmt::format("| {} | `{}` | {:.1f} % | {} | {} |\n", row.name, row.settings,
                            100 * covered / pixels, text_of(taken),
                            four_digits(accelerator.clock_hz / taken.value()));
    }

    text += "\nWhat the source says:\n\n";
    text += head("claim | source, clocks a pixel | fps at these | source, fps | clocks a pixel "
                 "that its fps need");
    for (const source::SphereFigure& row : source::sphere_figures)
        text += fmt::format("| {} | {} | {} | {} | {:.0f} |\n", row.claim,
                            row.clocks == 0 ? "-" : fmt::format("{}", row.clocks),
                            row.clocks == 0 ? "-" : fps_at(row.clocks), row.fps,
                            accelerator.clock_hz / (row.fps * pixels));
    return text + "\n";
}

} // namespace raymarch::tools
