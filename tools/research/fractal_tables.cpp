// SPDX-License-Identifier: MIT
#include "tools/research/cycle_tables.hpp"

#include "engine/fractal/frame.hpp"
#include "engine/fractal/scenes.hpp"
#include "tools/research/counted_views.hpp"
#include "tools/research/source_figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

namespace raymarch::tools
{
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

/// Returns the frames a second if every ray takes `queries`. It is the mean over all positions of
/// the index at which a unit becomes idle.
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

/// Fits the queries of a ray to a row of the source, by the least sum of squared relative errors. A
/// figure above that of more units is not used.
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

} // namespace raymarch::tools
