// SPDX-License-Identifier: MIT
#include "cli/words.hpp"

#include "cli/names.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace raymarch::cli
{

Result<protocol::Words> parse_words(const protocol::Accelerator& accelerator,
                                    const std::vector<std::string>& texts)
{
    if (texts.size() != accelerator.word_count)
        return fail(plain_error(ErrorKind::Usage,
                                fmt::format("{} has {} register words, not {}", accelerator.name,
                                            accelerator.word_count, texts.size())));
    protocol::Words words{};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        std::string_view digits = texts[i];
        if (digits.starts_with("0x") || digits.starts_with("0X"))
            digits.remove_prefix(2);
        const char* const end = digits.data() + digits.size();
        const auto parsed = std::from_chars(digits.data(), end, words[i], 16);
        if (parsed.ec != std::errc{} || parsed.ptr != end || digits.size() > 8)
            return fail(
                plain_error(ErrorKind::Usage,
                            fmt::format("word {}: '{}' is not 1 to 8 hex digits", i, texts[i])));
    }
    return words;
}

void add_accelerator_option(CLI::App& command, std::string& name, const std::string& meaning)
{
    if (name.empty())
        name = protocol::default_accelerator.name;
    command.add_option("--accelerator", name, fmt::format("{} (default: {})", meaning, name))
        ->type_name("NAME");
}

Result<const protocol::Accelerator*> accelerator_named(const std::string& name)
{
    if (const protocol::Accelerator* const found = protocol::find_accelerator(name))
        return found;
    return fail(unknown_name("accelerator", name, accelerator_names()));
}

} // namespace raymarch::cli
