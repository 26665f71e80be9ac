// SPDX-License-Identifier: MIT
/// @file
/// Options and functions for subcommands that draw. Every kernel gives the same picture.
#pragma once

#include "base/result.hpp"
#include "engine/draw.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace raymarch::cli
{

struct DrawOptions
{
    unsigned threads = 0; ///< 0 means one for each processor
    bool reference = false;
    std::string isa;     ///< empty means the fastest
    unsigned repeat = 0; ///< pictures to time; 0 means one picture without timing
};

/// Adds --threads.
CLI::Option* add_threads_option(CLI::App& command, unsigned& threads);
/// Adds --threads, --isa, --reference and --repeat. `options` lives as long as `command`.
void add_draw_options(CLI::App& command, DrawOptions& options);

/// Draws the still of the words with the fastest kernel.
void draw_fastest(const engine::Model& model, engine::WordSpan words, unsigned threads,
                  engine::Image& image);
/// Draws a part of the still of the words. With --repeat, prints the time of one picture on
/// standard error. Errors: Usage, for an instruction set that this program or this machine does not
/// have.
[[nodiscard]] Result<void> draw_picture(const engine::Model& model, engine::WordSpan words,
                                        const DrawOptions& options, const engine::Region& tile,
                                        engine::Image& image);

} // namespace raymarch::cli
