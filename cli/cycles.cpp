// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl cycles`: how long the source's hardware takes for a frame, by the exact model.
#include "cli/drawing.hpp"
#include "cli/frame_counts.hpp"
#include "cli/subcommands.hpp"
#include "cli/view_options.hpp"
#include "cli/words.hpp"
#include "engine/models.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace raymarch::cli
{
namespace
{

struct CyclesOptions
{
    ViewOptions view;
    std::optional<unsigned> units;
    std::optional<std::uint32_t> clock_hz;
    std::optional<std::uint32_t> frame;
    unsigned threads = 0;
};

void print_line(std::string_view key, std::string_view value)
{
    fmt::print("{:<24} {}\n", key, value);
}

std::string frames_text(const CountedView& view)
{
    const std::uint32_t first = view.frames.front().number;
    const std::uint32_t last = view.frames.back().number;
    return first == last ? fmt::format("{}", first)
                         : fmt::format("{} to {}, the mean", first, last);
}

Result<void> print_cycles(const CyclesOptions& options)
{
    const auto named = accelerator_named(options.view.accelerator);
    if (!named)
        return fail(named.error());
    const protocol::Accelerator& accelerator = **named;
    const auto size = size_of(accelerator, options.view);
    if (!size)
        return fail(size.error());
    const auto words = words_of(accelerator, options.view);
    if (!words)
        return fail(words.error());
    const engine::Model& model = engine::model_of(accelerator);
    const CountedView view = count(model, *words, *size, options.frame, options.threads);
    const unsigned units = options.units.value_or(accelerator.ray_units);
    const std::uint32_t clock_hz = options.clock_hz.value_or(accelerator.clock_hz);
    const Mean taken = cycles(view, units);

    print_line("accelerator", accelerator.name);
    print_line("size", fmt::format("{}x{}", size->width, size->height));
    print_line("units", fmt::format("{}", units));
    print_line("clock", fmt::format("{} Hz", clock_hz));
    print_line("frame", frames_text(view));
    print_line("rays", text_of(rays(view)));
    print_line("steps", fmt::format("{} {}", text_of(steps(view)), model.steps));
    print_line("cycles", text_of(taken));
    // The prototype of `sphere` takes no cycles if there is no sphere.
    print_line("fps", taken.sum == 0 ? "-" : four_digits(clock_hz / taken.value()));
    return {};
}

} // namespace

void add_cycles(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "cycles",
        "prints the clock cycles and frames a second of the source's hardware, by its exact model");
    const auto options = std::make_shared<CyclesOptions>();
    add_view_options(*command, options->view);
    command
        ->add_option("--units", options->units,
                     "number of ray units (default: the accelerator's own)")
        ->check(CLI::Range(1, 255))
        ->type_name("N");
    command
        ->add_option("--clock", options->clock_hz,
                     "clock of the ray units in Hz (default: the accelerator's own)")
        ->check(CLI::Range(1U, UINT32_MAX))
        ->type_name("HZ");
    command
        ->add_option("--frame", options->frame,
                     "number of the one frame to count, from 0 at the reset; frames of a "
                     "checkerboard differ (default: the mean of the frames of a still)")
        ->type_name("N");
    add_threads_option(*command, options->threads);
    command->callback([options, &run] {
        run = [options] {
            const auto result = print_cycles(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
