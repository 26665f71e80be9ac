// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl render`: the picture that the accelerator draws for a frame, words or a preset.
#include "console/picture_output.hpp"
#include "console/subcommands.hpp"
#include "console/words.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "pictures/picture_file.hpp"
#include "protocol/assignments.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raymarch::console
{
namespace
{

struct Options
{
    std::string accelerator;
    std::optional<std::string> line;
    std::optional<std::string> settings;
    std::optional<std::string> preset;
    std::vector<std::string> words;
    std::optional<std::string> size;
    unsigned threads = 0;
    bool reference = false;
    std::string output;
};

Error refused(const protocol::Accelerator& accelerator, const protocol::Fault& fault)
{
    protocol::ReplyWriter reply;
    protocol::write_fault(reply, accelerator, fault);
    std::string_view text = reply.text();
    text.remove_suffix(2);
    return plain_error(ErrorKind::BadData, std::string(text));
}

Result<protocol::State> state_of_line(const protocol::Accelerator& accelerator,
                                      const std::string& text)
{
    const bool too_long = text.size() > protocol::max_line_length;
    const protocol::Request request = protocol::read_request(
        {.bytes = too_long ? std::string_view() : text, .too_long = too_long}, false);
    if (request.kind == protocol::Request::Kind::Faulty)
        return fail(refused(accelerator, request.fault));
    if (request.kind != protocol::Request::Kind::Frame)
        return fail(plain_error(ErrorKind::BadData, "--line takes a parameter frame"));
    protocol::State state;
    if (const auto fault = protocol::read_frame(accelerator, request.text, state))
        return fail(refused(accelerator, *fault));
    return state;
}

/// The defaults, changed by `settings` in the syntax of SET.
Result<protocol::State> changed_defaults(const protocol::Accelerator& accelerator,
                                         std::optional<std::string_view> settings)
{
    protocol::State state = protocol::initial_state(accelerator);
    protocol::ParameterSet given;
    if (!settings)
        return state;
    if (const auto fault =
            protocol::read_assignments(accelerator, {.bytes = *settings}, state, given))
        return fail(refused(accelerator, *fault));
    return state;
}

Result<protocol::State> state_of_preset(const protocol::Accelerator& accelerator,
                                        const std::string& name)
{
    std::string names;
    for (const protocol::Preset& preset : accelerator.presets) {
        if (protocol::equal_ignoring_case(preset.name, name))
            return changed_defaults(accelerator, preset.settings);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", preset.name);
    }
    return fail(
        plain_error(ErrorKind::Usage, fmt::format("'{}' is no preset; there are {}", name, names)));
}

Result<protocol::Words> words_to_draw(const protocol::Accelerator& accelerator,
                                      const Options& options)
{
    if (!options.words.empty())
        return parse_words(accelerator, options.words);
    const auto state = options.line     ? state_of_line(accelerator, *options.line)
                       : options.preset ? state_of_preset(accelerator, *options.preset)
                                        : changed_defaults(accelerator, options.settings);
    if (!state)
        return fail(state.error());
    return protocol::pack(accelerator, *state);
}

Result<void> render(const Options& options)
{
    const auto accelerator = accelerator_named(options.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    if (const auto format = pictures::format_of(options.output); !format)
        return fail(format.error()); // before the work, not after it
    const protocol::Accelerator& description = **accelerator;
    const auto size = options.size ? protocol::parse_size(*options.size, description.max_size)
                                   : std::optional(description.size);
    if (!size)
        return fail(
            plain_error(ErrorKind::Usage,
                        fmt::format("'{}' is not a size from 1x1 to {}x{}", *options.size,
                                    description.max_size.width, description.max_size.height)));
    const auto words = words_to_draw(description, options);
    if (!words)
        return fail(words.error());
    engine::Image image(*size);
    engine::draw_still(engine::model_of(description), *words, image, options.threads);
    return write_picture(image, options.output);
}

} // namespace

void add_render(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("render", "the picture that the accelerator draws, by its exact model");
    const auto options = std::make_shared<Options>();
    CLI::Option_group* const what =
        command->add_option_group("what to draw", "(default: the accelerator's defaults)");
    what->add_option("--line", options->line, "a parameter frame")->type_name("LINE");
    what->add_option("--registers", options->words, "all parameter words, in hex, word 0 first")
        ->type_name("WORD")
        ->expected(1, static_cast<int>(protocol::max_parameter_words));
    what->add_option("--set", options->settings, "changes to the defaults")
        ->type_name("KEY=VALUE,...");
    what->add_option("--preset", options->preset, "a view worth looking at")->type_name("NAME");
    what->require_option(0, 1);
    add_accelerator_option(*command, options->accelerator, "which one");
    command->add_option("--size", options->size, "of the picture (default: the accelerator's)")
        ->type_name("WxH");
    command->add_option("--threads", options->threads, "0 is one for each processor")
        ->check(CLI::Range(0, 256))
        ->type_name("N");
    command->add_flag(
        "--reference", options->reference,
        "with the plain scalar model that defines the bits (at present the only one)");
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
