// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl zoom`: deep views of the Mandelbulb at a point of its surface: as frames, or as a
/// sheet that sets each arithmetic's picture beside the others (source 003, Fig. 9 and 10).
#include "cli/drawing.hpp"
#include "cli/mandelbulb_reference.hpp"
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

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

namespace table = protocol::mandelbulb;
namespace mandelbulb = engine::mandelbulb;
using motion::mandelbulb::max_zoom;
using motion::mandelbulb::min_zoom;

struct ZoomOptions
{
    std::string preset = "whole";
    std::vector<unsigned> pixel{606, 229};
    std::vector<int> levels{12, 21, 26};
    std::string size{"320x180"};
    unsigned threads = 0;
    std::string output;
};

template <typename Real>
void draw_row_in(engine::WordSpan words, engine::RowOf row, std::span<std::uint8_t> pixels,
                 std::span<engine::PixelCost> costs) noexcept
{
    draw_reference_row<Real>(mandelbulb::latch(words), row, pixels, costs, ThetaBy::Acos);
}

/// One column of the sheet: an arithmetic. `settings` are changes in the syntax of SET.
struct Column
{
    std::string_view name;
    std::string_view settings;
    engine::Model model;
};
template <typename Real>
constexpr engine::Model in_floating_point()
{
    engine::Model model = engine::model_of(table::description);
    model.draw_row = draw_row_in<Real>;
    model.kernels = nullptr; // they are those of the exact model
    return model;
}
constexpr engine::Model exact = engine::model_of(table::description);
constexpr std::array columns = {
    Column{"float", "", in_floating_point<float>()},
    Column{"double", "", in_floating_point<double>()},
    Column{"N=32", "N=32,FORM=q8_57", exact},
    Column{"N=57", "N=57,FORM=q8_57", exact},
    Column{"N=64", "N=64,FORM=q8_64", exact},
};

Result<protocol::State> state_of_preset(const std::string& name)
{
    ViewOptions view;
    view.preset = name;
    return state_of(table::description, view);
}

/// The view of the pixel's point at a level; deep ones take more steps and iterations.
Result<protocol::State> state_at(const protocol::State& from, const ZoomOptions& options, int level)
{
    const motion::mandelbulb::World world = motion::mandelbulb::enter(from);
    const auto near = motion::mandelbulb::approach(
        world.frame, table::description.size, static_cast<std::uint16_t>(options.pixel[0]),
        static_cast<std::uint16_t>(options.pixel[1]), level);
    if (!near)
        return fail(plain_error(ErrorKind::BadData,
                                fmt::format("the ray of pixel {},{} of '{}' hits nothing",
                                            options.pixel[0], options.pixel[1], options.preset)));
    protocol::State state = from;
    motion::mandelbulb::leave({*near}, state);
    return state;
}

Result<engine::Image> draw_column(const Column& column, const protocol::State& state,
                                  protocol::PictureSize size, int level, unsigned threads)
{
    protocol::State changed = state;
    if (!column.settings.empty())
        if (const auto done = change(table::description, column.settings, changed); !done)
            return fail(done.error());
    const auto form = static_cast<mandelbulb::Form>(changed.codes[table::FORM]);
    changed.codes[table::SCALE] = motion::mandelbulb::scale_at(form, level);
    engine::Image image(size);
    draw_fastest(column.model, protocol::pack(table::description, changed), threads, image);
    return image;
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
        return fail(plain_error(ErrorKind::Usage, fmt::format("the pixel is one of {}x{}",
                                                              table::description.size.width,
                                                              table::description.size.height)));
    const auto whole = state_of_preset(options.preset);
    if (!whole)
        return fail(whole.error());

    std::vector<pictures::SheetEntry> entries;
    std::optional<Progress> progress;
    if (!options.output.empty())
        progress.emplace(static_cast<unsigned>(options.levels.size() * columns.size()), "pictures");
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
        for (const Column& column : columns) {
            auto image = draw_column(column, *state, *size, level, options.threads);
            if (!image)
                return fail(image.error());
            entries.push_back({std::move(*image), fmt::format("z={} {}", level, column.name)});
            progress->show(static_cast<unsigned>(entries.size()));
        }
    }
    if (options.output.empty())
        return {};
    const pictures::SheetLayout layout = {.columns = columns.size(), .cell = *size};
    return write_picture(pictures::contact_sheet(entries, layout), options.output);
}

} // namespace

void add_zoom(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "zoom", "deep views of the mandelbulb at a point that a pixel shows: frames, or a sheet "
                "of pictures by float, double and the accelerator's arithmetic");
    const auto options = std::make_shared<ZoomOptions>();
    command
        ->add_option(
            "--preset", options->preset,
            fmt::format("the preset of {} whose pixel is approached", table::description.name))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("--pixel", options->pixel,
                     fmt::format("a pixel of that view at {}x{}, from the top left (default: {})",
                                 table::description.size.width, table::description.size.height,
                                 fmt::join(options->pixel, ",")))
        ->type_name("X,Y")
        ->delimiter(',')
        ->expected(2);
    command
        ->add_option(
            "--levels", options->levels,
            fmt::format("zoom levels: at level Z neighbouring rays of a picture of {} rows are "
                        "2^-Z apart at the surface (default: {})",
                        table::description.size.height, fmt::join(options->levels, ",")))
        ->type_name("Z,...")
        ->delimiter(',')
        ->check(CLI::Range(min_zoom, max_zoom));
    command->add_option("--size", options->size, "size of each picture")
        ->type_name("WxH")
        ->capture_default_str();
    add_threads_option(*command, options->threads);
    command
        ->add_option("-o,--output", options->output,
                     "the sheet, in the format of its ending; without it the frames are printed, "
                     "one line a level")
        ->type_name("FILE");
    command->callback([options, &run] {
        run = [options] {
            const auto result = zoom(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
