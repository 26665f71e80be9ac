// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl render`: the picture that the accelerator draws for a frame, words or a preset.
#include "console/drawing.hpp"
#include "console/picture_output.hpp"
#include "console/subcommands.hpp"
#include "console/view_options.hpp"
#include "console/words.hpp"
#include "engine/models.hpp"
#include "pictures/picture_file.hpp"

#include <sysexits.h>

#include <memory>
#include <string>

namespace raymarch::console
{
namespace
{

struct Options
{
    ViewOptions view;
    DrawOptions drawing;
    std::string output;
};

Result<void> render(const Options& options)
{
    const auto accelerator = accelerator_named(options.view.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    if (const auto format = pictures::format_of(options.output); !format)
        return fail(format.error()); // before the work, not after it
    const auto size = size_of(**accelerator, options.view);
    if (!size)
        return fail(size.error());
    const auto words = words_of(**accelerator, options.view);
    if (!words)
        return fail(words.error());
    engine::Image image(*size);
    const engine::Model& model = engine::model_of(**accelerator);
    if (auto drawn = draw_picture(model, *words, options.drawing, image); !drawn)
        return drawn;
    return write_picture(image, options.output);
}

} // namespace

void add_render(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("render", "the picture that the accelerator draws, by its exact model");
    const auto options = std::make_shared<Options>();
    add_view_options(*command, options->view);
    add_draw_options(*command, options->drawing);
    command
        ->add_option("-o,--output", options->output,
                     "where to, in the format of its ending: png, jpg, ppm, tga; - is ppm on "
                     "standard output")
        ->type_name("FILE")
        ->required();
    command->callback([options, &run] {
        run = [options] {
            const auto result = render(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::console
