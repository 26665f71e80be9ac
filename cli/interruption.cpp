// SPDX-License-Identifier: MIT
#include "cli/interruption.hpp"

#include <pthread.h>

namespace raymarch::cli
{
namespace
{

constexpr int shell_status = 128;
constexpr int wake_up = SIGURG; // it is ignored by default

/// A signal that the shell or nohup ignores stays ignored. sigwait() would return it if it were
/// blocked.
bool is_ignored(int number)
{
    struct sigaction action = {};
    return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

// A thread waits for the signals, because a signal handler must not request a stop.
Interruption::Interruption()
{
    sigemptyset(&signals_);
    sigaddset(&signals_, wake_up);
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(number))
            sigaddset(&signals_, number);
    pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
    waiting_ = std::jthread([this](const std::stop_token& over) {
        int number = 0;
        while (sigwait(&signals_, &number) == 0 && !over.stop_requested())
            if (number != wake_up && status_ == 0) {
                status_ = shell_status + number; // set before the stop, which lets others read it
                stop_.request_stop();
            }
    });
}

Interruption::~Interruption()
{
    waiting_.request_stop();
    pthread_kill(waiting_.native_handle(), wake_up);
    waiting_.join();
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

} // namespace raymarch::cli
