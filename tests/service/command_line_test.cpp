// SPDX-License-Identifier: MIT
/// @file
/// What the programs say of a command line: help, names, and words that are not understood.
#include "service/support.hpp"

#include "protocol/accelerators.hpp"

#include <gtest/gtest.h>

#include <sysexits.h>

#include <array>
#include <string>
#include <vector>

namespace raymarch::tests
{
namespace
{

using Words = std::vector<std::string>;

testing::AssertionResult holds(const std::string& text, std::string_view part)
{
    return text.find(part) == std::string::npos ? testing::AssertionFailure()
                                                      << '\'' << part << "' is not in:\n"
                                                      << text
                                                : testing::AssertionSuccess();
}

struct Refused
{
    Words words;
    int status;
    std::string_view message; ///< what it holds
};

TEST(CommandLine, AWrongWordGetsTheNearestOne)
{
    const std::vector<Refused> rows = {
        {{"frobnicate"},
         EX_USAGE,
         "raymarchctl: 'frobnicate' is no subcommand; there are encode, "},
        {{"rendr"}, EX_USAGE, "; did you mean 'render'?\nRun raymarchctl --help for a list.\n"},
        {{"Status"}, EX_USAGE, "did you mean 'status'?"},
        {{"overlay", "laod"},
         EX_USAGE,
         "raymarchctl overlay: 'laod' is no subcommand; there are load, unload, status; did you "
         "mean 'load'?\nRun raymarchctl overlay --help for a list.\n"},
        {{"render", "--prset", "x"},
         EX_USAGE,
         "raymarchctl render: there is no option --prset; did you mean '--preset'?\n"},
        {{"render", "--prset=x", "-o", "-"},
         EX_USAGE,
         "no option --prset; did you mean '--preset'?"},
        {{"film", "--frame", "2"}, EX_USAGE, "no option --frame; did you mean '--frames'?"},
        {{"export", "--pacp", "-"}, EX_USAGE, "no option --pacp; did you mean '--pcap'?"},
        {{"zoom", "--level", "9"}, EX_USAGE, "no option --level; did you mean '--levels'?"},
        {{"status", "--sockt", "x"}, EX_USAGE, "no option --sockt; did you mean '--socket'?"},
        {{"--verison"},
         EX_USAGE,
         "raymarchctl: there is no option --verison; did you mean '--version'?"},
        {{"render", "--nothing-like-it"},
         EX_USAGE,
         "raymarchctl render: there is no option --nothing-like-it\n"},
        {{"render", "-x"}, EX_USAGE, "raymarchctl render: there is no option -x\n"},
        {{"render"}, EX_USAGE, "--output is required"},
        {{"status", "more"}, EX_USAGE, "not expected: more"},
    };
    const TemporaryFolder folder;
    for (const Refused& row : rows) {
        const Finished tool = run_tool(folder, row.words);
        EXPECT_EQ(tool.status, row.status) << row.words.back();
        EXPECT_EQ(tool.output, "");
        EXPECT_TRUE(holds(tool.errors, row.message));
    }
}

TEST(CommandLine, AWrongNameGetsTheNearestOne)
{
    const auto render = [](Words words) {
        words.insert(words.begin(), {"render", "-o", "-"});
        return words;
    };
    const std::vector<Refused> rows = {
        {render({"--accelerator", "fractl"}), EX_USAGE,
         "'fractl' is no accelerator; there are marcher, fractal, sphere, mandelbulb, whitted; did "
         "you mean 'fractal'?\n"},
        {render({"--preset", "latice"}), EX_USAGE, "; did you mean 'lattice'?\n"},
        {render({"--preset", "maze"}), EX_USAGE, "'maze' is a preset of fractal, not of marcher\n"},
        {{"sheet", "-o", "x.ppm", "fractal:lattice"},
         EX_USAGE,
         "'lattice' is a preset of marcher, not of fractal\n"},
        {{"sheet", "-o", "x.ppm", "wited"}, EX_USAGE, "did you mean 'whitted'?"},
        {{"zoom", "--preset", "hole"}, EX_USAGE, "; did you mean 'whole'?\n"},
        {render({"--scene", "cubee"}), EX_USAGE,
         "'cubee' is no scene; there are sphere, cube, infinite_cube, tunnel; did you mean "
         "'cube'?"},
        {render({"--accelerator", "fractal", "--scene", "menge"}), EX_USAGE, "mean 'menger'?"},
        {render({"--accelerator", "sphere", "--scene", "x"}), EX_USAGE, "sphere has no scenes\n"},
        {render({"--set", "ZM=1, Ojb=cube"}), EX_DATAERR, "; did you mean 'OBJ'?\n"},
        {render({"--set", "ZM=1,OBJ= tunel ,R=1"}), EX_DATAERR,
         "or 0 to 3; did you mean 'tunnel'?\n"},
        {render({"--accelerator", "fractal", "--set", "COLOR=off"}), EX_DATAERR,
         "; did you mean 'COLOUR'?\n"},
        {render({"--accelerator", "whitted", "--set", "S1.REFLCT=0"}), EX_DATAERR,
         "; did you mean 'S1.REFLECT'?\n"},
        {render({"--line", "FX=0,OBJ=cubes"}), EX_DATAERR, "; did you mean 'cube'?\n"},
    };
    const TemporaryFolder folder;
    for (const Refused& row : rows) {
        const Finished tool = run_tool(folder, row.words);
        EXPECT_EQ(tool.status, row.status) << row.words.back();
        EXPECT_TRUE(holds(tool.errors, row.message));
    }
}

/// Runs raymarchd with words that it refuses.
std::string refused_by_service(const TemporaryFolder& folder, Words words, int status)
{
    words.insert(words.begin(), RAYMARCHD);
    Process service(std::move(words), folder / "log");
    EXPECT_EQ(service.wait(), status);
    return service.errors();
}

TEST(CommandLine, TheServiceNamesTheNearestOptionToo)
{
    const TemporaryFolder folder;
    const auto why = [&](const Words& words, int status = EX_USAGE) {
        return refused_by_service(folder, words, status);
    };
    EXPECT_EQ(why({"--contrl", "x"}), "raymarchd: there is no option --contrl; did you mean "
                                      "'--control'?\nRun raymarchd --help for a list.\n");
    EXPECT_TRUE(holds(why({"--emulated-sise=8x8"}), "did you mean '--emulated-size'?"));
    EXPECT_TRUE(holds(why({"--check-confg"}), "did you mean '--check-config'?"));
    EXPECT_TRUE(holds(why({"--frobnicate"}), "there is no option --frobnicate\n"));
    EXPECT_TRUE(holds(why({"--accelerator", "mandelbub"}), "did you mean 'mandelbulb'?"));
}

} // namespace
} // namespace raymarch::tests
