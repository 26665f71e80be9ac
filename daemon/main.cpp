// SPDX-License-Identifier: MIT
#include "base/standard_descriptors.hpp"
#include "daemon/app.hpp"
#include "daemon/options.hpp"

#include <sysexits.h>

#include <csignal>
#include <cstdlib>
#include <exception>

using namespace raymarch; // NOLINT(google-build-using-namespace): a main of a few lines

namespace
{

int report(const Error& error)
{
    log::error("{}", error.message);
    return exit_status(error.kind);
}

int serve(int argc, char** argv)
{
    const auto command_line = daemon::parse_command_line(argc, argv);
    if (const int* status = std::get_if<int>(&command_line))
        return *status;
    const auto& options = std::get<daemon::Options>(command_line);
    const auto config = daemon::load_config(options);
    if (!config)
        return report(config.error());
    if (options.check_config)
        return 0;
    log::set_level(config->log_level);

    // A write to a closed log or client must not end the program.
    static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
    sigset_t handled; // the event loop handles these; they are blocked before any thread starts
    sigemptyset(&handled);
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        sigaddset(&handled, number);
    pthread_sigmask(SIG_BLOCK, &handled, nullptr);

    auto loop = daemon::EventLoop::open();
    if (!loop)
        return report(loop.error());
    daemon::App app(
        *config, [&] { return daemon::load_config(options); }, *loop);
    const auto result = app.run();
    const int status = result ? 0 : report(result.error());
    if (!app.drawing_has_ended())
        std::_Exit(status);
    return status;
}

} // namespace

int main(int argc, char** argv)
{
    if (!fill_standard_descriptors())
        return EX_OSERR;
    try {
        return serve(argc, argv);
    } catch (const std::exception& error) { // no memory is left, or no thread can be started
        log::error("{}", error.what());
        return EX_OSERR;
    }
}
