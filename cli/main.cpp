// SPDX-License-Identifier: MIT
#include "base/standard_descriptors.hpp"
#include "cli/subcommands.hpp"
#include "command_line/command_line.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdio>
#include <system_error>

namespace raymarch::cli
{

int report(const Error& error)
{
    fmt::print(stderr, "raymarchctl: {}\n", error.message);
    return exit_status(error.kind);
}

} // namespace raymarch::cli

// Outside its try blocks only a lack of memory throws. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv)
{
    namespace cli = raymarch::cli;
    if (!raymarch::fill_standard_descriptors())
        return EX_OSERR;
    CLI::App app("raymarchctl: works with frames, words and pictures of a ray-marching "
                 "accelerator, and with a running raymarchd",
                 "raymarchctl");
    raymarch::prepare_command_line(app);
    app.set_version_flag("--version", "raymarchctl " RAYMARCH_VERSION);
    app.require_subcommand(1);
    cli::Run run;
    for (const auto add : {cli::add_list, cli::add_encode, cli::add_decode, cli::add_render,
                           cli::add_film, cli::add_sheet, cli::add_zoom, cli::add_cycles,
                           cli::add_export, cli::add_receive, cli::add_send, cli::add_console,
                           cli::add_status, cli::add_watch, cli::add_conformance, cli::add_overlay})
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
    } catch (const std::system_error& error) {      // fmt::print throws this if the write fails
        if (error.code() == std::errc::broken_pipe) // the reader, such as head, has closed the pipe
            return EX_OK;
        fmt::print(stderr, "raymarchctl: {}\n", error.what());
        return EX_IOERR;
    }
}
