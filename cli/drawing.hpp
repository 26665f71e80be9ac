// SPDX-License-Identifier: MIT
/// @file
/// How a subcommand draws: by which of the ways to the same bytes, and how often.
#pragma once

#include "base/result.hpp"
#include "engine/draw.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace raymarch::cli
{

struct DrawOptions
{
    unsigned threads = 0; ///< 0: one for each processor
    bool reference = false;
    std::string isa;     ///< empty: the fastest there is
    unsigned repeat = 0; ///< pictures to time; 0: one, not timed
};

/// --threads, for a subcommand that draws by the fastest way.
CLI::Option* add_threads_option(CLI::App& command, unsigned& threads);
/// --threads, --isa, --reference and --repeat. `options` lives as long as `command`.
void add_draw_options(CLI::App& command, DrawOptions& options);

/// The still of the words, by the fastest way.
void draw_fastest(const engine::Model& model, engine::WordSpan words, unsigned threads,
                  engine::Image& image);
/// A part of the still of the words; where it is repeated, says on standard error how long one
/// takes. Errors: Usage, for an instruction set that this program or this machine does not have.
[[nodiscard]] Result<void> draw_picture(const engine::Model& model, engine::WordSpan words,
                                        const DrawOptions& options, const engine::Region& tile,
                                        engine::Image& image);

} // namespace raymarch::cli
