// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl decode`: converts register words to the frame that they hold.
#include "cli/subcommands.hpp"
#include "cli/texts.hpp"
#include "cli/words.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <memory>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

struct DecodeOptions
{
    std::string accelerator;
    std::vector<std::string> words;
};

/// Hardware and files may hold codes that no frame can set, so the user is warned.
void warn_out_of_range(const protocol::Accelerator& accelerator, const protocol::State& state)
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const protocol::Parameter& parameter = accelerator.parameters[i];
        if (state.codes[i] < parameter.min_scaled || state.codes[i] > parameter.max_scaled)
            fmt::print(stderr,
                       "raymarchctl: warning: {} is outside {} to {}; no frame can set it\n",
                       parameter.key, parameter.min, parameter.max);
    }
}

int decode(const DecodeOptions& options)
{
    const auto accelerator = accelerator_named(options.accelerator);
    if (!accelerator)
        return report(accelerator.error());
    const auto words = parse_words(**accelerator, options.words);
    if (!words)
        return report(words.error());
    const protocol::State state = protocol::unpack(**accelerator, *words);
    protocol::ReplyWriter frame;
    protocol::write_state(frame, **accelerator, state);
    fmt::print("{}\n", frame.text());
    warn_out_of_range(**accelerator, state);
    return EX_OK;
}

} // namespace

void add_decode(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("decode", "prints the parameter frame that register words hold");
    const auto options = std::make_shared<DecodeOptions>();
    add_texts(*command, "WORD", options->words,
              "register words, all of them in hexadecimal, word 0 first")
        ->required();
    add_accelerator_option(*command, options->accelerator,
                           "name of the accelerator that the words belong to");
    command->callback([options, &run] { run = [options] { return decode(*options); }; });
}

} // namespace raymarch::cli
