// SPDX-License-Identifier: MIT
#include "drivers/bus_fault.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <time.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace raymarch::drivers
{
namespace
{

struct Watched
{
    std::atomic<std::uintptr_t> base = 0; ///< 0: a free place
    std::atomic<std::size_t> length = 0;
    std::atomic<bool> faulted = false;
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free, "the handler may not lock");

std::array<Watched, max_watched_mappings> watched; // NOLINT: a signal handler has no other state
struct sigaction previous = {};

/// How many signals without a place are let pass in a second. A person or a script sends a few; a
/// fault that is run into again each time the handler returns comes a million times.
constexpr unsigned most_strays = 1000;
std::atomic<unsigned> stray_second = 0; // NOLINT: a signal handler has no other state
std::atomic<unsigned> strays = 0;       // NOLINT: the same
static_assert(std::atomic<unsigned>::is_always_lock_free, "the handler may not lock");

/// kill(2) says SI_USER or another code that is not above 0. ARM says the same of external aborts:
/// of one that is late (a store that the bus refused when the processor was already further) the
/// address means nothing, and the read-back of the registers finds what was lost; so both are let
/// pass. But an abort that is not late happens again at once, for ever: that has to end.
bool may_be_let_pass(const siginfo_t& info) noexcept
{
    if (info.si_code > 0)
        return false; // the kernel means an access of ours, at an address
    timespec now = {};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    const auto second = static_cast<unsigned>(now.tv_sec);
    if (stray_second.exchange(second) != second)
        strays = 0;
    return ++strays <= most_strays;
}

/// Only calls that are safe in a handler: mmap is a bare system call.
void on_bus_fault(int number, siginfo_t* info, void* context)
{
    const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    for (Watched& place : watched) {
        const std::uintptr_t base = place.base;
        if (base == 0 || at < base || at >= base + place.length)
            continue;
        // An atomic number, as a handler may read it. NOLINTBEGIN(performance-no-int-to-ptr)
        void* const zeros =
            ::mmap(reinterpret_cast<void*>(base), place.length, PROT_READ | PROT_WRITE,
                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
        // NOLINTEND(performance-no-int-to-ptr)
        if (zeros == MAP_FAILED)
            break;
        place.faulted = true;
        return;
    }
    if (may_be_let_pass(*info))
        return;
    // Not ours: whoever was here before (a sanitizer, or the default that ends the process).
    if ((previous.sa_flags & SA_SIGINFO) != 0 && previous.sa_sigaction != nullptr) {
        previous.sa_sigaction(number, info, context);
        return;
    }
    ::sigaction(SIGBUS, &previous, nullptr);
}

void install() noexcept
{
    static const bool installed = [] {
        struct sigaction action = {};
        action.sa_sigaction = on_bus_fault;
        action.sa_flags = SA_SIGINFO;
        ::sigemptyset(&action.sa_mask);
        return ::sigaction(SIGBUS, &action, &previous) == 0;
    }();
    static_cast<void>(installed);
}

Watched* find(const void* base) noexcept
{
    for (Watched& place : watched)
        if (place.base == reinterpret_cast<std::uintptr_t>(base))
            return &place;
    return nullptr;
}

} // namespace

bool watch_mapping(void* base, std::size_t length) noexcept
{
    install();
    Watched* const place = find(nullptr);
    if (place == nullptr)
        return false;
    place->faulted = false;
    place->length = length;
    place->base = reinterpret_cast<std::uintptr_t>(base);
    return true;
}

void unwatch_mapping(const void* base) noexcept
{
    if (Watched* const place = find(base))
        place->base = 0;
}

bool mapping_faulted(const void* base) noexcept
{
    const Watched* const place = find(base);
    return place != nullptr && place->faulted;
}

} // namespace raymarch::drivers
