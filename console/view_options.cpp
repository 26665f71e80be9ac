// SPDX-License-Identifier: MIT
#include "console/view_options.hpp"

#include "console/words.hpp"
#include "protocol/assignments.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <fmt/format.h>

#include <string_view>

namespace raymarch::console
{
namespace
{

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
        {.bytes = text.substr(0, protocol::max_line_length), .too_long = too_long}, false);
    if (request.kind == protocol::Request::Kind::Faulty)
        return fail(refused(accelerator, request.fault));
    if (request.kind != protocol::Request::Kind::Frame)
        return fail(plain_error(ErrorKind::BadData, "--line takes a parameter frame"));
    protocol::State state = protocol::initial_state(accelerator);
    if (const auto fault = protocol::read_frame(accelerator, request.text, state))
        return fail(refused(accelerator, *fault));
    return state;
}

/// `state`, changed by `settings` in the syntax of SET.
Result<protocol::State> changed(const protocol::Accelerator& accelerator, protocol::State state,
                                std::string_view settings)
{
    if (const auto done = change(accelerator, settings, state); !done)
        return fail(done.error());
    return state;
}

Result<protocol::State> state_of_preset(const protocol::Accelerator& accelerator,
                                        const std::string& name)
{
    std::string names;
    for (const protocol::Preset& preset : accelerator.presets) {
        if (protocol::equal_ignoring_case(preset.name, name))
            return changed(accelerator, protocol::initial_state(accelerator), preset.settings);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", preset.name);
    }
    return fail(
        plain_error(ErrorKind::Usage, fmt::format("'{}' is no preset; there are {}", name, names)));
}

/// The defaults in that scene; the parameter is SCENE, or OBJ.
Result<protocol::State> state_of_scene(const protocol::Accelerator& accelerator,
                                       const std::string& name)
{
    for (const std::string_view key : {"SCENE", "OBJ"}) {
        const auto index = protocol::find_parameter(accelerator.parameters, key);
        if (!index)
            continue;
        const protocol::Parameter& parameter = accelerator.parameters[*index];
        protocol::State state = protocol::initial_state(accelerator);
        if (const auto code = protocol::find_choice(parameter, name)) {
            state.codes[*index] = *code;
            return state;
        }
        return fail(
            plain_error(ErrorKind::Usage, fmt::format("'{}' is no scene; there are {}", name,
                                                      fmt::join(parameter.choices, ", "))));
    }
    return fail(plain_error(ErrorKind::Usage, fmt::format("{} has no scenes", accelerator.name)));
}

} // namespace

Result<void> change(const protocol::Accelerator& accelerator, std::string_view settings,
                    protocol::State& state)
{
    protocol::ParameterSet given;
    if (const auto fault =
            protocol::read_assignments(accelerator, {.bytes = settings}, state, given))
        return fail(refused(accelerator, *fault));
    return {};
}

CLI::Option_group& add_view_options(CLI::App& command, ViewOptions& options)
{
    CLI::Option_group* const what =
        command.add_option_group("what to draw", "(default: the accelerator's defaults)");
    CLI::Option* const registers =
        what->add_option("--registers", options.words, "all parameter words, in hex, word 0 first")
            ->type_name("WORD")
            ->expected(1, static_cast<int>(protocol::max_parameter_words));
    CLI::Option* const line =
        what->add_option("--line", options.line, "a parameter frame")->type_name("LINE");
    CLI::Option* const preset =
        what->add_option("--preset", options.preset, "a view worth looking at")->type_name("NAME");
    CLI::Option* const scene =
        what->add_option("--scene", options.scene, "the defaults in this scene")->type_name("NAME");
    what->add_option("--set", options.settings, "changes to that, or to the defaults")
        ->type_name("KEY=VALUE,...")
        ->excludes(registers);
    registers->excludes(line, preset, scene);
    line->excludes(preset, scene);
    preset->excludes(scene);
    add_accelerator_option(command, options.accelerator, "which one");
    command.add_option("--size", options.size, "of the picture (default: the accelerator's)")
        ->type_name("WxH");
    return *what;
}

Result<protocol::State> state_of(const protocol::Accelerator& accelerator,
                                 const ViewOptions& options)
{
    if (!options.words.empty()) {
        const auto words = parse_words(accelerator, options.words);
        if (!words)
            return fail(words.error());
        return protocol::unpack(accelerator, *words);
    }
    auto state = options.line     ? state_of_line(accelerator, *options.line)
                 : options.preset ? state_of_preset(accelerator, *options.preset)
                 : options.scene  ? state_of_scene(accelerator, *options.scene)
                                  : protocol::initial_state(accelerator);
    if (state && options.settings)
        return changed(accelerator, *state, *options.settings);
    return state;
}

Result<protocol::Words> words_of(const protocol::Accelerator& accelerator,
                                 const ViewOptions& options)
{
    // Not through a state: the words as they were given, bits that no parameter owns among them.
    if (!options.words.empty())
        return parse_words(accelerator, options.words);
    const auto state = state_of(accelerator, options);
    if (!state)
        return fail(state.error());
    return protocol::pack(accelerator, *state);
}

Result<protocol::PictureSize> size_of(const protocol::Accelerator& accelerator,
                                      const ViewOptions& options)
{
    if (!options.size)
        return accelerator.size;
    if (const auto size = protocol::parse_size(*options.size, accelerator.max_size))
        return *size;
    return fail(plain_error(ErrorKind::Usage,
                            fmt::format("'{}' is not a size from 1x1 to {}x{}", *options.size,
                                        accelerator.max_size.width, accelerator.max_size.height)));
}

} // namespace raymarch::console
