// SPDX-License-Identifier: MIT
#include "cli/view_options.hpp"

#include "cli/names.hpp"
#include "cli/texts.hpp"
#include "cli/words.hpp"
#include "protocol/assignments.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace raymarch::cli
{
namespace
{

/// Suggests the name that was meant if the fault in `line` is a mistyped name.
std::string suggestion_for(const protocol::Accelerator& accelerator, const protocol::Fault& fault,
                           std::string_view line)
{
    if (fault.code == protocol::ErrorCode::UnknownKey)
        return suggestion(fault.word, key_names(accelerator));
    if (fault.code != protocol::ErrorCode::Object || !fault.parameter || fault.column == 0)
        return {};
    const std::string_view value = line.substr(std::min(fault.column - 1, line.size()));
    return suggestion(protocol::Text{value.substr(0, value.find(','))}.trimmed().bytes,
                      choice_names(accelerator.parameters[*fault.parameter]));
}

/// Makes the error from the reply of the service and a suggestion.
Error refused(const protocol::Accelerator& accelerator, const protocol::Fault& fault,
              std::string_view line)
{
    protocol::ReplyWriter reply;
    protocol::write_fault(reply, accelerator, fault);
    std::string_view text = reply.text();
    text.remove_suffix(2);
    return plain_error(ErrorKind::BadData,
                       std::string(text) + suggestion_for(accelerator, fault, line));
}

Result<protocol::State> state_of_line(const protocol::Accelerator& accelerator,
                                      const std::string& text)
{
    const std::string_view bytes = text;
    const protocol::Request request =
        protocol::read_request({.bytes = bytes.substr(0, protocol::max_line_length),
                                .too_long = bytes.size() > protocol::max_line_length},
                               false);
    if (request.kind == protocol::Request::Kind::Faulty)
        return fail(refused(accelerator, request.fault, bytes));
    if (request.kind != protocol::Request::Kind::Frame)
        return fail(plain_error(ErrorKind::BadData, "--line takes a parameter frame"));
    protocol::State state = protocol::initial_state(accelerator);
    if (const auto fault = protocol::read_frame(accelerator, request.text, state))
        return fail(refused(accelerator, *fault, bytes));
    return state;
}

/// Applies `settings`, in the syntax of SET, to `state`.
Result<protocol::State> changed(const protocol::Accelerator& accelerator, protocol::State state,
                                std::string_view settings)
{
    if (const auto done = change(accelerator, settings, state); !done)
        return fail(done.error());
    return state;
}

const protocol::Preset* find_preset(const protocol::Accelerator& accelerator, std::string_view name)
{
    for (const protocol::Preset& preset : accelerator.presets)
        if (protocol::equal_ignoring_case(preset.name, name))
            return &preset;
    return nullptr;
}

Result<protocol::State> state_of_preset(const protocol::Accelerator& accelerator,
                                        const std::string& name)
{
    if (const protocol::Preset* const preset = find_preset(accelerator, name))
        return changed(accelerator, protocol::initial_state(accelerator), preset->settings);
    for (const protocol::Accelerator* const other : protocol::accelerators)
        if (find_preset(*other, name) != nullptr)
            return fail(
                plain_error(ErrorKind::Usage, fmt::format("'{}' is a preset of {}, not of {}", name,
                                                          other->name, accelerator.name)));
    return fail(unknown_name("preset", name, preset_names(accelerator)));
}

/// Returns the defaults with another scene.
Result<protocol::State> state_of_scene(const protocol::Accelerator& accelerator,
                                       const std::string& name)
{
    if (!accelerator.scene)
        return fail(has_no_scenes(accelerator));
    const auto code = protocol::find_choice(accelerator.parameters[*accelerator.scene], name);
    if (!code)
        return fail(unknown_name("scene", name, scene_names(accelerator)));
    protocol::State state = protocol::initial_state(accelerator);
    state.codes[*accelerator.scene] = *code;
    return state;
}

} // namespace

Result<void> change(const protocol::Accelerator& accelerator, std::string_view settings,
                    protocol::State& state)
{
    protocol::ParameterSet given;
    if (const auto fault =
            protocol::read_assignments(accelerator, {.bytes = settings}, state, given))
        return fail(refused(accelerator, *fault, settings));
    return {};
}

CLI::Option_group& add_view_options(CLI::App& command, ViewOptions& options)
{
    CLI::Option_group* const what = command.add_option_group(
        "what to draw", "(without any of these, the accelerator's defaults are drawn)");
    CLI::Option* const registers =
        add_texts(*what, "--registers", options.words,
                  "register words of the view, all of them in hexadecimal, word 0 first")
            ->type_name("WORD")
            ->expected(1, static_cast<int>(protocol::max_parameter_words));
    CLI::Option* const line =
        what->add_option("--line", options.line, "parameter frame of the view")->type_name("LINE");
    CLI::Option* const preset =
        what->add_option("--preset", options.preset,
                         "name of a preset; raymarchctl list presets shows them")
            ->type_name("NAME");
    CLI::Option* const scene =
        what->add_option(
                "--scene", options.scene,
                "name of a scene, drawn with the defaults; raymarchctl list scenes shows them")
            ->type_name("NAME");
    what->add_option("--set", options.settings,
                     "changes to the view or to the defaults; raymarchctl list keys shows the keys")
        ->type_name("KEY=VALUE,...")
        ->excludes(registers);
    registers->excludes(line, preset, scene);
    line->excludes(preset, scene);
    preset->excludes(scene);
    add_accelerator_option(command, options.accelerator, "name of the accelerator that draws");
    command
        .add_option("--size", options.size,
                    "size of the picture in pixels (default: the accelerator's own)")
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
    // A state would lose the bits of words that belong to no parameter.
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

} // namespace raymarch::cli
