// SPDX-License-Identifier: MIT
/// @file
/// How far long work is: shown on a terminal, and nowhere else.
#include "service/support.hpp"

#include "drivers/pseudo_terminal.hpp"

#include <gtest/gtest.h>

#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::tests
{
namespace
{

/// What raymarchctl shows where its standard error is a terminal.
std::string shown_at_a_terminal(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
    const auto terminal = drivers::PseudoTerminal::open(folder / "tty");
    if (!terminal)
        return terminal.error().message;
    arguments.insert(arguments.begin(), RAYMARCHCTL);
    Process process(std::move(arguments), folder / "tty");
    std::string shown;
    const bool ended = eventually([&] {
        std::array<char, 4096> bytes{};
        const ssize_t size = ::read((*terminal)->fd(), bytes.data(), bytes.size());
        if (size > 0)
            shown.append(bytes.data(), static_cast<std::size_t>(size));
        return size <= 0 && !process.running();
    });
    EXPECT_TRUE(ended && process.wait() == EX_OK) << shown;
    return shown;
}

constexpr std::string_view cleared = "\r\x1B[K";

/// One line, drawn again and again, which is gone at the end.
void expect_one_line(const std::string& shown)
{
    EXPECT_TRUE(shown.starts_with(cleared)) << shown;
    EXPECT_TRUE(shown.ends_with(cleared)) << shown;
    EXPECT_EQ(shown.find('\n'), std::string::npos) << shown;
}

TEST(ProgressOfAZoom, IsShownOnATerminalOnly)
{
    const TemporaryFolder folder;
    const std::vector<std::string> zoom = {"zoom", "--levels", "12,13",         "--size",
                                           "8x6",  "--output", folder / "z.ppm"};
    const Finished piped = run_tool(folder, zoom);
    EXPECT_EQ(piped.status, EX_OK);
    EXPECT_EQ(piped.errors, "");
    const std::string shown = shown_at_a_terminal(folder, zoom);
    expect_one_line(shown);
    EXPECT_NE(shown.find("] 0/2 pictures  0 %"), std::string::npos) << shown;
    EXPECT_NE(shown.find("] 2/2 pictures  100 %  0:00 left"), std::string::npos) << shown;
    // Frames are printed at once.
    EXPECT_EQ(shown_at_a_terminal(folder, {"zoom", "--levels", "12"}), "");
}

TEST(ProgressOfARender, IsShownOnATerminalWhereItTakesLong)
{
    const TemporaryFolder folder;
    // On a busy machine even this may take long, but not each time.
    EXPECT_TRUE(eventually([&] {
        return shown_at_a_terminal(folder, {"render", "--size", "8x6", "-o", "-"}).empty();
    }));

    // A picture that takes a second on this machine.
    using Clock = std::chrono::steady_clock;
    constexpr std::array sizes = {"160x90", "320x180", "640x360", "1280x720"};
    for (const char* const size : sizes) {
        const std::vector<std::string> render = {
            "render",      "--accelerator",    "mandelbulb", "--preset",  "whole",
            "--reference", "--size",           size,         "--threads", "1",
            "-o",          folder / "slow.ppm"};
        const auto start = Clock::now();
        const Finished piped = run_tool(folder, render);
        EXPECT_EQ(piped.status, EX_OK);
        EXPECT_EQ(piped.errors, "");
        if (Clock::now() - start < std::chrono::seconds(1) && size != sizes.back())
            continue;
        const std::string shown = shown_at_a_terminal(folder, render);
        expect_one_line(shown);
        const std::string height = std::string(size).substr(std::string(size).find('x') + 1);
        EXPECT_NE(shown.find("/" + height + " rows  "), std::string::npos) << shown;
        EXPECT_NE(shown.find(height + "/" + height + " rows  100 %"), std::string::npos) << shown;
        auto timed = render;
        timed.insert(timed.end(), {"--repeat", "1"});
        EXPECT_EQ(shown_at_a_terminal(folder, timed).find(" rows "), std::string::npos);
        break;
    }
}

TEST(ProgressOfARender, SeveralFramesHaveOneProgress)
{
    const TemporaryFolder folder;
    // A checkerboard takes four frames. The first size may be drawn too fast.
    const std::array<std::pair<std::string, std::string>, 3> rows = {
        {{"160x120", "480"}, {"400x300", "1200"}, {"1600x1200", "4800"}}};
    for (const auto& [size, total] : rows) {
        const std::string shown = shown_at_a_terminal(
            folder, {"render", "--accelerator", "fractal", "--preset", "maze_walk", "--reference",
                     "--size", size, "--threads", "1", "-o", folder / "slow.ppm"});
        if (shown.empty())
            continue;
        expect_one_line(shown);
        EXPECT_NE(shown.find(total + "/" + total + " rows  100 %"), std::string::npos) << shown;
        return;
    }
    FAIL() << "no size took long enough to be shown";
}

} // namespace
} // namespace raymarch::tests
