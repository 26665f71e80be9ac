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
    std::atomic<std::uintptr_t> base = 0; ///< 0 if the entry is free
    std::atomic<std::size_t> length = 0;
    std::atomic<bool> faulted = false;
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free, "the handler may not lock");

std::array<Watched, max_watched_mappings> watched; // NOLINT: a signal handler has no other state
struct sigaction previous = {};

/// The most signals without an address that are ignored in a second. A person or a script sends a
/// few. A fault that repeats each time the handler returns raises a million.
constexpr unsigned max_ignored = 1000;
std::atomic<unsigned> ignored_second = 0;  // NOLINT: a signal handler has no other state
std::atomic<unsigned> ignored_signals = 0; // NOLINT: a signal handler has no other state
static_assert(std::atomic<unsigned>::is_always_lock_free, "the handler may not lock");

/// A signal from kill(2) has a code of at most 0, and so has an external abort on ARM. An imprecise
/// abort comes after the store that caused it, so its address means nothing. Both are ignored; the
/// read-back of the registers finds a lost store. A precise abort repeats for ever, so the number
/// of ignored signals is limited.
bool may_be_ignored(const siginfo_t& info) noexcept
{
    if (info.si_code > 0)
        return false; // an access of this process faulted at the address
    timespec now = {};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    const auto second = static_cast<unsigned>(now.tv_sec);
    if (ignored_second.exchange(second) != second)
        ignored_signals = 0;
    return ++ignored_signals <= max_ignored;
}

/// Makes only calls that are safe in a signal handler; mmap() is a plain system call.
void on_bus_fault(int number, siginfo_t* info, void* context)
{
    const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    for (Watched& place : watched) {
        const std::uintptr_t base = place.base;
        if (base == 0 || at < base || at >= base + place.length)
            continue;
        // The handler may read atomic numbers. NOLINTBEGIN(performance-no-int-to-ptr)
        void* const zeros =
            ::mmap(reinterpret_cast<void*>(base), place.length, PROT_READ | PROT_WRITE,
                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
        // NOLINTEND(performance-no-int-to-ptr)
        if (zeros == MAP_FAILED)
            break;
        place.faulted = true;
        return;
    }
    if (may_be_ignored(*info))
        return;
    // The previous handler takes any other fault: a sanitizer, or the default that ends the
    // process.
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
