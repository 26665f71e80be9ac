// SPDX-License-Identifier: MIT
#include "console/texts.hpp"

#include <memory>

namespace raymarch::console
{

CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                       const std::string& meaning)
{
    // CLI11 takes options of at least 2^25 texts one text at a time; nobody types so many.
    constexpr int many = 1'000'000;
    const auto option = std::make_shared<CLI::Option*>(nullptr);
    *option = command.add_option(
        name,
        [option, &texts](const CLI::results_t& /*read as a list*/) {
            texts = (*option)->results(); // as they were typed
            return true;
        },
        meaning);
    return (*option)->type_name("TEXT")->expected(1, many)->allow_extra_args(false);
}

} // namespace raymarch::console
