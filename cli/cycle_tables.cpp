// SPDX-License-Identifier: MIT
#include "cli/cycle_tables.hpp"

#include "cli/frame_counts.hpp"
#include "cli/source_figures.hpp"
#include "engine/fractal/frame.hpp"
#include "engine/fractal/scenes.hpp"
#include "engine/marcher/frame.hpp"
#include "engine/marcher/scene_query.hpp"
#include "engine/models.hpp"
#include "engine/sphere/timeline.hpp"
#include "protocol/assignments.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <span>
#include <string_view>
#include <vector>

namespace raymarch::cli
{
namespace
{

using protocol::Accelerator;
using protocol::PictureSize;

/// The defaults, changed by one text in the syntax of SET behind the other.
protocol::Words words_with(const Accelerator& accelerator,
                           std::initializer_list<std::string_view> changes)
{
    protocol::State state = protocol::initial_state(accelerator);
    for (const std::string_view text : changes) {
        protocol::ParameterSet given;
        [[maybe_unused]] const auto fault =
            protocol::read_assignments(accelerator, {.bytes = text}, state, given);
        assert(text.empty() || !fault); // the texts stand in this file and in the presets
    }
    return protocol::pack(accelerator, state);
}

std::string_view settings_of(const Accelerator& accelerator, std::string_view preset)
{
    for (const protocol::Preset& row : accelerator.presets)
        if (row.name == preset)
            return row.settings;
    assert(false);
    return {};
}

CountedView drawn(const Accelerator& accelerator, const protocol::Words& words, PictureSize size,
                  unsigned threads)
{
    return count(engine::model_of(accelerator), words, size, std::nullopt, threads);
}

double pixels_of(PictureSize size)
{
    return double{1} * size.width * size.height;
}

/// A table's head, of columns divided by `|`.
std::string head(std::string_view columns)
{
    std::string rule = "|";
    for (const char c : columns)
        rule += c == '|' ? " --- |" : "";
    return fmt::format("| {} |\n{} --- |\n", columns, rule);
}

} // namespace

std::string marcher_tables(unsigned threads)
{
    const Accelerator& accelerator = protocol::marcher::description;
    const PictureSize size = accelerator.size;
    std::string text = fmt::format("\nViews, {}x{} at {} MHz:\n\n", size.width, size.height,
                                   accelerator.clock_hz / 1'000'000);
    text += head("preset | clocks a query | queries a ray | fps, 1 unit | fps, 4 units");
    double sphere_queries = 0; // of the first row
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

namespace
{

using FractalSpeeds = std::array<double, source::fractal_units.size()>;

std::string slashed(const FractalSpeeds& speeds)
{
    return fmt::format("{:.1f} / {:.1f} / {:.1f}", speeds[0], speeds[1], speeds[2]);
}

std::string slashed(const std::array<unsigned, source::fractal_units.size()>& speeds)
{
    return fmt::format("{} / {} / {}", speeds[0], speeds[1], speeds[2]);
}

/// Frames a second where every ray takes `queries`, on average over where the index stands when a
/// unit becomes idle: a clock divisible by the steps that both take in common.
FractalSpeeds speeds_at(double queries, unsigned latency, bool checker)
{
    constexpr double overhead = 20;
    const Accelerator& accelerator = protocol::fractal::description;
    const double pixels = pixels_of(accelerator.size);
    FractalSpeeds speeds{};
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const unsigned units = source::fractal_units[i];
        const double slots = (overhead + queries * (latency + 1)) / units +
                             (units - std::gcd(units, latency + 1)) / (2.0 * units);
        speeds[i] = accelerator.clock_hz / (checker ? pixels / 2 * (slots + 1) : pixels * slots);
    }
    return speeds;
}

/// The queries a ray that explain a row of the source best: the least sum of squared relative
/// misses. A figure above the one of more units is left out.
double fitted_queries(const source::FractalFigure& row, unsigned latency)
{
    constexpr double step = 0.05;
    double best = 0;
    double least = INFINITY;
    for (int i = 20; i <= 640; ++i) { // 1 to 32 queries
        double sum = 0;
        for (const bool checker : {false, true}) {
            const auto& wanted = checker ? row.checker : row.plain;
            const FractalSpeeds speeds = speeds_at(i * step, latency, checker);
            for (std::size_t k = 0; k < speeds.size(); ++k)
                if (k + 1 == speeds.size() || wanted[k] < wanted[k + 1])
                    sum += std::pow(speeds[k] / wanted[k] - 1, 2);
        }
        if (sum < least) {
            least = sum;
            best = i * step;
        }
    }
    return best;
}

} // namespace

std::string fractal_tables(unsigned threads)
{
    const Accelerator& accelerator = protocol::fractal::description;
    std::string start = "\nThe start view, on 4, 8 and 12 units; of a checkerboard the mean of a "
                        "still's frames:\n\n";
    start += head("scene | queries a ray | clocks | fps | source, fps");
    std::string fitted = "\nThe same figures where every ray takes one number of queries, fitted "
                         "to each of the source's scenes:\n\n";
    fitted += head("scene | fitted queries | fps | source, fps | fps, checkerboard | source, fps");
    for (const source::FractalFigure& row : source::fractal_figures) {
        unsigned latency = 0;
        for (const bool checker : {false, true}) {
            const auto words =
                words_with(accelerator,
                           {fmt::format("SCENE={},CHECKER={}", row.scene, checker ? "on" : "off")});
            latency = engine::fractal::scene_row(engine::fractal::latch(words).scene).latency;
            const CountedView view = drawn(accelerator, words, accelerator.size, threads);
            std::string clocks;
            FractalSpeeds speeds{};
            for (std::size_t i = 0; i < speeds.size(); ++i) {
                const Mean taken = cycles(view, source::fractal_units[i]);
                clocks += (i == 0 ? "" : " / ") + text_of(taken);
                speeds[i] = accelerator.clock_hz / taken.value();
            }
            start += fmt::format("| {}{} | {:.2f} | {} | {} | {} |\n", row.scene,
                                 checker ? ", checkerboard" : "",
                                 steps(view).value() / rays(view).value(), clocks, slashed(speeds),
                                 slashed(checker ? row.checker : row.plain));
        }
        const double queries = fitted_queries(row, latency);
        fitted += fmt::format("| {} | {:.2f} | {} | {} | {} | {} |\n", row.scene, queries,
                              slashed(speeds_at(queries, latency, false)), slashed(row.plain),
                              slashed(speeds_at(queries, latency, true)), slashed(row.checker));
    }
    return start + fitted + "\n";
}

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

namespace
{

/// A view whose mean evaluations are measured on a small picture.
struct MandelbulbView
{
    std::string_view preset;
    PictureSize measured;
    PictureSize drawn; ///< the board's
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

/// Clocks of a frame of so many evaluations in all.
std::uint64_t mandelbulb_cycles(const protocol::Words& words, PictureSize size, double evaluations)
{
    const Accelerator& accelerator = protocol::mandelbulb::description;
    const std::array cost = {engine::PixelCost{.steps = static_cast<std::uint32_t>(evaluations)}};
    return engine::model_of(accelerator)
        .frame_cycles(words, {.size = size}, cost, accelerator.ray_units);
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

} // namespace raymarch::cli
