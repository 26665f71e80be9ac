// SPDX-License-Identifier: MIT
/// @file
/// What is missing at the start or goes away later: the service stays up, says so, and finds it
/// again.
#include "protocol/registers.hpp"
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace raymarch::tests
{
namespace
{

TEST(Failures, RegistersThatAreNotThereYetAreFound)
{
    const TemporaryFolder folder;
    const std::string late = folder / "late";
    const Service service(folder, {"--registers", "file:" + late + "/registers"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("hardware"), "absent");
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask(original_line).substr(0, 12), "ERR HARDWARE");
    EXPECT_EQ(host.ask("GET ZM"), "OK ZM=3") << "reading goes on";
    std::filesystem::create_directory(late);
    ASSERT_TRUE(eventually([&] { return service.status("hardware") == "ok"; }));
    EXPECT_EQ(host.ask("SET ZM=2"), "OK seq=1 changed=1");
}

TEST(Failures, TruncatedRegisterFileIsNoCrash)
{
    const TemporaryFolder folder;
    Service service(folder);
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    std::filesystem::resize_file(service.registers(), 0);
    EXPECT_EQ(host.ask("SET ZM=2").substr(0, 12), "ERR HARDWARE");
    ASSERT_TRUE(eventually([&] { return service.status("hardware") == "ok"; }));
    EXPECT_EQ(host.ask("SET ZM=2"), "OK seq=1 changed=1");
    EXPECT_EQ(service.words()[1], 0x02000000U);
    EXPECT_EQ(service.words()[0], original_words[0]) << "all words were written again";
}

/// Another writer changes a word that the service does not write: it is found and put right.
TEST(Failures, WordThatChangedBehindOurBackIsReportedAndMended)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const UniqueFd file(::open(service.registers().c_str(), O_RDWR | O_CLOEXEC));
    const std::uint32_t wrong = 0xDEADBEEF;
    ASSERT_EQ(::pwrite(file.get(), &wrong, sizeof wrong, 12), 4);
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SET ZM=2").substr(0, 12), "ERR HARDWARE");
    EXPECT_EQ(service.status("hardware"), "fault");
    EXPECT_EQ(host.ask("SET ZM=2"), "OK seq=1 changed=1");
    EXPECT_EQ(service.status("hardware"), "ok");
    EXPECT_EQ(service.words()[3], original_words[3]);
}

/// A file that says it is an extended block; its STATUS is ours to write.
TEST(Failures, FaultThatTheBlockItselfReportsIsTold)
{
    const TemporaryFolder folder;
    const std::string path = folder / "registers";
    std::ofstream(path) << std::string(4096, '\0');
    const UniqueFd file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    const auto write = [&](protocol::Register at, std::uint32_t word) {
        return ::pwrite(file.get(), &word, sizeof word, static_cast<off_t>(at)) == sizeof word;
    };
    ASSERT_TRUE(write(protocol::Register::Id, protocol::id_value));
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("block"), "extended");
    EXPECT_EQ(service.status("hardware"), "ok");
    ASSERT_TRUE(write(protocol::Register::Status, protocol::status::fault));
    EXPECT_EQ(service.status("hardware"), "fault");
    ASSERT_TRUE(write(protocol::Register::Status, 0));
    EXPECT_EQ(service.status("hardware"), "ok");
}

TEST(Failures, GpioLinesThatNoMachineHasAreNoMatter)
{
    const TemporaryFolder folder;
    std::ofstream config(folder / "lines.toml");
    config << "[gpio_lines]\nreset = \"/dev/raymarch-no-such-chip:0\"\n";
    for (const char* const other :
         {"next_scene", "orbit_left", "orbit_right", "lock", "turn", "heartbeat", "accepted",
          "refused", "running", "colour_red", "colour_green", "colour_blue", "dark_red",
          "dark_green", "dark_blue"})
        config << other << " = \"none\"\n";
    config.close();
    const Service service(folder, {"--config", folder / "lines.toml"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("gpio"), "down");
    EXPECT_TRUE(eventually([&] {
        return service.process.errors().find("GPIO line /dev/raymarch-no-such-chip:0: No such") !=
               std::string::npos;
    }));
    EXPECT_EQ(Host::on_socket(service.control()).ask("SET ZM=2"), "OK seq=1 changed=1");
}

TEST(Failures, GpioCanBeSwitchedOff)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--gpio", "none"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("gpio"), "none");
}

TEST(Failures, SocketLeftByAKilledServiceIsReplaced)
{
    const TemporaryFolder folder;
    {
        Service service(folder);
        ASSERT_TRUE(service.ready());
        service.process.signal(SIGKILL);
        ASSERT_EQ(service.process.wait(), 128 + SIGKILL);
    }
    ASSERT_TRUE(std::filesystem::exists(folder / "control"));
    const Service service(folder);
    EXPECT_TRUE(service.ready());
    EXPECT_EQ(Host::on_terminal(service.terminal()).ask("PING"), "OK");
}

TEST(Failures, TerminalLinkThatCannotBeMadeIsRetried)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "tty"); // something of that name is in the way
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("serial"), "down");
    std::filesystem::remove(folder / "tty");
    EXPECT_TRUE(eventually([&] { return service.status("serial") == "up"; }));
}

TEST(Failures, EmulatedBlockDrawsWhatTheFrameSays)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated", "--emulated-size", "64x48"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("block"), "extended");
    ASSERT_TRUE(eventually([&] { return service.status("frames") == "1"; }));
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("PRESET tunnel").substr(0, 9), "OK seq=1 ");
    EXPECT_TRUE(eventually([&] { return service.status("frames") == "2"; }));
}

/// Frames faster than the accelerator draws: the newest one is what it shows in the end.
TEST(Failures, NewestStateWins)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated", "--emulated-size", "160x120",
                                   "--preview", folder / "now.png"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    for (int i = 0; i < 200; ++i)
        host.send("SET ZM=" + std::to_string(1 + i % 9) + "\n");
    host.send("PRESET cube\n");
    for (int i = 0; i <= 200; ++i)
        ASSERT_TRUE(host.reply().starts_with("OK seq="));
    const std::string line = host.ask("GET").substr(3);
    const Finished wanted = run_tool(
        folder, {"render", "--line", line, "--size", "160x120", "-o", folder / "wanted.png"});
    ASSERT_EQ(wanted.status, 0) << wanted.errors;
    const auto content = [](const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_TRUE(
        eventually([&] { return content(folder / "now.png") == content(folder / "wanted.png"); }));
}

} // namespace
} // namespace raymarch::tests
