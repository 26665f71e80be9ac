// SPDX-License-Identifier: MIT
/// @file
/// Question: how long after the last byte of a frame do the registers hold it?
///
///     bench_latency [--frames N] -- NAME COMMAND… [-- NAME COMMAND…]…
///
/// Each COMMAND serves a pseudo-terminal at `{link}` and writes `{registers}`, both replaced by
/// paths. The clock runs from before the write of a frame's LF until register word 7, the last one
/// written, has changed. What stands before the LF is sent a little earlier, as a UART spreads a
/// frame over 14 ms, so that the child waits for bytes when the LF comes. The programs take turns,
/// so that all of them see the same machine. One row each: `NAME key=value…`, the ratio is to the
/// first.
#include "bench/terminal_child.hpp"

#include <fmt/format.h>

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <optional>
#include <span>
#include <thread>

namespace
{

using namespace raymarch;        // NOLINT(google-build-using-namespace)
using namespace raymarch::bench; // NOLINT(google-build-using-namespace)
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t last_word = 7;
constexpr std::size_t turn_frames = 100;
constexpr std::size_t warm_up_frames = 100;
constexpr auto pause_before_end = 500us;
constexpr auto answer_limit = 2s;

volatile std::sig_atomic_t interrupted = 0;

struct Contestant
{
    std::string name;
    std::vector<std::string> command;
    std::unique_ptr<TerminalChild> child{};
    std::size_t sent = 0;
    std::vector<double> microseconds{};
};

/// The frame of number `index`, without its LF: an orbit, so that nearly every word changes; blue
/// counts in thousandths, further apart than its codes, so that word 7 always does.
std::string frame(std::size_t index)
{
    const double yaw = 0.37 * static_cast<double>(index);
    const double pitch = std::sin(0.11 * static_cast<double>(index));
    const double cos_yaw = std::cos(yaw);
    const double sin_yaw = std::sin(yaw);
    const double cos_pitch = std::cos(pitch);
    const double sin_pitch = std::sin(pitch);
    return fmt::format("FX={:.3f},FY={:.3f},FZ={:.3f},RX={:.3f},RY=0.000,RZ={:.3f},"
                       "UX={:.3f},UY={:.3f},UZ={:.3f},ZM={:.2f},LX={:.3f},LY=2.000,LZ=5.000,"
                       "R=0.250,G=0.500,B={:.3f},OBJ=sphere\r",
                       cos_pitch * sin_yaw, sin_pitch, cos_pitch * cos_yaw, cos_yaw, -sin_yaw,
                       -sin_pitch * sin_yaw, cos_pitch, -sin_pitch * cos_yaw, 3.0 + std::sin(yaw),
                       8.0 * sin_yaw, static_cast<double>(index % 1000) / 1000);
}

/// From before the LF to the change of the last word; nothing when that does not come.
std::optional<Clock::duration> measure(TerminalChild& child, std::size_t index)
{
    child.drain();
    const std::string front = frame(index);
    if (!child.write(front))
        return std::nullopt;
    std::this_thread::sleep_for(pause_before_end);

    const std::uint32_t before = child.word(last_word);
    const auto begin = Clock::now();
    if (!child.write("\n"))
        return std::nullopt;
    for (std::uint32_t spins = 1; child.word(last_word) == before; ++spins) {
        ::sched_yield(); // the child may have been woken on this processor
        if (spins % 4096 == 0 && (interrupted != 0 || Clock::now() - begin > answer_limit))
            return std::nullopt;
    }
    return Clock::now() - begin;
}

/// `count` more frames; false when one is not answered.
bool take_turn(Contestant& contestant, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) {
        const auto time = measure(*contestant.child, contestant.sent);
        if (!time)
            return false;
        if (contestant.sent++ >= warm_up_frames)
            contestant.microseconds.push_back(
                std::chrono::duration<double, std::micro>(*time).count());
    }
    return true;
}

/// The value that `share` of the sorted values do not exceed.
double quantile(std::span<const double> sorted, double share)
{
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(share * last)];
}

std::optional<std::vector<Contestant>> read_arguments(std::span<char*> words, std::size_t& frames)
{
    std::vector<Contestant> contestants;
    std::size_t at = 0;
    if (words.size() >= 2 && std::string_view(words[0]) == "--frames") {
        const std::string_view text = words[1];
        const auto end = std::from_chars(text.data(), text.data() + text.size(), frames);
        if (end.ec != std::errc{} || frames == 0)
            return std::nullopt;
        at = 2;
    }
    for (; at < words.size(); ++at) {
        if (std::string_view(words[at]) == "--") {
            if (++at == words.size())
                return std::nullopt;
            contestants.push_back({.name = words[at], .command = {}});
        } else if (contestants.empty()) {
            return std::nullopt;
        } else {
            contestants.back().command.emplace_back(words[at]);
        }
    }
    const auto complete = [](const Contestant& contestant) { return !contestant.command.empty(); };
    if (contestants.empty() || !std::ranges::all_of(contestants, complete))
        return std::nullopt;
    return contestants;
}

Result<void> run(std::vector<Contestant>& contestants, std::size_t frames)
{
    const auto folder = TemporaryFolder::make();
    if (!folder)
        return fail(folder.error());
    for (Contestant& contestant : contestants) {
        const auto own = folder->path() / std::to_string(&contestant - contestants.data());
        std::filesystem::create_directory(own);
        auto child = TerminalChild::start(contestant.command, own);
        if (!child)
            return fail(child.error());
        contestant.child = std::move(*child);
    }
    for (std::size_t left = frames + warm_up_frames; left > 0;) {
        const std::size_t count = std::min(left, turn_frames);
        for (Contestant& contestant : contestants)
            if (!take_turn(contestant, count))
                return fail(
                    plain_error(ErrorKind::Unavailable, contestant.name + " did not write word 7"));
        left -= count;
    }
    for (Contestant& contestant : contestants)
        contestant.child.reset();
    return {};
}

void print(std::vector<Contestant>& contestants)
{
    double first = 0;
    for (Contestant& contestant : contestants) {
        std::ranges::sort(contestant.microseconds);
        const double median = quantile(contestant.microseconds, 0.5);
        if (first == 0)
            first = median;
        fmt::print("{} frames={} min_us={:.1f} median_us={:.1f} p99_us={:.1f} ratio={:.2f}\n",
                   contestant.name, contestant.microseconds.size(), contestant.microseconds[0],
                   median, quantile(contestant.microseconds, 0.99), median / first);
    }
}

} // namespace

int main(int argc, char** argv)
{
    for (const int signal : {SIGINT, SIGTERM})
        static_cast<void>(std::signal(signal, [](int) { interrupted = 1; }));
    std::size_t frames = 2000;
    auto contestants = read_arguments({argv + 1, static_cast<std::size_t>(argc - 1)}, frames);
    if (!contestants) {
        fmt::print(stderr,
                   "bench_latency [--frames N] -- NAME COMMAND... [-- NAME COMMAND...]...\n");
        return 64;
    }
    if (const auto ran = run(*contestants, frames); !ran) {
        fmt::print(stderr, "bench_latency: {}\n", ran.error().message);
        return exit_status(ran.error().kind);
    }
    print(*contestants);
    return 0;
}
