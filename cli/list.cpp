// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl list`: prints the names that the other subcommands take, with their meanings.
#include "cli/names.hpp"
#include "cli/subcommands.hpp"
#include "cli/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::cli
{
namespace
{

struct ListRow
{
    std::string_view name;
    std::string_view meaning;
    Result<NamedThings> (*make)(const protocol::Accelerator& accelerator);
};
constexpr std::array list_rows = {
    ListRow{
        "accelerators", "names for --accelerator",
        [](const protocol::Accelerator&) -> Result<NamedThings> { return accelerator_names(); }},
    ListRow{"presets", "names for --preset",
            [](const protocol::Accelerator& accelerator) -> Result<NamedThings> {
                return preset_names(accelerator);
            }},
    ListRow{"scenes", "names for --scene",
            [](const protocol::Accelerator& accelerator) -> Result<NamedThings> {
                if (!accelerator.scene)
                    return fail(has_no_scenes(accelerator));
                return scene_names(accelerator);
            }},
    ListRow{"keys", "keys for --set and for frames",
            [](const protocol::Accelerator& accelerator) -> Result<NamedThings> {
                return key_names(accelerator);
            }},
};

NamedThings names_of_lists()
{
    NamedThings names;
    for (const ListRow& row : list_rows)
        names.push_back({row.name, row.meaning});
    return names;
}

struct ListOptions
{
    std::string what; ///< empty means the accelerators and the names of the lists
    std::string accelerator;
};

void print(const NamedThings& things)
{
    std::size_t width = 0;
    for (const NamedThing& thing : things)
        width = std::max(width, thing.name.size());
    for (const NamedThing& thing : things)
        if (thing.meaning.empty())
            fmt::print("{}\n", thing.name);
        else
            fmt::print("{:<{}}  {}\n", thing.name, width, thing.meaning);
}

Result<void> print_overview()
{
    print(accelerator_names());
    fmt::print("\nraymarchctl list WHAT prints one of these lists for the accelerator that "
               "--accelerator names:\n");
    print(names_of_lists());
    return {};
}

Result<void> list(const ListOptions& options)
{
    const auto accelerator = accelerator_named(options.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    if (options.what.empty())
        return print_overview();
    const auto* const row = std::ranges::find(list_rows, options.what, &ListRow::name);
    if (row == list_rows.end())
        return fail(unknown_name("list", options.what, names_of_lists()));
    const auto things = row->make(**accelerator);
    if (!things)
        return fail(things.error());
    print(*things);
    return {};
}

} // namespace

void add_list(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "list", "prints the names of accelerators, presets, scenes and keys, with their meanings");
    const auto options = std::make_shared<ListOptions>();
    std::vector<std::string_view> names;
    for (const ListRow& row : list_rows)
        names.push_back(row.name);
    command
        ->add_option(
            "WHAT", options->what,
            "list to print; without it, the accelerators and the names of the lists are printed")
        ->type_name(fmt::format("{}", fmt::join(names, "|")));
    add_accelerator_option(*command, options->accelerator,
                           "name of the accelerator whose names are listed");
    command->callback([options, &run] {
        run = [options] {
            const auto result = list(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
