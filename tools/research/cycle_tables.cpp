// SPDX-License-Identifier: MIT
/// Prints the tables of docs/cycles.md, which compare the sources' speeds with those of the models.
#include "tools/research/cycle_tables.hpp"

#include "command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sysexits.h>

#include <string>

int main(int argc, char** argv)
{
    namespace tools = raymarch::tools;
    CLI::App app("cycle_tables: the speeds that the sources print, beside those of the models, as "
                 "Markdown",
                 "cycle_tables");
    raymarch::prepare_command_line(app);
    std::string name;
    unsigned threads = 0;
    app.add_option("--accelerator", name, "name of one accelerator (default: tables of all)")
        ->type_name("NAME");
    app.add_option("--threads", threads, "number of threads that draw; 0 is one for each processor")
        ->check(CLI::Range(0U, 256U))
        ->type_name("N");
    CLI11_PARSE(app, argc, argv);

    bool found = false;
    for (const tools::CycleTables& row : tools::cycle_tables)
        if (name.empty() || row.accelerator->name == name) {
            found = true;
            fmt::print("{}", row.make(threads));
        }
    if (!found)
        fmt::print(stderr, "cycle_tables: there is no accelerator '{}'\n", name);
    return found ? 0 : EX_USAGE;
}
