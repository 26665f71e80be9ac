// SPDX-License-Identifier: MIT
#include "base/standard_descriptors.hpp"
#include "command_line/command_line.hpp"
#include "console/subcommands.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdio>
#include <system_error>

namespace raymarch::console
{

int report(const Error& error)
{
    fmt::print(stderr, "raymarchctl: {}\n", error.message);
    return exit_status(error.kind);
}

} // namespace raymarch::console

// Before its try blocks only a lack of memory throws. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv)
{
    namespace console = raymarch::console;
    if (!raymarch::fill_standard_descriptors())
        return EX_OSERR;
    CLI::App app("raymarchctl: the tool beside raymarchd", "raymarchctl");
    raymarch::prepare_command_line(app);
    app.set_version_flag("--version", "raymarchctl " RAYMARCH_VERSION);
    app.require_subcommand(1);
    console::Run run;
    for (const auto add :
         {console::add_list, console::add_encode, console::add_decode, console::add_render,
          console::add_film, console::add_sheet, console::add_zoom, console::add_cycles,
          console::add_export, console::add_receive, console::add_send, console::add_console,
          console::add_status, console::add_watch, console::add_conformance, console::add_overlay})
        add(app, run);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? EX_OK : EX_USAGE;
    }
    try {
        const int status = run();
        errno = 0;
        const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        return written || errno == EPIPE ? status : EX_IOERR;
    } catch (const std::system_error& error) { // what fmt::print throws when nobody takes the text
        if (error.code() == std::errc::broken_pipe) // `| head -1` has what it wanted
            return EX_OK;
        fmt::print(stderr, "raymarchctl: {}\n", error.what());
        return EX_IOERR;
    }
}
