// SPDX-License-Identifier: MIT
#include "cli/texts.hpp"

#include <memory>

namespace raymarch::cli
{
namespace
{

/// CLI11 uses this number, and shows it as dots in the help text.
constexpr int any_number = 1 << 29;

} // namespace

CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                       const std::string& meaning)
{
    const auto option = std::make_shared<CLI::Option*>(nullptr);
    *option = command.add_option(
        name,
        [option, &texts](const CLI::results_t& /*read as a list*/) {
            texts = (*option)->results(); // the unchanged arguments
            return true;
        },
        meaning);
    // A positional argument takes all texts only if their least number is large, or if CLI11 may
    // split them. With TakeAll, CLI11 does not check the number afterwards.
    const bool positional = !name.starts_with('-');
    return (*option)
        ->type_name("TEXT")
        ->expected(positional ? any_number : 1, any_number)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

} // namespace raymarch::cli
