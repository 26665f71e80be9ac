// SPDX-License-Identifier: MIT
/// @file
/// raymarchctl film as a process.
#include "service/support.hpp"

#include "drivers/pseudo_terminal.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "motion/movers.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/pictures/gif_reader.hpp"

#include <gtest/gtest.h>

#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using NameSet = std::set<std::string>;

constexpr bool has_pictures = RAYMARCH_HAS_PICTURES;
constexpr const char* no_module = "the picture module is not built";

std::string as_ppm(const engine::Image& image)
{
    return "P6\n" + std::to_string(image.size.width) + " " + std::to_string(image.size.height) +
           "\n255\n" + std::string(image.rgb.begin(), image.rgb.end());
}

/// The defaults with changes in the syntax of SET; none where there are none.
protocol::State changed(const protocol::Accelerator& accelerator, const std::string& settings)
{
    protocol::State state = protocol::initial_state(accelerator);
    protocol::ParameterSet given;
    if (settings.empty())
        return state;
    EXPECT_FALSE(protocol::read_assignments(accelerator, {.bytes = settings}, state, given));
    return state;
}

NameSet names_in(const std::string& folder)
{
    NameSet names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename());
    return names;
}

class Film : public testing::Test
{
  protected:
    /// Small and fast, of `accelerator`, to `name` in a folder of its own.
    Finished film(std::string_view accelerator, const std::string& name,
                  const Arguments& more = {"--frames", "3", "--size", "24x18"}) const
    {
        Arguments arguments = {"film", "--accelerator", std::string(accelerator), "-o",
                               name == "-" ? name : films + name};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tool(folder, arguments);
    }
    /// Frame `number` of the film "f_%04d.ppm".
    [[nodiscard]] std::string frame(int number) const
    {
        std::array<char, 16> name{};
        std::snprintf(name.data(), name.size(), "f_%04d.ppm", number);
        return test::read_text(films + name.data());
    }
    void SetUp() override { fs::create_directory(films); }

    TemporaryFolder folder;
    std::string films = folder / "films/";
};

TEST_F(Film, AGifOfEachAccelerator)
{
    if (!has_pictures)
        GTEST_SKIP() << no_module;
    for (const protocol::Accelerator* accelerator : protocol::accelerators) {
        const Finished result =
            film(accelerator->name, "f.gif", {"--frames", "3", "--size", "24x18", "--fps", "30"});
        ASSERT_EQ(result.status, EX_OK) << accelerator->name << result.errors;
        EXPECT_EQ(result.output + result.errors, "");
        const std::string bytes = test::read_text(films + "f.gif");
        const test::Gif gif = test::GifReader(bytes).read();
        ASSERT_EQ(gif.frames.size(), 3U) << accelerator->name;
        EXPECT_EQ(gif.frames[0].size, (engine::PictureSize{24, 18}));
        EXPECT_EQ(gif.delays, (std::vector<unsigned>{3, 3, 4}));
    }
    EXPECT_EQ(names_in(films), NameSet{"f.gif"});
}

TEST_F(Film, EachFrameIsThePictureOfItsState)
{
    for (const protocol::Accelerator* accelerator : protocol::accelerators) {
        // A small picture of the sphere's screen is its upper left corner.
        const std::string settings = accelerator == &protocol::sphere::description
                                         ? "S1.X=10,S1.Y=9,L1.S=100000,MODEL=c"
                                         : "";
        Arguments more = {"--frames", "3", "--size", "24x18"};
        if (!settings.empty())
            more.insert(more.end(), {"--set", settings});
        const Finished result = film(accelerator->name, "f.ppm", more);
        ASSERT_EQ(result.status, EX_OK) << accelerator->name << result.errors;
        EXPECT_EQ(names_in(films), (NameSet{"f_0000.ppm", "f_0001.ppm", "f_0002.ppm"}));
        protocol::State state = changed(*accelerator, settings);
        const auto mover = motion::mover_of(*accelerator);
        const std::string first = frame(0);
        EXPECT_GT(std::set<char>(first.begin() + 13, first.end()).size(), 1U) << accelerator->name;
        for (int i = 0; i < 3; ++i) {
            Arguments render = {"render", "--accelerator", std::string(accelerator->name),
                                "--size", "24x18",         "-o",
                                "-",      "--registers"};
            const protocol::Words words = protocol::pack(*accelerator, state);
            for (std::size_t word = 0; word < accelerator->word_count; ++word) {
                std::array<char, 9> hex{};
                std::snprintf(hex.data(), hex.size(), "%08X", words[word]);
                render.emplace_back(hex.data());
            }
            const Finished picture = run_tool(folder, render);
            ASSERT_EQ(picture.status, EX_OK) << picture.errors;
            EXPECT_TRUE(frame(i) == picture.output) << accelerator->name << ", frame " << i;
            mover->step(state, motion::Input::Animate);
        }
    }
}

TEST_F(Film, TheFirstPictureOfASequenceIsTheRenderedFile)
{
    const Arguments view = {"--preset", "maze", "--size", "40x30"};
    Arguments arguments = view;
    arguments.insert(arguments.end(), {"--frames", "2"});
    ASSERT_EQ(film("fractal", "name_%02d.png", arguments).status, EX_OK);
    Arguments render = {"render", "--accelerator", "fractal", "-o", folder / "still.png"};
    render.insert(render.end(), view.begin(), view.end());
    ASSERT_EQ(run_tool(folder, render).status, EX_OK);
    EXPECT_EQ(names_in(films), (NameSet{"name_00.png", "name_01.png"}));
    EXPECT_TRUE(test::read_text(films + "name_00.png") == test::read_text(folder / "still.png"));
}

TEST_F(Film, ACheckerboardMixesAFrameWithTheOneBeforeTheLast)
{
    const std::string settings = "SCENE=maze,TEXTURE=on,CHECKER=on";
    const Finished result = film("fractal", "f.ppm",
                                 {"--frames", "5", "--size", "24x18", "--set", settings, "--move",
                                  "forward,turn-right", "--steps", "7"});
    ASSERT_EQ(result.status, EX_OK) << result.errors;

    const protocol::Accelerator& accelerator = protocol::fractal::description;
    protocol::State state = changed(accelerator, settings);
    const auto mover = motion::mover_of(accelerator);
    engine::Image even({24, 18});
    engine::Image odd({24, 18});
    for (int i = 0; i < 5; ++i) {
        engine::Image& image = i % 2 == 0 ? even : odd;
        engine::draw(engine::model_of(accelerator), protocol::pack(accelerator, state), image, 1,
                     static_cast<std::uint32_t>(i));
        EXPECT_TRUE(frame(i) == as_ppm(image)) << i;
        for (int step = 0; step < 7; ++step)
            mover->step(state, motion::Inputs(motion::Input::Forward) | motion::Input::TurnRight);
    }
    EXPECT_NE(frame(2), frame(4));
}

TEST_F(Film, TheSameForAnyNumberOfThreads)
{
    const Arguments arguments = {"--frames", "3",       "--size", "24x18",
                                 "--preset", "lattice", "--move", "Turn-Left,forward,UP",
                                 "--threads"};
    const auto frames = [&](const std::string& threads) {
        Arguments all = arguments;
        all.push_back(threads);
        EXPECT_EQ(film("marcher", "f.ppm", all).status, EX_OK);
        return frame(0) + frame(1) + frame(2);
    };
    const std::string one = frames("1");
    EXPECT_NE(frame(0), frame(2));
    EXPECT_TRUE(frames("3") == one);
}

/// Ctrl-C in a film that would take hours: started, unfinished, abandoned.
void expect_nothing_left(const TemporaryFolder& folder, const std::string& films,
                         const std::string& name, int signal)
{
    std::ofstream(films + "f.gif") << "older";
    Process process({RAYMARCHCTL, "film", "--frames", "100000", "--size", "64x48", "--threads", "2",
                     "-o", films + name},
                    folder / "log");
    ASSERT_TRUE(eventually([&] { return names_in(films).size() > 1 || !process.running(); }));
    process.signal(signal);
    EXPECT_EQ(process.wait(), 128 + signal) << process.errors();
    const std::string front = "raymarchctl: " + films + name + ": abandoned after ";
    EXPECT_EQ(process.errors().substr(0, front.size()), front);
    EXPECT_NE(process.errors().find(" of 100000 frames\n"), std::string::npos);
    EXPECT_EQ(names_in(films), NameSet{"f.gif"});
    EXPECT_EQ(test::read_text(films + "f.gif"), "older");
}

TEST_F(Film, AnAbandonedFilmLeavesNothing)
{
    // Whoever started this test may have had them ignored.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    expect_nothing_left(folder, films, "f_%d.ppm", SIGINT);
    expect_nothing_left(folder, films, "f_%d.ppm", SIGTERM);
    if (has_pictures)
        expect_nothing_left(folder, films, "f.gif", SIGINT);
}

TEST_F(Film, AnIgnoredInterruptIsIgnored)
{
    std::signal(SIGHUP, SIG_IGN); // as nohup does
    Process process(
        {RAYMARCHCTL, "film", "--frames", "100000", "--size", "64x48", "-o", films + "f.ppm"},
        folder / "log");
    std::signal(SIGHUP, SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
    ASSERT_TRUE(eventually([&] { return !names_in(films).empty() || !process.running(); }));
    process.signal(SIGHUP);
    process.signal(SIGINT);
    EXPECT_EQ(process.wait(), 128 + SIGINT);
}

TEST_F(Film, ProgressIsShownOnATerminalOnly)
{
    EXPECT_EQ(film("marcher", "f.ppm").errors, "");
    const auto terminal = drivers::PseudoTerminal::open(folder / "tty");
    ASSERT_TRUE(terminal) << terminal.error().message;
    Process process(
        {RAYMARCHCTL, "film", "--frames", "3", "--size", "24x18", "-o", films + "f.ppm"},
        folder / "tty");
    EXPECT_EQ(process.wait(), EX_OK);
    std::array<char, 4096> bytes{};
    const ssize_t size = ::read((*terminal)->fd(), bytes.data(), bytes.size());
    ASSERT_GT(size, 0);
    const std::string shown(bytes.data(), static_cast<std::size_t>(size));
    const std::string empty(40, ' ');
    const std::string full(40, '#');
    EXPECT_EQ(shown.find("\r\x1B[K[" + empty + "] 0/3 frames  0 %"), 0U) << shown;
    EXPECT_NE(shown.find("\r\x1B[K[" + full + "] 3/3 frames  100 %  0:00 left\r\x1B[K"),
              std::string::npos)
        << shown;
    EXPECT_EQ(shown.substr(shown.size() - 4), "\r\x1B[K"); // and goes
    EXPECT_EQ(shown.find('\n'), std::string::npos);
}

TEST_F(Film, WithoutTheVideoModuleTheErrorSaysWhatToInstall)
{
    if (RAYMARCH_HAS_VIDEO)
        GTEST_SKIP() << "the video module is built";
    for (const protocol::Accelerator* accelerator : protocol::accelerators) {
        const Finished result = film(accelerator->name, "f.mp4");
        EXPECT_EQ(result.status, EX_UNAVAILABLE);
        for (const std::string part :
             {"f.mp4: writing .mp4 needs the module libraymarch_video.so",
              "install libopencv-videoio-dev and build again, with ./dev build",
              "the package raymarchd-pictures has the module where it was built so"})
            EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
    }
    EXPECT_EQ(names_in(films), NameSet{});
}

TEST_F(Film, WrongCommandLines)
{
    const auto why = [this](const std::string& name, const Arguments& more) {
        const Finished result = film("marcher", name, more);
        EXPECT_EQ(result.status, EX_USAGE) << result.errors;
        return result.errors;
    };
    const auto names = [](const std::string& text, const std::string& part) {
        return text.find(part) == std::string::npos ? testing::AssertionFailure() << text
                                                    : testing::AssertionSuccess();
    };
    const std::string ppm = "f.ppm";
    EXPECT_TRUE(names(why(ppm, {}), "--frames is required"));
    EXPECT_TRUE(names(why(ppm, {"--frames", "0"}), "--frames: Value 0 not in range"));
    EXPECT_TRUE(names(why(ppm, {"--frames", "100001"}), "--frames: Value 100001 not in range"));
    EXPECT_TRUE(
        names(why(ppm, {"--frames", "2", "--steps", "0"}), "--steps: Value 0 not in range"));
    EXPECT_TRUE(names(why(ppm, {"--frames", "2", "--fps", "0"}), "has 1 to 240"));
    EXPECT_TRUE(names(why(ppm, {"--frames", "2", "--size", "24"}), "'24' is not a size from 1x1"));
    EXPECT_TRUE(
        names(why(ppm, {"--frames", "2", "--preset", "no"}), "there is no preset 'no'; the"));
    EXPECT_TRUE(names(why("f.avi", {"--frames", "2"}), "a film's name ends in .gif or .mp4"));
    EXPECT_TRUE(names(why("-", {"--frames", "2"}), "a film's name ends in .gif or .mp4"));
    EXPECT_TRUE(names(why("f.gif", {"--frames", "2", "--fps", "60"}), "a GIF has 1 to 50"));
    for (const std::string moves :
         {"", "sideways", "forward,", "turn-forward", "turn-", "animate 2"})
        EXPECT_TRUE(names(why(ppm, {"--frames", "2", "--move", moves}),
                          "'; the movements are forward, back, left, right, up, down, "
                          "turn-left, turn-right, turn-up, turn-down, turn-roll_left, "
                          "turn-roll_right, turn-wide, turn-narrow, animate\n"));
    EXPECT_EQ(film("nosuch", ppm).status, EX_USAGE);
    EXPECT_EQ(film("marcher", ppm, {"--frames", "2", "--set", "ZM=11"}).status, EX_DATAERR);
    EXPECT_EQ(film("marcher", "no/such/folder.ppm", {"--frames", "2"}).status, EX_IOERR);
    EXPECT_EQ(names_in(films), NameSet{});
}

} // namespace
} // namespace raymarch::tests
