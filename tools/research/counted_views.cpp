// SPDX-License-Identifier: MIT
#include "tools/research/counted_views.hpp"

#include "engine/models.hpp"
#include "protocol/assignments.hpp"

#include <fmt/format.h>

#include <cassert>
#include <optional>

namespace raymarch::tools
{

protocol::Words words_with(const Accelerator& accelerator,
                           std::initializer_list<std::string_view> changes)
{
    protocol::State state = protocol::initial_state(accelerator);
    for (const std::string_view text : changes) {
        protocol::ParameterSet given;
        [[maybe_unused]] const auto fault =
            protocol::read_assignments(accelerator, {.bytes = text}, state, given);
        assert(text.empty() || !fault); // all texts come from this folder and the presets
    }
    return protocol::pack(accelerator, state);
}

std::string_view settings_of(const Accelerator& accelerator, std::string_view preset)
{
    for (const protocol::Preset& row : accelerator.presets)
        if (row.name == preset)
            return row.settings;
    assert(false);
    return {};
}

CountedView drawn(const Accelerator& accelerator, const protocol::Words& words, PictureSize size,
                  unsigned threads)
{
    return cli::count(engine::model_of(accelerator), words, size, std::nullopt, threads);
}

double pixels_of(PictureSize size)
{
    return double{1} * size.width * size.height;
}

std::string head(std::string_view columns)
{
    std::string rule = "|";
    for (const char c : columns)
        rule += c == '|' ? " --- |" : "";
    return fmt::format("| {} |\n{} --- |\n", columns, rule);
}

} // namespace raymarch::tools
