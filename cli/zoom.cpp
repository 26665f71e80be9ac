// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl zoom`: prints or draws deep views of the Mandelbulb at a point of its surface.
#include "cli/drawing.hpp"
#include "cli/picture_output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/view_options.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "motion/mandelbulb.hpp"
#include "pictures/sheet.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/reply.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::cli
{
namespace
{

namespace table = protocol::mandelbulb;
using motion::mandelbulb::max_zoom;
using motion::mandelbulb::min_zoom;

struct ZoomOptions
{
    std::string preset = "whole";
    std::optional<std::string> settings;
    std::vector<std::uint16_t> pixel{606, 229};
    std::vector<int> levels{12, 21, 26};
    std::string size{"320x180"};
    unsigned threads = 0;
    std::string output;
};

/// Returns the view that is zoomed into.
Result<protocol::State> whole_view(const ZoomOptions& options)
{
    ViewOptions view;
    view.preset = options.preset;
    view.settings = options.settings;
    return state_of(table::description, view);
}

/// Returns the view at the pixel's surface point, at a zoom level.
Result<protocol::State> state_at(const protocol::State& from, const ZoomOptions& options, int level)
{
    if (const auto near =
            motion::mandelbulb::state_near(from, options.pixel[0], options.pixel[1], level))
        return *near;
    return fail(plain_error(ErrorKind::BadData,
                            fmt::format("the ray of pixel {},{} of '{}' hits nothing",
                                        options.pixel[0], options.pixel[1], options.preset)));
}

Result<void> zoom(const ZoomOptions& options)
{
    if (!options.output.empty())
        if (auto possible = check_picture_output(options.output); !possible)
            return possible;
    const auto size = protocol::parse_size(options.size, table::description.max_size);
    if (!size)
        return fail(plain_error(ErrorKind::Usage,
                                fmt::format("'{}' is not a size from 1x1 to {}x{}", options.size,
                                            table::description.max_size.width,
                                            table::description.max_size.height)));
    if (options.pixel[0] >= table::description.size.width ||
        options.pixel[1] >= table::description.size.height)
        return fail(plain_error(ErrorKind::Usage, fmt::format("--pixel must be inside {}x{}",
                                                              table::description.size.width,
                                                              table::description.size.height)));
    const auto whole = whole_view(options);
    if (!whole)
        return fail(whole.error());

    std::vector<pictures::SheetEntry> entries;
    std::optional<Progress> progress;
    if (!options.output.empty())
        progress.emplace(static_cast<unsigned>(options.levels.size()), "pictures");
    for (const int level : options.levels) {
        const auto state = state_at(*whole, options, level);
        if (!state)
            return fail(state.error());
        if (options.output.empty()) {
            protocol::ReplyWriter frame;
            protocol::write_state(frame, table::description, *state);
            fmt::print("{}\n", frame.text());
            continue;
        }
        engine::Image image(*size);
        draw_fastest(engine::model_of(table::description),
                     protocol::pack(table::description, *state), options.threads, image);
        entries.push_back({std::move(image), fmt::format("z={}", level)});
        progress->show(static_cast<unsigned>(entries.size()));
    }
    if (options.output.empty())
        return {};
    return write_picture(pictures::contact_sheet(entries, {.cell = *size}), options.output);
}

} // namespace

void add_zoom(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("zoom", "prints the frames of deep views of the Mandelbulb at the point "
                                   "that a pixel shows, or draws them");
    const auto options = std::make_shared<ZoomOptions>();
    command
        ->add_option(
            "--preset", options->preset,
            fmt::format("name of the preset of {} that is zoomed into", table::description.name))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("--set", options->settings,
                     fmt::format("changes to the preset, such as N=64,FORM=q8_64 for deep levels; "
                                 "raymarchctl list keys --accelerator {} shows the keys",
                                 table::description.name))
        ->type_name("KEY=VALUE,...");
    command
        ->add_option("--pixel", options->pixel,
                     fmt::format("pixel of that view to zoom into, as column and row of {}x{} from "
                                 "the top left (default: {})",
                                 table::description.size.width, table::description.size.height,
                                 fmt::join(options->pixel, ",")))
        ->type_name("X,Y")
        ->delimiter(',')
        ->expected(2);
    command
        ->add_option("--levels", options->levels,
                     fmt::format("zoom levels; at level Z, neighbouring rays of a picture of {} "
                                 "rows are 2^-Z apart at the surface (default: {})",
                                 table::description.size.height, fmt::join(options->levels, ",")))
        ->type_name("Z,...")
        ->delimiter(',')
        ->check(CLI::Range(min_zoom, max_zoom));
    command->add_option("--size", options->size, "size of each picture in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    add_threads_option(*command, options->threads);
    command
        ->add_option("-o,--output", options->output,
                     "file for a sheet of the pictures, in the format that the ending of its name "
                     "gives; without it, the frames are printed, one line for each level")
        ->type_name("FILE");
    command->callback([options, &run] {
        run = [options] {
            const auto result = zoom(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
