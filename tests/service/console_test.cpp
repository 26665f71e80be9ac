// SPDX-License-Identifier: MIT
/// @file
/// Tests the output and the exit status of raymarchctl.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <sysexits.h>

#include <filesystem>
#include <fstream>

namespace raymarch::tests
{
namespace
{

const std::string words = "01804028 03000000 00000000 07FFFFFF 7FFFC000 000003FF 00001FFF F00003FF";

std::vector<std::string> with_words(std::vector<std::string> arguments)
{
    for (std::size_t at = 0; at < words.size(); at += 9)
        arguments.push_back(words.substr(at, 8));
    return arguments;
}

TEST(Tool, EncodesALine)
{
    const TemporaryFolder folder;
    const Finished result = run_tool(folder, {"encode", original_line});
    EXPECT_EQ(result.status, EX_OK);
    EXPECT_EQ(result.output, "OK " + words + "\n");
    EXPECT_EQ(result.errors, "");
}

TEST(Tool, EncodeSaysWhatIsWrong)
{
    const TemporaryFolder folder;
    const Finished result = run_tool(folder, {"encode", "FX=2"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.output, "ERR RANGE col=4 key=FX : FX is a number -1 to 1\n");
}

TEST(Tool, EncodeAnswersEachLineOfItsInput)
{
    const TemporaryFolder folder;
    using namespace std::string_view_literals;
    std::string input = original_line + "\r\n" + "\n  \t\n" + "PING\n";
    input += "\0\xFF\n"sv;
    input += std::string(1025, 'x') + "\n" + original_line; // the last line has no ending
    const Finished result = run_tool(folder, {"encode"}, input);
    EXPECT_EQ(result.status, 1);
    std::istringstream lines(result.output);
    const std::vector<std::string> wanted = {
        "OK " + words,
        "ERR UNKNOWN_COMMAND col=1 : ", "ERR BAD_BYTE col=1 : ", "ERR TOO_LONG : ", "OK " + words};
    std::string line;
    for (const std::string& front : wanted) {
        ASSERT_TRUE(std::getline(lines, line)) << "expected " << front;
        EXPECT_EQ(line.substr(0, front.size()), front);
    }
    EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST(Tool, DecodesWords)
{
    const TemporaryFolder folder;
    const Finished result = run_tool(folder, with_words({"decode"}));
    EXPECT_EQ(result.status, EX_OK);
    EXPECT_EQ(result.output, "FX=0,FY=0,FZ=0.99999,RX=0.99999,RY=0,RZ=0,UX=0,UY=0.99999,UZ=0,ZM=3,"
                             "LX=3,LY=2,LZ=5,R=0.999,G=0.999,B=0.999,OBJ=sphere\n");
    EXPECT_EQ(run_tool(folder, {"decode", "01804028"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"decode", "1", "2", "3", "4", "5", "6", "7", "G"}).status,
              EX_USAGE);
}

TEST(Tool, LineWordsAndSetDrawTheSame)
{
    const TemporaryFolder folder;
    const Finished line =
        run_tool(folder, {"render", "--line", original_line, "--size", "32x24", "-o", "-"});
    const Finished set = run_tool(folder, {"render", "--set", "OBJ=sphere", "--size", "32x24",
                                           "--threads", "1", "--reference", "-o", "-"});
    std::vector<std::string> arguments = with_words({"render", "--registers"});
    arguments.insert(arguments.end(), {"--size", "32x24", "-o", "-"});
    const Finished registers = run_tool(folder, arguments);
    EXPECT_EQ(line.status, EX_OK) << line.errors;
    EXPECT_EQ(line.output.substr(0, 13), "P6\n32 24\n255\n");
    EXPECT_EQ(line.output.size(), 13U + 32 * 24 * 3);
    EXPECT_EQ(line.output, set.output);
    EXPECT_EQ(line.output, registers.output) << registers.errors;
}

TEST(Tool, RenderDrawsTheSamePictureInEveryWay)
{
    using Arguments = std::vector<std::string>;
    const TemporaryFolder folder;
    const Arguments view = {"render", "--scene", "cube", "--size", "63x47", "-o", "-"};
    const auto drawn = [&](Arguments more) {
        more.insert(more.begin(), view.begin(), view.end());
        return run_tool(folder, more);
    };
    const Finished reference = drawn({"--reference"});
    ASSERT_EQ(reference.status, EX_OK) << reference.errors;
    EXPECT_EQ(reference.errors, "");
    for (const Arguments& way : {Arguments{}, Arguments{"--isa", "scalar"},
                                 Arguments{"--threads", "3"}, Arguments{"--repeat", "2"}})
        EXPECT_EQ(drawn(way).output, reference.output) << testing::PrintToString(way);
    EXPECT_NE(drawn({"--repeat", "2", "--reference", "--threads", "3"})
                  .errors.find("; reference, 3 threads\n"),
              std::string::npos);

    // The file has its own header and the bytes of three columns and two rows.
    const Finished tile = drawn({"--tile", "3x2+30+20"});
    const std::string header = "P6\n3 2\n255\n";
    ASSERT_EQ(tile.output.size(), header.size() + 18) << tile.errors;
    const std::string_view picture = std::string_view(reference.output).substr(13);
    EXPECT_EQ(tile.output, header + std::string(picture.substr(3 * (20 * 63 + 30), 9)) +
                               std::string(picture.substr(3 * (21 * 63 + 30), 9)));
}

TEST(Tool, SettingsChangeAPreset)
{
    const TemporaryFolder folder;
    const auto drawn = [&](const std::vector<std::string>& view) {
        std::vector<std::string> arguments = {"render", "--size", "20x15", "-o", "-"};
        arguments.insert(arguments.end(), view.begin(), view.end());
        return run_tool(folder, arguments);
    };
    const Finished changed = drawn({"--preset", "tunnel", "--set", "OBJ=cube"});
    ASSERT_EQ(changed.status, EX_OK) << changed.errors;
    EXPECT_NE(changed.output, drawn({"--preset", "tunnel"}).output);
    EXPECT_NE(changed.output, drawn({"--set", "OBJ=cube"}).output);
    EXPECT_EQ(drawn({"--scene", "cube", "--set", "ZM=3"}).output,
              drawn({"--set", "OBJ=cube,ZM=3"}).output);
    EXPECT_EQ(drawn({"--scene", "cube", "--preset", "tunnel"}).status, EX_USAGE);
    EXPECT_EQ(drawn({"--registers", "0", "--set", "ZM=3"}).status, EX_USAGE);
}

TEST(Tool, RenderRefusesBeforeItDraws)
{
    const TemporaryFolder folder;
    EXPECT_EQ(run_tool(folder, {"render", "-o", folder / "picture.gif"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"render", "--size", "1921x1080", "-o", "-"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"render", "--preset", "nosuch", "-o", "-"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"render", "--tile", "2x2+639+0", "-o", "-"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"render", "--isa", "avx2", "--reference", "-o", "-"}).status,
              EX_USAGE);
    const Finished isa = run_tool(folder, {"render", "--isa", "mmx", "-o", "-"});
    EXPECT_EQ(isa.status, EX_USAGE);
    EXPECT_NE(isa.errors.find("'mmx' does not draw marcher on this machine; use one of scalar"),
              std::string::npos);
    const Finished bad = run_tool(folder, {"render", "--line", "FX=2", "-o", "-"});
    EXPECT_EQ(bad.status, EX_DATAERR);
    EXPECT_NE(bad.errors.find("ERR RANGE col=4 key=FX"), std::string::npos);
    EXPECT_EQ(run_tool(folder, {"render", "-o", folder / "no/such/folder.ppm"}).status, EX_IOERR);
}

/// Returns the value of `key` in lines of keys and values.
std::string value_of(const std::string& text, const std::string& key)
{
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(key + " "))
            return line.substr(line.find_first_not_of(' ', key.size()));
    return {};
}

TEST(Tool, CyclesOfASceneAsTheHardwareTakes)
{
    const TemporaryFolder folder;
    const Finished cube =
        run_tool(folder, {"cycles", "--accelerator", "fractal", "--scene", "cube", "--units", "4"});
    EXPECT_EQ(cube.status, EX_OK) << cube.errors;
    EXPECT_EQ(value_of(cube.output, "size"), "400x300");
    EXPECT_EQ(value_of(cube.output, "rays"), "120000");
    EXPECT_EQ(value_of(cube.output, "steps"), "966576 scene queries");
    EXPECT_EQ(value_of(cube.output, "cycles"), "1114020");
    EXPECT_EQ(value_of(cube.output, "fps"), "35.91");
    const Finished slow = run_tool(folder, {"cycles", "--accelerator", "fractal", "--scene", "cube",
                                            "--units", "4", "--clock", "4000000"});
    EXPECT_EQ(value_of(slow.output, "fps"), "3.591");
}

/// The two halves of a checkerboard differ, so the count is the mean of a still's frames or of one
/// frame.
TEST(Tool, CyclesOfACheckerboardAreAMean)
{
    const TemporaryFolder folder;
    const std::vector<std::string> view = {"cycles", "--accelerator", "fractal",   "--size",
                                           "99x75",  "--set",         "CHECKER=on"};
    std::uint64_t sum = 0;
    for (const std::string number : {"0", "1"}) {
        std::vector<std::string> one = view;
        one.insert(one.end(), {"--frame", number});
        const Finished half = run_tool(folder, one);
        EXPECT_EQ(value_of(half.output, "frame"), number);
        EXPECT_EQ(value_of(half.output, "rays"), number == "0" ? "3712" : "3713");
        sum += std::stoull(value_of(half.output, "cycles"));
    }
    const Finished still = run_tool(folder, view);
    EXPECT_EQ(value_of(still.output, "frame"), "0 to 3, the mean");
    EXPECT_EQ(value_of(still.output, "rays"), "3712.5");
    EXPECT_EQ(value_of(still.output, "cycles"),
              std::to_string(sum / 2) + (sum % 2 == 0 ? "" : ".5"));
}

/// The hardware draws one column and one row more than its picture shows (source 004, Fig. 12).
TEST(Tool, CyclesCountRaysBeyondThePicture)
{
    const TemporaryFolder folder;
    const Finished counted =
        run_tool(folder, {"cycles", "--accelerator", "whitted", "--size", "320x240", "--set",
                          "PROFILE=measured,LR=3,REFLECTIONS=0,PLANES=off"});
    EXPECT_EQ(value_of(counted.output, "rays"), "108422");
    EXPECT_EQ(value_of(counted.output, "cycles"), "4678168");
    EXPECT_EQ(value_of(counted.output, "fps"), "5.344");
}

TEST(Tool, CyclesBeyondThirtyTwoBits)
{
    const TemporaryFolder folder;
    const Finished counted =
        run_tool(folder, {"cycles", "--accelerator", "sphere", "--size", "1920x1080", "--set",
                          "S1.Z=1050,S1.R=1000,L1.Z=40000"});
    EXPECT_EQ(counted.status, EX_OK) << counted.errors;
    EXPECT_GT(std::stoull(value_of(counted.output, "cycles")), std::uint64_t{UINT32_MAX});
    EXPECT_EQ(
        value_of(counted.output, "steps").substr(0, value_of(counted.output, "cycles").size()),
        value_of(counted.output, "cycles"));
}

TEST(Tool, CyclesOfNothingHaveNoSpeed)
{
    const TemporaryFolder folder;
    const Finished counted = run_tool(
        folder, {"cycles", "--accelerator", "sphere", "--size", "8x8", "--set", "MODEL=c,N=0"});
    EXPECT_EQ(value_of(counted.output, "cycles"), "0");
    EXPECT_EQ(value_of(counted.output, "fps"), "-");
}

TEST(Tool, CyclesRefusesWhatItCannotCount)
{
    const TemporaryFolder folder;
    const auto status = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "cycles");
        return run_tool(folder, arguments).status;
    };
    EXPECT_EQ(status({"--accelerator", "nosuch"}), EX_USAGE);
    EXPECT_EQ(status({"--scene", "nosuch"}), EX_USAGE);
    EXPECT_EQ(status({"--accelerator", "whitted", "--scene", "room"}), EX_USAGE);
    EXPECT_EQ(status({"--scene", "cube", "--preset", "cube"}), EX_USAGE);
    EXPECT_EQ(status({"--units", "0"}), EX_USAGE);
    EXPECT_EQ(status({"--units", "256"}), EX_USAGE);
    EXPECT_EQ(status({"--clock", "0"}), EX_USAGE);
    EXPECT_EQ(status({"--frame", "-1"}), EX_USAGE);
    EXPECT_EQ(status({"--size", "0x0"}), EX_USAGE);
    EXPECT_EQ(status({"--line", "FX=2"}), EX_DATAERR);
    EXPECT_EQ(status({"--set", "OBJ=nosuch"}), EX_DATAERR);
}

/// The frame scale depends on the level and on FORM.
TEST(Tool, ZoomPrintsTheFrameOfEachLevel)
{
    const TemporaryFolder folder;
    const Finished zoom =
        run_tool(folder, {"zoom", "--levels", "12,55", "--set", "N=64,FORM=q8_64"});
    EXPECT_EQ(zoom.status, EX_OK) << zoom.errors;
    const std::size_t second = zoom.output.find('\n') + 1;
    EXPECT_NE(zoom.output.substr(0, second).find("N=64,"), std::string::npos) << zoom.output;
    EXPECT_NE(zoom.output.substr(0, second).find(",SCALE=0,"), std::string::npos) << zoom.output;
    EXPECT_NE(zoom.output.find(",FORM=q8_64,", second), std::string::npos) << zoom.output;
    EXPECT_NE(zoom.output.find(",SCALE=43,", second), std::string::npos) << zoom.output;
}

TEST(Tool, SendsAndTellsByItsStatus)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished good =
        run_tool(folder, {"send", "--port", service.terminal(), "SET ZM=2", "GET ZM"});
    EXPECT_EQ(good.status, EX_OK) << good.errors;
    EXPECT_EQ(good.output, "OK seq=1 changed=1\nOK ZM=2\n");
    const Finished bad = run_tool(folder, {"send", "--socket", service.control(), "SET ZM=11"});
    EXPECT_EQ(bad.status, 1);
    const Finished help = run_tool(folder, {"send", "--socket", service.control(), "HELP ZM"});
    EXPECT_EQ(help.output.substr(0, 7), "# ZM : ");
    EXPECT_EQ(run_tool(folder, {"send", "--socket", folder / "nobody", "PING"}).status,
              EX_UNAVAILABLE);
}

TEST(Tool, StatusAsTextAndJson)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished text = run_tool(folder, {"status", "--socket", service.control()});
    EXPECT_NE(text.output.find("hardware                 ok\n"), std::string::npos) << text.output;
    const Finished json = run_tool(folder, {"status", "--json", "--socket", service.control()});
    EXPECT_NE(json.output.find("\"applied\": 0"), std::string::npos) << json.output;
    const Finished watch =
        run_tool(folder, {"watch", "--count", "1", "--socket", service.control()});
    EXPECT_EQ(watch.status, EX_OK);
    EXPECT_NE(watch.output.find(" OBJ=sphere"), std::string::npos) << watch.output;
}

TEST(Tool, ConsoleReadsLinesThatArePiped)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished result =
        run_tool(folder, {"console", "--socket", service.control()}, "SET ZM=2\nGET ZM\n");
    EXPECT_EQ(result.status, EX_OK) << result.errors;
    EXPECT_NE(result.output.find("OK ZM=2\n"), std::string::npos) << result.output;
}

TEST(Tool, ConformanceOverTerminalAndSocket)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const auto& [option, where] :
         {std::pair<std::string, std::string>{"--port", service.terminal()},
          {"--socket", service.control()}}) {
        const Finished result = run_tool(folder, {"conformance", option, where});
        EXPECT_EQ(result.status, EX_OK) << result.output << result.errors;
        EXPECT_NE(result.output.find(" passed, 0 failed\n"), std::string::npos) << result.output;
    }
}

TEST(Tool, ConformanceSwitchesAnEmulatedAcceleratorAndBack)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated", "--accelerator", "fractal",
                                   "--emulated-size", "16x16"});
    ASSERT_TRUE(service.ready());
    const Finished result = run_tool(folder, {"conformance", "--socket", service.control()});
    EXPECT_EQ(result.status, EX_OK) << result.output << result.errors;
    EXPECT_NE(result.output.find(" passed, 0 failed\n"), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("left out"), std::string::npos) << result.output;
    EXPECT_EQ(service.status("accelerator"), "fractal");
}

TEST(Tool, ConformanceOfABoardThatHasAnotherAccelerator)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--accelerator", "mandelbulb"});
    ASSERT_TRUE(service.ready());
    const Finished result = run_tool(folder, {"conformance", "--socket", service.control()});
    EXPECT_EQ(result.status, EX_OK) << result.output << result.errors;
    EXPECT_NE(result.output.find("stays with mandelbulb"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find(" passed, 0 failed\n"), std::string::npos) << result.output;
    EXPECT_EQ(service.status("accelerator"), "mandelbulb");
}

/// Table rows that are not in a frame have their defaults.
TEST(Tool, AFrameWithoutItsTablesIsTheDefaultScene)
{
    const TemporaryFolder folder;
    const std::vector<std::string> whole = {
        "render", "--accelerator", "sphere", "--size", "40x30", "-o", "-"};
    auto by_line = whole;
    by_line.insert(by_line.end(),
                   {"--line", "MODEL=rtl,FAULTS=kept,TINT=yellow,N=1,M=1,CUTOFF=2,D=75,K=200,"
                              "EX=320,EY=240,EZ=0,F=1000"});
    const Finished first = run_tool(folder, whole);
    const Finished second = run_tool(folder, by_line);
    EXPECT_EQ(first.status, EX_OK) << first.errors;
    EXPECT_EQ(second.status, EX_OK) << second.errors;
    EXPECT_EQ(first.output, second.output);
}

/// A service with other settings fails rows, and each failed row is named.
TEST(Tool, ConformanceFindsADifference)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--basis-check", "off"});
    ASSERT_TRUE(service.ready());
    const Finished result = run_tool(folder, {"conformance", "--port", service.terminal()});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find("warn=BASIS"), std::string::npos);
    EXPECT_NE(result.output.find("differs from byte "), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find(" passed, 0 failed\n"), std::string::npos);
    EXPECT_EQ(run_tool(folder, {"conformance", "--socket", folder / "nobody"}).status,
              EX_UNAVAILABLE);
}

TEST(Tool, WrongCommandLinesAreUsageErrors)
{
    const TemporaryFolder folder;
    EXPECT_EQ(run_tool(folder, {}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"nosuch"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"render"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"encode", "--accelerator", "nosuch", "FX=1"}).status, EX_USAGE);
    EXPECT_EQ(run_tool(folder, {"--help"}).status, EX_OK);
}

} // namespace
} // namespace raymarch::tests
