// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl sheet`: draws many views on one contact sheet.
#include "pictures/sheet.hpp"
#include "cli/drawing.hpp"
#include "cli/picture_output.hpp"
#include "cli/subcommands.hpp"
#include "cli/texts.hpp"
#include "cli/view_options.hpp"
#include "cli/words.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <memory>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

struct SheetOptions
{
    std::vector<std::string> views;
    std::string accelerator;
    unsigned threads = 0;
    std::uint16_t columns = 0;
    std::string output;
};

/// `view` is `NAME:PRESET`, or `NAME` for the defaults.
Result<pictures::SheetEntry> draw_view(const std::string& view, unsigned threads)
{
    ViewOptions options;
    const std::size_t colon = view.find(':');
    options.accelerator = view.substr(0, colon);
    if (colon != std::string::npos)
        options.preset = view.substr(colon + 1);
    const auto accelerator = accelerator_named(options.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    const auto words = words_of(**accelerator, options);
    if (!words)
        return fail(words.error());
    pictures::SheetEntry entry{engine::Image((*accelerator)->size),
                               fmt::format("{}{}{}", (*accelerator)->name,
                                           options.preset ? " " : "", options.preset.value_or(""))};
    draw_fastest(engine::model_of(**accelerator), *words, threads, entry.image);
    return entry;
}

/// Returns the named views, else all presets of the named accelerator, else the defaults of every
/// accelerator.
Result<std::vector<std::string>> views_of(const SheetOptions& options)
{
    if (!options.views.empty())
        return options.views;
    std::vector<std::string> views;
    if (options.accelerator.empty()) {
        for (const protocol::Accelerator* accelerator : protocol::accelerators)
            views.emplace_back(accelerator->name);
        return views;
    }
    const auto accelerator = accelerator_named(options.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    for (const protocol::Preset& preset : (*accelerator)->presets)
        views.push_back(fmt::format("{}:{}", (*accelerator)->name, preset.name));
    return views;
}

Result<void> draw_sheet(const SheetOptions& options)
{
    if (auto possible = check_picture_output(options.output); !possible)
        return possible;
    const auto views = views_of(options);
    if (!views)
        return fail(views.error());
    std::vector<pictures::SheetEntry> entries;
    for (const std::string& view : *views) {
        auto entry = draw_view(view, options.threads);
        if (!entry)
            return fail(entry.error());
        entries.push_back(std::move(*entry));
    }
    return write_picture(pictures::contact_sheet(entries, {.columns = options.columns}),
                         options.output);
}

} // namespace

void add_sheet(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand("sheet", "draws many views on one contact sheet");
    const auto options = std::make_shared<SheetOptions>();
    CLI::Option* const views =
        add_texts(*command, "VIEW", options->views,
                  "views to draw: NAME:PRESET for a preset of an accelerator, NAME for its "
                  "defaults; without any, the defaults of every accelerator");
    command
        ->add_option("--accelerator", options->accelerator,
                     "name of an accelerator; all its presets are drawn in place of views")
        ->type_name("NAME")
        ->excludes(views);
    command
        ->add_option("--columns", options->columns,
                     "number of columns of the sheet; 0, the default, makes it about square")
        ->check(CLI::Range(0, 32))
        ->type_name("N");
    add_threads_option(*command, options->threads);
    command
        ->add_option("-o,--output", options->output,
                     "file for the sheet; the ending of its name gives the format")
        ->type_name("FILE")
        ->required();
    command->callback([options, &run] {
        run = [options] {
            const auto result = draw_sheet(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
