// SPDX-License-Identifier: MIT
#include "cli/names.hpp"

#include "base/nearest.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <string>

namespace raymarch::cli
{
namespace
{

std::vector<std::string_view> without_meanings(const NamedThings& things)
{
    std::vector<std::string_view> names;
    for (const NamedThing& thing : things)
        names.push_back(thing.name);
    return names;
}

} // namespace

NamedThings accelerator_names()
{
    NamedThings names;
    for (const protocol::Accelerator* accelerator : protocol::accelerators)
        names.push_back({accelerator->name, accelerator->summary});
    return names;
}

NamedThings preset_names(const protocol::Accelerator& accelerator)
{
    NamedThings names;
    for (const protocol::Preset& preset : accelerator.presets)
        names.push_back({preset.name, preset.summary});
    return names;
}

NamedThings scene_names(const protocol::Accelerator& accelerator)
{
    return accelerator.scene ? choice_names(accelerator.parameters[*accelerator.scene])
                             : NamedThings();
}

NamedThings choice_names(const protocol::Parameter& parameter)
{
    NamedThings names;
    for (const std::string_view choice : parameter.choices)
        names.push_back({choice, {}});
    return names;
}

NamedThings key_names(const protocol::Accelerator& accelerator)
{
    NamedThings names;
    for (const protocol::Parameter& parameter : accelerator.parameters)
        if (!parameter.is_tail())
            names.push_back({parameter.key, parameter.meaning});
    return names;
}

Error has_no_scenes(const protocol::Accelerator& accelerator)
{
    return plain_error(ErrorKind::Usage, fmt::format("{} has no scenes", accelerator.name));
}

Error unknown_name(std::string_view kind, std::string_view name, const NamedThings& known)
{
    return plain_error(ErrorKind::Usage,
                       fmt::format("there is no {1} '{0}'; the {1}s are {2}{3}", name, kind,
                                   fmt::join(without_meanings(known), ", "),
                                   suggestion(name, known)));
}

std::string suggestion(std::string_view name, const NamedThings& known)
{
    return did_you_mean(name, without_meanings(known));
}

} // namespace raymarch::cli
