// SPDX-License-Identifier: MIT
/// Draws deep views of the Mandelbulb with several arithmetics. The sheet has one row for each zoom
/// level and one column for each arithmetic (source 003, Fig. 9 and 10).
#include "command_line/command_line.hpp"
#include "drivers/user_file.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "motion/mandelbulb.hpp"
#include "pictures/picture_file.hpp"
#include "pictures/sheet.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/assignments.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/registers.hpp"
#include "tools/research/mandelbulb_reference.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <array>
#include <cassert>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::tools
{
namespace
{

namespace table = protocol::mandelbulb;
namespace mandelbulb = engine::mandelbulb;

struct CompareOptions
{
    std::string preset = "whole";
    std::vector<std::uint16_t> pixel{606, 229};
    std::vector<int> levels{12, 21, 26};
    std::string size{"320x180"};
    unsigned threads = 0;
    std::string output;
};

/// A frame that is drawn in floating point.
template <typename Real>
struct RealFrame
{
    mandelbulb::Frame exact;
};

template <typename Real>
RealFrame<Real> latch_real(engine::WordSpan words) noexcept
{
    return {mandelbulb::latch(words)};
}

template <typename Real>
void draw_row(const RealFrame<Real>& frame, engine::RowOf row, std::span<std::uint8_t> pixels,
              std::span<engine::PixelCost> costs) noexcept
{
    draw_reference_row<Real>(frame.exact, row, pixels, costs, ThetaBy::Acos);
}

template <typename Real>
std::uint64_t frame_cycles(const RealFrame<Real>& frame, engine::RowOf last_row,
                           std::span<const engine::PixelCost> costs, unsigned units) noexcept
{
    return mandelbulb::frame_cycles(frame.exact, last_row, costs, units);
}

/// One column of the sheet. `settings` are changes in the syntax of SET.
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
    model.latch = engine::latch_by<latch_real<Real>>;
    // The kernels of the exact model draw other pictures.
    model.kernels = []() noexcept { return std::span<const engine::Kernel>(); };
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

/// Returns `state` after changes in the syntax of SET.
protocol::State changed(protocol::State state, std::string_view settings)
{
    protocol::ParameterSet given;
    [[maybe_unused]] const auto fault =
        protocol::read_assignments(table::description, {.bytes = settings}, state, given);
    assert(settings.empty() || !fault); // all settings come from this file and the presets
    return state;
}

Result<protocol::State> state_of_preset(std::string_view name)
{
    for (const protocol::Preset& preset : table::description.presets)
        if (preset.name == name)
            return changed(protocol::initial_state(table::description), preset.settings);
    return fail(plain_error(ErrorKind::Usage, fmt::format("'{}' is not a preset of {}", name,
                                                          table::description.name)));
}

engine::Image draw_column(const Column& column, const protocol::State& near,
                          protocol::PictureSize size, int level, unsigned threads)
{
    protocol::State state = changed(near, column.settings);
    state.codes[table::SCALE] = motion::mandelbulb::scale_at(
        static_cast<mandelbulb::Form>(state.codes[table::FORM]), level);
    const protocol::Words words = protocol::pack(table::description, state);
    engine::Image image(size);
    engine::Painter painter(threads);
    engine::draw_still(painter, {column.model, words, engine::kernel_of(column.model)}, image);
    return image;
}

Result<void> compare(const CompareOptions& options)
{
    const auto format = pictures::format_of(options.output);
    if (!format)
        return fail(format.error());
    if (auto possible = drivers::check_output(options.output); !possible)
        return possible;
    const auto size = protocol::parse_size(options.size, table::description.max_size);
    if (!size)
        return fail(plain_error(ErrorKind::Usage, fmt::format("'{}' is not a size", options.size)));
    const auto from = state_of_preset(options.preset);
    if (!from)
        return fail(from.error());

    std::vector<pictures::SheetEntry> entries;
    for (const int level : options.levels) {
        const auto near =
            motion::mandelbulb::state_near(*from, options.pixel[0], options.pixel[1], level);
        if (!near)
            return fail(plain_error(ErrorKind::BadData, "the ray of that pixel hits nothing"));
        for (const Column& column : columns)
            entries.push_back({draw_column(column, *near, *size, level, options.threads),
                               fmt::format("z={} {}", level, column.name)});
    }
    const auto bytes = pictures::encode(
        pictures::contact_sheet(entries, {.columns = columns.size(), .cell = *size}), *format);
    if (!bytes)
        return fail(bytes.error());
    return drivers::write_output(options.output, *bytes);
}

void add_options(CLI::App& app, CompareOptions& options)
{
    const protocol::PictureSize size = table::description.size;
    app.add_option("--preset", options.preset, "name of the preset that is zoomed into")
        ->type_name("NAME")
        ->capture_default_str();
    app.add_option("--pixel", options.pixel,
                   fmt::format("pixel of that view at {}x{}, counted from the top left (default: "
                               "{})",
                               size.width, size.height, fmt::join(options.pixel, ",")))
        ->type_name("X,Y")
        ->delimiter(',')
        ->expected(2);
    app.add_option("--levels", options.levels,
                   fmt::format("zoom levels, as for raymarchctl zoom (default: {})",
                               fmt::join(options.levels, ",")))
        ->type_name("Z,...")
        ->delimiter(',')
        ->check(CLI::Range(motion::mandelbulb::min_zoom, motion::mandelbulb::max_zoom));
    app.add_option("--size", options.size, "size of each picture")
        ->type_name("WxH")
        ->capture_default_str();
    app.add_option("--threads", options.threads,
                   "number of threads that draw; 0 is one for each processor")
        ->check(CLI::Range(0U, 256U))
        ->type_name("N");
    app.add_option("-o,--output", options.output,
                   "file for the sheet; the ending of its name gives the format")
        ->type_name("FILE")
        ->required();
}

} // namespace
} // namespace raymarch::tools

int main(int argc, char** argv)
{
    CLI::App app("compare_arithmetics: deep views of the Mandelbulb by float, by double, and by "
                 "the accelerator with 32, 57 and 64 steps, side by side",
                 "compare_arithmetics");
    raymarch::prepare_command_line(app);
    raymarch::tools::CompareOptions options;
    raymarch::tools::add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    const auto done = raymarch::tools::compare(options);
    if (!done)
        fmt::print(stderr, "compare_arithmetics: {}\n", done.error().message);
    return done ? EX_OK : raymarch::exit_status(done.error().kind);
}
