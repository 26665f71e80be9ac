// SPDX-License-Identifier: MIT
#include "cli/stop_signals.hpp"

#include <sys/signalfd.h>
#include <unistd.h>

namespace raymarch::cli
{

StopSignals::StopSignals()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action = {};
        // A signal that nohup ignores stays ignored: a signalfd would report it if it were blocked.
        if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
            sigaddset(&signals, number);
    }
    sigprocmask(SIG_BLOCK, &signals, &mask_before_);
    fd_ = UniqueFd(::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &pipe_before_);
}

StopSignals::~StopSignals()
{
    sigaction(SIGPIPE, &pipe_before_, nullptr);
    sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
}

int StopSignals::take() const noexcept
{
    signalfd_siginfo info = {};
    if (::read(fd_.get(), &info, sizeof info) != sizeof info)
        return 0;
    return static_cast<int>(info.ssi_signo);
}

} // namespace raymarch::cli
