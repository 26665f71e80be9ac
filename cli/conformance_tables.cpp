// SPDX-License-Identifier: MIT
/// @file
/// C++20 has no #embed, so the assembler's .incbin embeds the files.
#include "cli/conformance_tables.hpp"

#define RAYMARCH_EMBED(symbol, file)                                                               \
    __asm__(".section .rodata\n"                                                                   \
            ".global " #symbol "_begin\n" #symbol "_begin:\n"                                      \
            ".incbin \"" RAYMARCH_TABLES "/" file "\"\n"                                           \
            ".global " #symbol "_end\n" #symbol "_end:\n"                                          \
            ".byte 0\n"                                                                            \
            ".previous\n");                                                                        \
    extern "C" const char symbol##_begin[];                                                        \
    extern "C" const char symbol##_end[]

RAYMARCH_EMBED(raymarch_table_lines, "lines.tsv");
RAYMARCH_EMBED(raymarch_table_frames, "frames.tsv");
RAYMARCH_EMBED(raymarch_table_commands, "commands.tsv");

namespace raymarch::cli
{

std::array<ConformanceTable, 3> conformance_tables() noexcept
{
    return {{{"lines", {raymarch_table_lines_begin, raymarch_table_lines_end}},
             {"frames", {raymarch_table_frames_begin, raymarch_table_frames_end}},
             {"commands", {raymarch_table_commands_begin, raymarch_table_commands_end}}}};
}

} // namespace raymarch::cli
