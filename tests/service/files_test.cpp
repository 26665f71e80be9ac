// SPDX-License-Identifier: MIT
/// @file
/// What is no file, or a file of somebody else, in the place of what the programs read and write.
#include "service/support.hpp"

#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/fifo.hpp"
#include "tests/fakes/overlay_blob.hpp"
#include "tests/fakes/special_files.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;
using test::Fifo;
using test::names_in;
using test::read_text;
using test::status_of;
using Arguments = std::vector<std::string>;
using Names = std::vector<std::string>;

// --- the tool ---

/// A subcommand that writes a file, and the ending that its name has.
struct Writer
{
    const char* name;
    Arguments arguments;
    const char* option;
    const char* ending;
};

void PrintTo(const Writer& writer, std::ostream* stream)
{
    *stream << writer.name;
}

/// `receive` reads the capture that the fixture makes.
const std::vector<Writer> writers = {
    {"render", {"render", "--size", "16x12"}, "-o", ".ppm"},
    {"sheet", {"sheet", "sphere"}, "-o", ".ppm"},
    {"zoom", {"zoom", "--levels", "12", "--size", "8x6"}, "-o", ".tga"},
    {"export", {"export", "--preset", "start"}, "--pcap", ".pcap"},
    {"receive", {"receive", "--pcap", "CAPTURE"}, "-o", ".ppm"},
};

class Output : public testing::TestWithParam<Writer>
{
  protected:
    void SetUp() override
    {
        fs::create_directory(folder / "out");
        if (std::string_view(GetParam().name) != "receive")
            return;
        const std::string capture = folder / "capture";
        ASSERT_EQ(run_tool(folder, {"export", "--preset", "start", "--pcap", capture}).status,
                  EX_OK);
    }
    [[nodiscard]] Arguments command(const std::string& path) const
    {
        Arguments arguments = GetParam().arguments;
        for (std::string& argument : arguments)
            if (argument == "CAPTURE")
                argument = folder / "capture";
        arguments.insert(arguments.end(), {GetParam().option, path});
        return arguments;
    }
    [[nodiscard]] Finished write(const std::string& path) const
    {
        return run_tool(folder, command(path));
    }
    [[nodiscard]] std::string place(const std::string& name) const
    {
        return folder / ("out/" + name + GetParam().ending);
    }
    /// What it writes.
    [[nodiscard]] std::string expected() const
    {
        const std::string path = folder / ("expected" + std::string(GetParam().ending));
        EXPECT_EQ(write(path).status, EX_OK);
        return read_text(path);
    }
    TemporaryFolder folder;
};

INSTANTIATE_TEST_SUITE_P(Tool, Output, testing::ValuesIn(writers),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(Output, ALinkStaysAndPermissionsDo)
{
    const std::string wanted = expected();
    ASSERT_FALSE(wanted.empty());
    const std::string file = place("file");
    test::write_text(file, "old");
    test::write_text(file + ".new", "of the user");
    ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
    fs::create_directory(folder / "out/links");
    const std::string link = place("links/latest");
    fs::create_symlink("../file" + std::string(GetParam().ending), link);
    const Finished result = write(link);
    EXPECT_EQ(result.status, EX_OK) << result.errors;
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(read_text(file), wanted);
    EXPECT_EQ(status_of(file).st_mode & 07777U, 0600U);
    EXPECT_EQ(read_text(file + ".new"), "of the user");
    EXPECT_EQ(names_in(folder / "out/links").size(), 1U);
    EXPECT_EQ(names_in(folder / "out").size(), 3U);
}

TEST_P(Output, AFifoIsWrittenToAndStays)
{
    const std::string wanted = expected();
    const Fifo fifo(place("fifo"));
    const UniqueFd reading = test::open_unwritten(fifo.path);
    Arguments arguments = command(fifo.path);
    arguments.insert(arguments.begin(), RAYMARCHCTL);
    Process process(arguments, folder / "log");
    EXPECT_EQ(test::read_to_end(reading.get()), wanted);
    EXPECT_EQ(process.wait(), EX_OK) << process.errors();
    EXPECT_TRUE(fs::is_fifo(fifo.path));
}

TEST_P(Output, AFifoThatNobodyReadsIsAnErrorAtOnce)
{
    const Fifo fifo(place("fifo"));
    const Finished result = write(fifo.path);
    EXPECT_EQ(result.status, EX_IOERR);
    EXPECT_EQ(result.errors, "raymarchctl: " + fifo.path + " is a FIFO that nobody reads\n");
    EXPECT_TRUE(fs::is_fifo(fifo.path));
}

TEST_P(Output, ADeviceStaysAndSaysWhenItIsFull)
{
    const std::string null = test::spare_device(folder / "", "null");
    const std::string full = test::spare_device(folder / "", "full");
    if (null.empty() || full.empty())
        GTEST_SKIP() << "no device can be made here";
    fs::create_symlink(null, place("null"));
    fs::create_symlink(full, place("full"));
    EXPECT_EQ(write(place("null")).status, EX_OK);
    const Finished result = write(place("full"));
    EXPECT_EQ(result.status, EX_IOERR);
    EXPECT_NE(result.errors.find("No space left"), std::string::npos) << result.errors;
    for (const std::string& device : {null, full})
        EXPECT_TRUE(fs::is_character_file(device)) << device;
    EXPECT_EQ(names_in(folder / "out").size(), 2U);
}

TEST_P(Output, ALongNameIsTaken)
{
    const std::string ending = GetParam().ending;
    const std::string path = folder / ("out/" + std::string(255 - ending.size(), 'n') + ending);
    EXPECT_EQ(write(path).status, EX_OK);
    EXPECT_EQ(names_in(folder / "out").size(), 1U);
}

TEST_P(Output, TwoAtOnceDoNotDisturbEachOther)
{
    const std::string wanted = expected();
    const std::string path = place("file");
    Arguments arguments = command(path);
    arguments.insert(arguments.begin(), RAYMARCHCTL);
    {
        std::vector<std::unique_ptr<Process>> runs;
        for (int i = 0; i < 4; ++i)
            runs.push_back(
                std::make_unique<Process>(arguments, folder / ("log" + std::to_string(i))));
        for (const auto& run : runs)
            EXPECT_EQ(run->wait(), EX_OK) << run->errors();
    }
    EXPECT_EQ(read_text(path), wanted);
    EXPECT_EQ(names_in(folder / "out").size(), 1U);
}

TEST_P(Output, AMinusIsStandardOutput)
{
    if (std::string_view(GetParam().ending) == ".tga")
        return; // - is ppm
    const Finished result = write("-");
    EXPECT_EQ(result.status, EX_OK) << result.errors;
    EXPECT_EQ(result.output, expected());
    EXPECT_FALSE(fs::exists("-"));
}

TEST(ToolStreams, DevStdoutAndDevStdinAreTheStandardStreams)
{
    const TemporaryFolder folder;
    const Finished sent =
        run_tool(folder, {"export", "--preset", "start", "--pcap", "/dev/stdout"});
    EXPECT_EQ(sent.status, EX_OK) << sent.errors;
    for (const char* const input : {"-", "/dev/stdin"}) {
        const Finished taken =
            run_tool(folder, {"receive", "--pcap", input, "-o", "-"}, sent.output);
        EXPECT_EQ(taken.status, EX_OK) << taken.errors;
        const Finished again =
            run_tool(folder, {"export", "--input", input, "--pcap", "-"}, taken.output);
        EXPECT_EQ(again.status, EX_OK) << again.errors;
        EXPECT_EQ(again.output, sent.output);
    }
    const Finished nothing = run_tool(folder, {"receive", "--pcap", "-", "-o", "-"}, "");
    EXPECT_EQ(nothing.status, EX_DATAERR);
    EXPECT_TRUE(nothing.errors.starts_with("raymarchctl: standard input")) << nothing.errors;
}

TEST(ToolStreams, InputsMayBeFifos)
{
    const TemporaryFolder folder;
    const Fifo fifo(folder / "fifo");
    const Finished capture = run_tool(folder, {"export", "--preset", "start", "--pcap", "-"});
    Process process({RAYMARCHCTL, "receive", "--pcap", fifo.path, "-o", folder / "picture.ppm"},
                    folder / "log");
    UniqueFd writing = test::open_once_read(fifo.path);
    ASSERT_TRUE(writing);
    for (std::size_t at = 0; at < capture.output.size();) {
        const ssize_t size =
            ::write(writing.get(), capture.output.data() + at, capture.output.size() - at);
        ASSERT_GT(size, 0);
        at += static_cast<std::size_t>(size);
    }
    writing.reset();
    EXPECT_EQ(process.wait(), EX_OK) << process.errors();
    EXPECT_TRUE(fs::is_regular_file(folder / "picture.ppm"));
    for (const Arguments& arguments :
         {Arguments{"receive", "--pcap", fifo.path, "-o", folder / "none.ppm"},
          Arguments{"export", "--input", fifo.path, "--pcap", folder / "none.pcap"}}) {
        const Finished waited = run_tool(folder, arguments);
        EXPECT_EQ(waited.status, EX_IOERR);
        EXPECT_EQ(waited.errors,
                  "raymarchctl: " + fifo.path + " is a FIFO that nobody writes to\n");
    }
}

TEST(OverlayTool, AFifoIsNotWaitedFor)
{
    const TemporaryFolder folder;
    const Fifo fifo(folder / "fifo");
    test::write_text(folder / "top.bit", test::make_bit());
    const std::string root = folder / "sys";
    EXPECT_EQ(run_tool(folder, {"overlay", "status", "--sysfs-root", root, "--overlay", fifo.path})
                  .status,
              EX_OK);
    for (const Arguments& files :
         {Arguments{"--bitstream", fifo.path},
          Arguments{"--bitstream", folder / "top.bit", "--overlay", fifo.path}}) {
        Arguments arguments = {"overlay", "load", "--sysfs-root", root};
        arguments.insert(arguments.end(), files.begin(), files.end());
        const Finished load = run_tool(folder, arguments);
        EXPECT_EQ(load.status, EX_IOERR);
        EXPECT_EQ(load.errors, "raymarchctl: " + fifo.path + " is a FIFO, not a file\n");
    }
    // Where the logic is kept for the kernel.
    const std::string firmware = folder / "lib/firmware";
    fs::create_directories(firmware);
    fs::create_directories(root + "/class/fpga_manager/fpga0");
    const Fifo kept(firmware + "/raymarch.bin");
    const Fifo state(root + "/class/fpga_manager/fpga0/state");
    EXPECT_EQ(run_tool(folder, {"overlay", "status", "--sysfs-root", root}).status, EX_OK);
}

TEST(Console, AHistoryThatIsNoFileIsNotWaitedFor)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    fs::create_directory(folder / "home");
    const Fifo fifo(folder / "home/raymarchctl_history");
    test::write_text(folder / "input", "PING\n");
    Process console({RAYMARCHCTL, "console", "--socket", service.control()}, folder / "console",
                    {{"XDG_STATE_HOME", folder / "home"}}, folder / "input");
    EXPECT_EQ(console.wait(), EX_OK) << console.errors();
    EXPECT_NE(console.output().find("OK"), std::string::npos);
    EXPECT_TRUE(fs::is_fifo(fifo.path));
}

// --- the service ---

bool says(const Service& service, const std::string& text)
{
    return eventually([&] { return service.process.errors().find(text) != std::string::npos; });
}

void expect_end_by_term(Service& service)
{
    service.process.signal(SIGTERM);
    EXPECT_EQ(service.process.wait(), 0);
}

class InPlaceOfAFile : public testing::TestWithParam<std::string>
{
  protected:
    void SetUp() override
    {
        fs::create_directory(folder / "special");
        const test::SpecialFiles special(folder / "special/");
        const auto found = special.all().find(GetParam());
        if (found == special.all().end())
            GTEST_SKIP() << "no device can be made here";
        path = folder / ("special/" + found->first);
        complaint = path + " is " + found->second + ", not a file";
        before = status_of(path);
    }
    void expect_untouched() const
    {
        EXPECT_EQ(status_of(path).st_mode, before.st_mode);
        EXPECT_EQ(status_of(path).st_ino, before.st_ino);
    }
    TemporaryFolder folder;
    std::string path;
    std::string complaint;
    struct stat before = {};
};

INSTANTIATE_TEST_SUITE_P(Service, InPlaceOfAFile,
                         testing::Values("fifo", "folder", "socket", "null", "disk"),
                         [](const auto& row) { return row.param; });

TEST_P(InPlaceOfAFile, AsTheStateItIsRefusedAndStays)
{
    Service service(folder, {"--state", path});
    ASSERT_TRUE(service.ready());
    EXPECT_TRUE(says(service, complaint));
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SET ZM=4"), "OK seq=1 changed=1");
    EXPECT_EQ(host.ask("SAVE").substr(0, 11), "ERR STORAGE");
    EXPECT_EQ(host.ask("LOAD").substr(0, 11), "ERR STORAGE");
    EXPECT_TRUE(says(service, "the state is not kept: " + complaint));
    expect_end_by_term(service);
    expect_untouched();
}

/// Also when it comes to stand there later.
TEST_P(InPlaceOfAFile, TheStateMayTurnIntoIt)
{
    fs::create_symlink(folder / "state", folder / "link");
    Service service(folder, {"--state", folder / "link"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SAVE"), "OK");
    EXPECT_TRUE(fs::is_regular_file(folder / "state"));
    fs::remove(folder / "link");
    fs::create_symlink(path, folder / "link");
    EXPECT_EQ(host.ask("SET ZM=4"), "OK seq=1 changed=1");
    EXPECT_EQ(host.ask("LOAD").substr(0, 11), "ERR STORAGE");
    EXPECT_EQ(host.ask("SAVE").substr(0, 11), "ERR STORAGE");
    EXPECT_EQ(host.ask("PING"), "OK");
    expect_end_by_term(service);
    expect_untouched();
}

TEST_P(InPlaceOfAFile, AsThePreviewItIsRefusedAndStays)
{
    const std::string preview = folder / "preview.png";
    fs::create_symlink(path, preview);
    Service service(folder,
                    {"--registers", "emulated", "--emulated-size", "64x48", "--preview", preview});
    ASSERT_TRUE(service.ready());
    EXPECT_TRUE(says(service, "no preview: " + preview + complaint.substr(path.size())));
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("ACCELERATOR sphere").substr(0, 2), "OK");
    EXPECT_TRUE(eventually([&] { return service.status("frames") == "1"; }));
    expect_end_by_term(service);
    expect_untouched();
}

TEST_P(InPlaceOfAFile, AsTheConfigurationItIsRefusedAtTheStart)
{
    Process service({RAYMARCHD, "--config", path, "--serial", "none"}, folder / "log");
    EXPECT_EQ(service.wait(), EX_CONFIG);
    EXPECT_NE(service.errors().find(complaint), std::string::npos) << service.errors();
    Process check({RAYMARCHD, "--config", path, "--check-config"}, folder / "check");
    EXPECT_EQ(check.wait(), EX_CONFIG);
    expect_untouched();
}

TEST_P(InPlaceOfAFile, AsTheConfigurationItIsRefusedAtAHup)
{
    test::write_text(folder / "config.toml", "basis_check = \"reject\"\n");
    Service service(folder, {"--config", folder / "config.toml"});
    ASSERT_TRUE(service.ready());
    fs::remove(folder / "config.toml");
    fs::create_symlink(path, folder / "config.toml");
    service.process.signal(SIGHUP);
    EXPECT_TRUE(says(service, "the configuration stays as it was: "));
    Host host = Host::on_socket(service.control());
    EXPECT_TRUE(host.ask("SET FX=0.9").starts_with("ERR BASIS"));
    expect_end_by_term(service);
    expect_untouched();
}

TEST_P(InPlaceOfAFile, AsTheRegistersItIsRefusedAndStays)
{
    Service service(folder, {"--registers", "file:" + path});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("hardware"), "absent");
    EXPECT_TRUE(says(service, complaint));
    expect_end_by_term(service);
    expect_untouched();
}

TEST(ServiceFiles, AStateBehindALinkIsKeptThereWithItsPermissions)
{
    const TemporaryFolder folder;
    test::write_text(folder / "state.new", "of the user");
    fs::create_directory(folder / "other");
    fs::create_symlink("other/real", folder / "state"); // to nothing yet
    const Arguments options = {"--state", folder / "state"};
    for (const char* const setting : {"ZM=4", "ZM=5"}) {
        Service service(folder, options);
        ASSERT_TRUE(service.ready());
        Host host = Host::on_socket(service.control());
        EXPECT_EQ(host.ask(std::string("SET ") + setting), "OK seq=1 changed=1");
        EXPECT_EQ(host.ask("SAVE"), "OK");
        EXPECT_NE(read_text(folder / "other/real").find(setting), std::string::npos);
        ASSERT_EQ(::chmod((folder / "other/real").c_str(), 0640), 0);
        EXPECT_EQ(host.ask("SET ZM=6"), "OK seq=2 changed=1");
        EXPECT_EQ(host.ask("SAVE"), "OK");
        EXPECT_EQ(status_of(folder / "other/real").st_mode & 07777U, 0640U);
        expect_end_by_term(service);
    }
    EXPECT_TRUE(fs::is_symlink(folder / "state"));
    EXPECT_EQ(read_text(folder / "state.new"), "of the user");
    EXPECT_EQ(names_in(folder / "other"), Names{"real"});
}

TEST(ServiceFiles, APreviewKeepsItsPermissionsAndItsLink)
{
    const TemporaryFolder folder;
    test::write_text(folder / "other/real", "");
    ASSERT_EQ(::chmod((folder / "other/real").c_str(), 0644), 0);
    fs::create_symlink("other/real", folder / "preview.png");
    Service service(folder, {"--registers", "emulated", "--emulated-size", "64x48", "--preview",
                             folder / "preview.png"});
    ASSERT_TRUE(service.ready());
    EXPECT_TRUE(
        eventually([&] { return read_text(folder / "other/real").starts_with("\x89PNG"); }));
    EXPECT_TRUE(fs::is_symlink(folder / "preview.png"));
    EXPECT_EQ(status_of(folder / "other/real").st_mode & 07777U, 0644U);
    expect_end_by_term(service);
    EXPECT_EQ(names_in(folder / "other"), Names{"real"});
}

TEST(ServiceFiles, TheTerminalsLinkTakesNoNameOfTheUser)
{
    const TemporaryFolder folder;
    fs::create_symlink("of the user", folder / "tty.new");
    fs::create_symlink("older", folder / "tty");
    Service service(folder);
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("serial"), "up");
    EXPECT_EQ(fs::read_symlink(folder / "tty.new"), "of the user");
    EXPECT_TRUE(fs::read_symlink(folder / "tty").string().starts_with("/dev/"));
    expect_end_by_term(service);
}

} // namespace
} // namespace raymarch::tests
