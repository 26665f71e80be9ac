// SPDX-License-Identifier: MIT
/// @file
/// What the programs say of a command line: help, names, and words that are not understood.
#include "service/support.hpp"

#include "protocol/accelerators.hpp"

#include <gtest/gtest.h>

#include <sysexits.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
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
         "raymarchctl: there is no subcommand 'frobnicate'; the subcommands are list, encode, "},
        {{"rendr"}, EX_USAGE, "; did you mean 'render'?\nRun raymarchctl --help for a list.\n"},
        {{"Status"}, EX_USAGE, "did you mean 'status'?"},
        {{"overlay", "laod"},
         EX_USAGE,
         "raymarchctl overlay: there is no subcommand 'laod'; the subcommands are load, unload, "
         "status; did you "
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
         "there is no accelerator 'fractl'; the accelerators are marcher, fractal, sphere, "
         "mandelbulb, whitted; did "
         "you mean 'fractal'?\n"},
        {render({"--preset", "latice"}), EX_USAGE, "; did you mean 'lattice'?\n"},
        {render({"--preset", "maze"}), EX_USAGE, "'maze' is a preset of fractal, not of marcher\n"},
        {{"sheet", "-o", "x.ppm", "fractal:lattice"},
         EX_USAGE,
         "'lattice' is a preset of marcher, not of fractal\n"},
        {{"sheet", "-o", "x.ppm", "wited"}, EX_USAGE, "did you mean 'whitted'?"},
        {{"zoom", "--preset", "hole"}, EX_USAGE, "; did you mean 'whole'?\n"},
        {{"zoom", "--set", "FROM=q8_64"}, EX_DATAERR, "; did you mean 'FORM'?\n"},
        {render({"--scene", "cubee"}), EX_USAGE,
         "there is no scene 'cubee'; the scenes are sphere, cube, infinite_cube, tunnel; did you "
         "mean "
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

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// The line of a name: itself, blanks, and its meaning.
void expect_line(const std::string& line, std::string_view name, std::string_view meaning)
{
    EXPECT_TRUE(line.starts_with(name)) << line;
    EXPECT_TRUE(line.ends_with(meaning)) << line;
    const std::string between =
        line.substr(name.size(), line.size() - name.size() - meaning.size());
    EXPECT_EQ(between, std::string(between.size(), ' ')) << line;
    EXPECT_EQ(between.size() >= 2, !meaning.empty()) << line;
}

/// Lines of a help where an option, or a subcommand, is not clearly apart from its text.
std::vector<std::string> crowded_lines(const std::string& help)
{
    std::vector<std::string> crowded;
    const auto lines = lines_of(help);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t indent = std::min(lines[i].find_first_not_of(' '), lines[i].size());
        const bool entry = indent == 2 || (indent == 4 && lines[i][indent] == '-');
        // What a group says of itself is indented, too.
        if (!entry || lines[i][indent] == '[' || lines[i][indent] == '(' || lines[i].ends_with(':'))
            continue;
        const bool apart = lines[i].find("  ", indent) != std::string::npos;
        const bool broken = i + 1 < lines.size() && lines[i + 1].starts_with(std::string(30, ' '));
        if (!apart && !broken)
            crowded.push_back(lines[i]);
    }
    return crowded;
}

std::string help_of(const TemporaryFolder& folder, Words words)
{
    words.emplace_back("--help");
    const Finished tool = run_tool(folder, words);
    EXPECT_EQ(tool.status, EX_OK) << words.front();
    return tool.output;
}

Words subcommands_in(const std::string& help)
{
    Words names;
    const std::size_t at = help.find("Subcommands:\n");
    for (const std::string& line : lines_of(help.substr(std::min(at, help.size()))))
        if (line.starts_with("  ") && line[2] != ' ')
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
    return names;
}

TEST(Help, CrowdedLinesAreFound)
{
    EXPECT_EQ(crowded_lines("Options:\n  --reference Excludes: --isa with the model\n"
                            "  --size WxH   size\n  --long\n" +
                            std::string(30, ' ') + "text\n"),
              Words{"  --reference Excludes: --isa with the model"});
}

TEST(Help, ColumnsDoNotTouch)
{
    const TemporaryFolder folder;
    const std::string general = help_of(folder, {});
    EXPECT_EQ(crowded_lines(general), Words());
    const Words subcommands = subcommands_in(general);
    EXPECT_GE(subcommands.size(), 16U) << general;
    for (const std::string& name : subcommands) {
        const std::string help = help_of(folder, {name});
        EXPECT_EQ(crowded_lines(help), Words()) << name;
        for (const std::string& verb : subcommands_in(help))
            EXPECT_EQ(crowded_lines(help_of(folder, {name, verb})), Words()) << name << verb;
    }
    Process service({RAYMARCHD, "--help"}, folder / "help");
    EXPECT_EQ(service.wait(), EX_OK);
    EXPECT_TRUE(holds(service.output(), "--emulated-size"));
    EXPECT_EQ(crowded_lines(service.output()), Words());
}

class List : public testing::Test
{
  protected:
    std::vector<std::string> list(const Words& words) const
    {
        Words all = {"list"};
        all.insert(all.end(), words.begin(), words.end());
        const Finished tool = run_tool(folder, all);
        EXPECT_EQ(tool.status, EX_OK) << tool.errors;
        EXPECT_EQ(tool.errors, "");
        return lines_of(tool.output);
    }

    TemporaryFolder folder;
};

TEST_F(List, EveryAcceleratorListsItsTable)
{
    for (const protocol::Accelerator* accelerator : protocol::accelerators) {
        const std::string name(accelerator->name);
        const auto presets = list({"presets", "--accelerator", name});
        ASSERT_EQ(presets.size(), accelerator->presets.size()) << name;
        for (std::size_t i = 0; i < presets.size(); ++i)
            expect_line(presets[i], accelerator->presets[i].name, accelerator->presets[i].summary);

        const auto keys = list({"--accelerator", name, "keys"});
        std::size_t line = 0;
        for (const protocol::Parameter& parameter : accelerator->parameters)
            if (!parameter.is_tail()) {
                ASSERT_LT(line, keys.size()) << name;
                expect_line(keys[line++], parameter.key, parameter.meaning);
            }
        EXPECT_EQ(line, keys.size()) << name;

        if (!accelerator->scene) {
            const Finished none = run_tool(folder, {"list", "scenes", "--accelerator", name});
            EXPECT_EQ(none.status, EX_USAGE);
            EXPECT_EQ(none.errors, "raymarchctl: " + name + " has no scenes\n");
            continue;
        }
        const auto choices = accelerator->parameters[*accelerator->scene].choices;
        EXPECT_EQ(list({"scenes", "--accelerator", name}),
                  std::vector<std::string>(choices.begin(), choices.end()));
    }
}

TEST_F(List, WithoutAWordNamesTheLists)
{
    const auto overview = list({});
    const auto accelerators = list({"accelerators"});
    ASSERT_EQ(accelerators.size(), protocol::accelerators.size());
    ASSERT_GT(overview.size(), accelerators.size());
    for (std::size_t i = 0; i < accelerators.size(); ++i) {
        expect_line(accelerators[i], protocol::accelerators[i]->name,
                    protocol::accelerators[i]->summary);
        EXPECT_EQ(overview[i], accelerators[i]);
    }
    std::string rest;
    for (std::size_t i = accelerators.size(); i < overview.size(); ++i)
        rest += overview[i] + "\n";
    for (const char* const what : {"raymarchctl list WHAT", "\naccelerators ", "\npresets ",
                                   "\nscenes ", "\nkeys ", "--accelerator"})
        EXPECT_TRUE(holds(rest, what));
    EXPECT_EQ(list({"presets"}), list({"presets", "--accelerator", "marcher"}));
}

TEST_F(List, AnUnknownKindOrAcceleratorIsAnError)
{
    const Finished kind = run_tool(folder, {"list", "preset"});
    EXPECT_EQ(kind.status, EX_USAGE);
    EXPECT_EQ(kind.errors,
              "raymarchctl: there is no list 'preset'; the lists are accelerators, presets, "
              "scenes, keys; did you mean 'presets'?\n");
    const Finished accelerator = run_tool(folder, {"list", "keys", "--accelerator", "spere"});
    EXPECT_EQ(accelerator.status, EX_USAGE);
    EXPECT_TRUE(holds(accelerator.errors, "did you mean 'sphere'?"));
}

/// What bash offers for the last of the words.
std::vector<std::string> completions(const TemporaryFolder& folder, const Words& words)
{
    const std::string script =
        "source \"$1\"; program=$2; shift 2; COMP_WORDS=(raymarchctl \"$@\"); COMP_CWORD=$#; "
        "_raymarchctl \"$program\"; printf '%s\\n' \"${COMPREPLY[@]}\"";
    Words command = {"/bin/bash", "-c", script, "bash", RAYMARCH_COMPLETION, RAYMARCHCTL};
    command.insert(command.end(), words.begin(), words.end());
    Process bash(command, folder / "bash");
    EXPECT_EQ(bash.wait(), 0) << bash.errors();
    return lines_of(bash.output());
}

TEST_F(List, IsWhatCompletionOffers)
{
#ifdef RAYMARCH_EMULATOR
    GTEST_SKIP() << "bash does not know the emulator";
#endif
    const auto names = [&](const Words& words) {
        std::vector<std::string> first;
        for (const std::string& line : list(words))
            first.push_back(line.substr(0, line.find(' ')));
        return first;
    };
    using Lines = std::vector<std::string>;
    const auto offered = [&](const Words& words) { return completions(folder, words); };
    EXPECT_EQ(offered({"render", "--accelerator", ""}), names({"accelerators"}));
    EXPECT_EQ(offered({"render", "--preset", ""}), names({"presets"}));
    for (const protocol::Accelerator* accelerator : protocol::accelerators) {
        const std::string name(accelerator->name);
        EXPECT_EQ(offered({"film", "--accelerator", name, "--preset", ""}),
                  names({"presets", "--accelerator", name}));
    }
    EXPECT_EQ(offered({"cycles", "--accelerator", "=", "fractal", "--scene", ""}),
              names({"scenes", "--accelerator", "fractal"}));
    EXPECT_EQ(offered({"export", "--preset", ""}), names({"presets", "--accelerator", "fractal"}));
    EXPECT_EQ(offered({"zoom", "--preset", ""}), names({"presets", "--accelerator", "mandelbulb"}));
    EXPECT_EQ(offered({"zoom", "--set", "FO"}), Lines{"FORM="});
    EXPECT_EQ(offered({"render", "--preset", "=", "lattice_d"}), Lines{"lattice_diagonal"});
    EXPECT_EQ(offered({"render", "--set", "OB"}), Lines{"OBJ="});
    EXPECT_EQ(offered({"render", "--set", "OBJ", "=", "cube,Z"}), Lines{"cube,ZM="});
    EXPECT_EQ(offered({"render", "--set", "OBJ", "=", "cu"}), Lines{""});
    EXPECT_EQ(offered({"export", "--set", "COL"}), (Lines{"COLOUR=", "COLLISION="}));
    EXPECT_EQ(offered({"list", "p"}), Lines{"presets"});
    EXPECT_EQ(offered({"list", "--accelerator", "wh"}), Lines{"whitted"});
    EXPECT_EQ(offered({"rende"}), Lines{"render"});
    EXPECT_EQ(offered({"overlay", "lo"}), Lines{"load"});
}

/// Each subcommand that speaks to a service, as far as it gets without one.
std::vector<Words> asking(const std::string& socket)
{
    return {{"send", "PING", "--socket", socket},
            {"console", "--socket", socket},
            {"status", "--socket", socket},
            {"watch", "--count", "1", "--socket", socket},
            {"conformance", "--socket", socket}};
}

TEST(NoService, TheErrorSaysHowToStartOne)
{
    const TemporaryFolder folder;
    const std::string path = folder / "control";
    const std::string start =
        "raymarchd --registers emulated --serial none --state none --control ";
    const std::string expected =
        "raymarchctl: no service listens on " + path + "; start one with: " + start + path + "\n";
    const auto expect_for_all = [&](const char* when) {
        for (const Words& words : asking(path)) {
            const Finished tool = run_tool(folder, words);
            EXPECT_EQ(tool.status, EX_UNAVAILABLE) << when << words.front();
            EXPECT_EQ(tool.output, "");
            EXPECT_EQ(tool.errors, expected) << when << words.front();
        }
    };
    expect_for_all("missing ");
    {
        Service service(folder);
        ASSERT_TRUE(service.ready());
        service.process.signal(SIGKILL); // leaves the socket behind
        static_cast<void>(service.process.wait());
    }
    ASSERT_TRUE(std::filesystem::is_socket(path));
    expect_for_all("refused ");

    // What the error says does it.
    Process service({RAYMARCHD, "--registers", "emulated", "--serial", "none", "--state", "none",
                     "--control", path},
                    folder / "log");
    EXPECT_TRUE(eventually([&] {
        return run_tool(folder, {"send", "PING", "--socket", path}).status == EX_OK;
    }));
}

TEST(NoService, OfTheUsualSocketTheUnitIsNamed)
{
    if (std::filesystem::exists("/run/raymarchd/control"))
        GTEST_SKIP() << "a service is installed here";
    const TemporaryFolder folder;
    const Finished tool = run_tool(folder, {"status"});
    EXPECT_EQ(tool.status, EX_UNAVAILABLE);
    EXPECT_TRUE(holds(tool.errors, "no service listens on /run/raymarchd/control; start it with: "
                                   "systemctl start raymarchd, or "));
    EXPECT_TRUE(holds(tool.errors, "--socket PATH\n"));
}

TEST(NoService, OtherReasonsAreSaidAsTheyAre)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "no folder";
    const Finished tool = run_tool(folder, {"status", "--socket", folder / "file/control"});
    EXPECT_EQ(tool.status, EX_UNAVAILABLE);
    EXPECT_TRUE(
        holds(tool.errors, "connect to " + (folder / "file/control") + ": Not a directory"));
}

} // namespace
} // namespace raymarch::tests
