// SPDX-License-Identifier: MIT
#include "cli/texts.hpp"

#include <memory>

namespace raymarch::cli
{
namespace
{

/// CLI11's own number for it, which its help shows as dots.
constexpr int any_number = 1 << 29;

} // namespace

CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                       const std::string& meaning)
{
    const auto option = std::make_shared<CLI::Option*>(nullptr);
    *option = command.add_option(
        name,
        [option, &texts](const CLI::results_t& /*read as a list*/) {
            texts = (*option)->results(); // as they were typed
            return true;
        },
        meaning);
    // A positional argument takes further texts up to its least number, or where CLI11 may split
    // them, which is not wanted here. TakeAll has it not count them afterwards.
    const bool positional = !name.starts_with('-');
    return (*option)
        ->type_name("TEXT")
        ->expected(positional ? any_number : 1, any_number)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

} // namespace raymarch::cli
