// SPDX-License-Identifier: MIT
/// @file
/// The service from its start to its end: configuration, notification, persisted state, signals.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sysexits.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>

namespace raymarch::tests
{
namespace
{

TEST(Lifecycle, StartsFromTheDefaultsAndWritesThem)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.words(), original_words);
    EXPECT_EQ(std::filesystem::file_size(service.registers()), 4096U);
}

TEST(Lifecycle, ItSaysWhereItListensWhenItIsReady)
{
    const TemporaryFolder folder;
    const auto says = [&](const std::vector<std::string>& options, const std::string& line) {
        const Service service(folder, options);
        EXPECT_TRUE(service.says("ready: ")) << line;
        EXPECT_TRUE(service.says("ready: " + line + "\n")) << service.process.errors();
        EXPECT_EQ(service.count("ready: "), 1U);
    };
    const std::string control = folder / "control";
    const std::string tty = "pty:" + folder / "tty";
    const std::string file = "file:" + folder / "registers";
    says({}, "marcher; registers: " + file + "; serial: " + tty + "; control: " + control);
    says({"--registers", "emulated", "--accelerator", "sphere", "--serial", "none"},
         "sphere; registers: emulated; serial: none; control: " + control);
    says({"--registers", "auto", "--sysfs-root", folder / "none", "--control", "none"},
         "marcher; registers: emulated; serial: " + tty + "; control: none");
    says({"--registers", "uio:" + folder / "uio9", "--serial", folder / "ttyX@9600"},
         "marcher; registers: uio:" + folder / "uio9" + " (not there yet); serial: " +
             folder / "ttyX@9600" + " (not there yet); control: " + control);
    says({"--control", folder / "no/folder", "--serial", "none"},
         "marcher; registers: " + file + "; serial: none; control: " + folder / "no/folder" +
             " (not there yet)");
}

TEST(Lifecycle, TermEndsCleanly)
{
    const TemporaryFolder folder;
    Service service(folder);
    ASSERT_TRUE(service.ready());
    service.process.signal(SIGTERM);
    EXPECT_EQ(service.process.wait(), 0);
    EXPECT_FALSE(std::filesystem::is_symlink(service.terminal()));
    EXPECT_FALSE(std::filesystem::exists(service.control()));
}

TEST(Lifecycle, TermSavesTheState)
{
    const TemporaryFolder folder;
    const std::vector<std::string> options = {"--state", folder / "state"};
    {
        Service service(folder, options);
        ASSERT_TRUE(service.ready());
        EXPECT_EQ(Host::on_socket(service.control()).ask("SET ZM=7,OBJ=tunnel"),
                  "OK seq=1 changed=2");
        service.process.signal(SIGTERM);
        ASSERT_EQ(service.process.wait(), 0);
    }
    const Service service(folder, options);
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(Host::on_socket(service.control()).ask("GET ZM,OBJ"), "OK ZM=7,OBJ=tunnel");
}

TEST(Lifecycle, SaveAndLoad)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--state", folder / "state"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("LOAD").substr(0, 11), "ERR STORAGE") << "nothing was persisted yet";
    EXPECT_EQ(host.ask("SET ZM=4"), "OK seq=1 changed=1");
    EXPECT_EQ(host.ask("SAVE"), "OK");
    EXPECT_EQ(host.ask("SET ZM=5"), "OK seq=2 changed=1");
    EXPECT_EQ(host.ask("LOAD"), "OK seq=3 changed=1");
    EXPECT_EQ(host.ask("GET ZM"), "OK ZM=4");
}

TEST(Lifecycle, StateIsWrittenByItselfSoonAfterAChange)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--state", folder / "state"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(Host::on_socket(service.control()).ask("SET ZM=4"), "OK seq=1 changed=1");
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(folder / "state"); }));
}

TEST(Lifecycle, DamagedStateFileIsReportedAndTheDefaultsUsed)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "state") << "raymarch-state 1\nlast marcher FX=9\ncrc32 00000000\n";
    const Service service(folder, {"--state", folder / "state"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.words(), original_words);
    EXPECT_NE(service.process.errors().find("checksum"), std::string::npos);
}

/// kill -9 at any moment of the writing: afterwards the state is one that was set, never a mixture.
TEST(Lifecycle, KilledWhileWritingTheState)
{
    const TemporaryFolder folder;
    const std::vector<std::string> options = {"--state", folder / "state", "--serial", "none"};
    const unsigned seed = std::random_device()();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int round = 0; round < 10; ++round) {
        Service service(folder, options);
        ASSERT_TRUE(service.ready());
        const std::string log = service.process.errors();
        EXPECT_EQ(log.find("starting from the defaults"), std::string::npos) << log;
        Host host = Host::on_socket(service.control());
        const std::string state = host.ask("GET ZM,LX");
        // ZM and LX are always set to the same number.
        if (round > 0) {
            EXPECT_EQ(state.substr(6, 1), state.substr(state.size() - 1)) << state;
        }
        const int commands = std::uniform_int_distribution(1, 12)(random);
        for (int i = 0; i < commands; ++i) {
            const std::string n = std::to_string(std::uniform_int_distribution(1, 9)(random));
            host.send("SET ZM=" + n + ",LX=" + n + "\nSAVE\n");
            static_cast<void>(host.reply());
            if (i + 1 < commands)
                static_cast<void>(host.reply());
        }
        service.process.signal(SIGKILL); // the last SAVE is under way, or just over
        ASSERT_EQ(service.process.wait(), 128 + SIGKILL);
    }
}

TEST(Lifecycle, HupReadsTheConfigurationAgain)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "config.toml") << "basis_check = \"warn\"\n";
    const Service service(folder, {"--config", folder / "config.toml"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SET FX=1"), "OK seq=1 changed=1 warn=BASIS");
    std::ofstream(folder / "config.toml") << "basis_check = \"reject\"\n";
    service.process.signal(SIGHUP);
    EXPECT_TRUE(eventually([&] { return host.ask("SET FX=0.9").starts_with("ERR BASIS"); }));
    std::ofstream(folder / "config.toml") << "basis_chek = \"off\"\n";
    service.process.signal(SIGHUP);
    EXPECT_TRUE(eventually([&] {
        return service.process.errors().find("config.toml:1: there is no setting 'basis_chek'") !=
               std::string::npos;
    }));
    EXPECT_TRUE(host.ask("SET FX=0.8").starts_with("ERR BASIS")) << "it stays as it was";
}

TEST(Lifecycle, TellsSystemdWhenItIsReadyAndFeedsTheWatchdog)
{
    const TemporaryFolder folder;
    const std::string path = folder / "notify";
    const UniqueFd socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::copy_n(path.c_str(), path.size(), address.sun_path);
    ASSERT_EQ(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

    const auto next = [&] {
        std::array<char, 4096> message{};
        pollfd waiting = {.fd = socket.get(), .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, 60'000) <= 0)
            return std::string("nothing came");
        const ssize_t size = ::recv(socket.get(), message.data(), message.size(), 0);
        return std::string(message.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    };
    Service service(folder, {}, {{"NOTIFY_SOCKET", path}, {"WATCHDOG_USEC", "400000"}});
    bool ready = false;
    bool fed = false;
    for (int i = 0; i < 10 && !(ready && fed); ++i) {
        const std::string message = next();
        ready |= message.starts_with("READY=1");
        fed |= message.starts_with("WATCHDOG=1");
    }
    EXPECT_TRUE(ready);
    EXPECT_TRUE(fed);
    service.process.signal(SIGTERM);
    bool stopping = false;
    for (int i = 0; i < 100 && !stopping; ++i)
        stopping = next().starts_with("STOPPING=1");
    EXPECT_TRUE(stopping);
}

struct BadStart
{
    std::vector<std::string> arguments;
    int status;
    std::string message;
};

TEST(Lifecycle, WrongOptionsAreNamedWithWhatIsAllowed)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "bad.toml") << "# a comment\nregisters = \"nowhere\"\n";
    std::ofstream(folder / "broken.toml") << "registers = \n";
    const std::vector<BadStart> starts = {
        {{"--registers", "nowhere"}, EX_USAGE, "uio-name:NAME"},
        {{"--log-level", "loud"}, EX_USAGE, "error, warning, notice, info or debug"},
        {{"--no-such-option"}, EX_USAGE, "--no-such-option"},
        {{"--config", folder / "bad.toml"}, EX_CONFIG, "bad.toml:2: registers: 'nowhere' is not"},
        {{"--config", folder / "broken.toml"}, EX_CONFIG, "broken.toml:1:"},
        {{"--config", folder / "missing.toml"}, EX_CONFIG, "missing.toml"},
    };
    for (const BadStart& start : starts) {
        std::vector<std::string> command = {RAYMARCHD, "--check-config"};
        command.insert(command.end(), start.arguments.begin(), start.arguments.end());
        Process process(command, folder / "log");
        EXPECT_EQ(process.wait(), start.status) << process.errors();
        EXPECT_NE((process.errors() + process.output()).find(start.message), std::string::npos)
            << process.errors();
    }
}

} // namespace
} // namespace raymarch::tests
