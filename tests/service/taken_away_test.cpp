// SPDX-License-Identifier: MIT
/// @file
/// What others do to the service's files while it runs: what they remove or replace comes back, and
/// what they put in its place stays.
#include "service/support.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <signal.h>

#include <filesystem>
#include <fstream>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;

/// Whether a new host at the terminal's link reaches the service.
bool terminal_answers(const Service& service)
{
    return fs::is_symlink(service.terminal()) &&
           Host::on_terminal(service.terminal()).ask("PING") == "OK";
}

TEST(TakenAway, ASocketThatIsRemovedComesBack)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Host old = Host::on_socket(service.control());
    EXPECT_EQ(old.ask("PING"), "OK");
    for (std::size_t times = 1; times <= 2; ++times) {
        fs::remove(service.control());
        ASSERT_TRUE(eventually([&] { return fs::exists(service.control()); }));
        ASSERT_TRUE(service.ready());
        EXPECT_EQ(old.ask("PING"), "OK") << "who is connected stays so";
        EXPECT_EQ(service.count("was removed or replaced"), times);
    }
}

TEST(TakenAway, ALinkThatIsRemovedComesBack)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Host old = Host::on_terminal(service.terminal());
    EXPECT_EQ(old.ask("PING"), "OK");
    for (int times = 0; times < 2; ++times) {
        fs::remove(service.terminal());
        ASSERT_TRUE(service.says("the link to the pseudo-terminal"));
        ASSERT_TRUE(eventually([&] { return fs::is_symlink(service.terminal()); }));
        ASSERT_TRUE(eventually([&] { return service.status("serial") == "up"; }));
        EXPECT_TRUE(terminal_answers(service));
        EXPECT_EQ(old.ask("PING"), "OK") << "who has the terminal open keeps it";
    }
}

TEST(TakenAway, TheirFolderMayGoAndComeBack)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "run");
    const Service service(
        folder, {"--control", folder / "run/control", "--serial", "pty:" + folder / "run/tty"});
    const auto answers = [&] {
        Host host = Host::on_socket(folder / "run/control");
        return host.connected() && host.ask("PING") == "OK" && fs::is_symlink(folder / "run/tty");
    };
    ASSERT_TRUE(eventually(answers));
    for (int times = 0; times < 2; ++times) {
        fs::remove_all(folder / "run");
        fs::create_directory(folder / "run");
        ASSERT_TRUE(eventually(answers)) << service.process.errors();
    }
    fs::rename(folder / "run", folder / "away");
    fs::create_directory(folder / "run");
    EXPECT_TRUE(eventually(answers)) << service.process.errors();
    EXPECT_EQ(Host::on_terminal(folder / "run/tty").ask("PING"), "OK");
}

TEST(TakenAway, WhatStandsInTheirPlaceStays)
{
    const TemporaryFolder folder;
    {
        Service service(folder);
        ASSERT_TRUE(service.ready());
        Host host = Host::on_socket(service.control());
        Host terminal = Host::on_terminal(service.terminal());
        for (const std::string& place : {service.control(), service.terminal()}) {
            std::ofstream(place + ".theirs") << "precious";
            fs::rename(place + ".theirs", place);
        }
        ASSERT_TRUE(service.says("exists and is not a socket"));
        ASSERT_TRUE(service.says("no link to the pseudo-terminal"));
        EXPECT_TRUE(host.ask("STATUS").find(" serial=down ") != std::string::npos);
        EXPECT_EQ(terminal.ask("PING"), "OK");
        service.process.signal(SIGTERM);
        EXPECT_EQ(service.process.wait(), 0);
    }
    EXPECT_EQ(test::read_text(folder / "control"), "precious");
    EXPECT_EQ(test::read_text(folder / "tty"), "precious");
}

/// When it goes away again, the place is the service's again.
TEST(TakenAway, APlaceThatIsFreeAgainIsTakenAgain)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const std::string& place : {service.control(), service.terminal()}) {
        fs::create_symlink("/dev/null", place + ".theirs");
        fs::rename(place + ".theirs", place);
    }
    ASSERT_TRUE(service.says("no control socket"));
    ASSERT_TRUE(service.says("no link to the pseudo-terminal"));
    EXPECT_EQ(fs::read_symlink(service.terminal()), "/dev/null");
    fs::remove(service.control());
    fs::remove(service.terminal());
    ASSERT_TRUE(service.ready());
    EXPECT_TRUE(eventually([&] { return service.status("serial") == "up"; }));
    EXPECT_TRUE(terminal_answers(service));
}

struct Way
{
    const char* name;
    void (*take)(const std::string& path);
};
const std::vector<Way> ways = {
    {"removed", [](const std::string& path) { fs::remove(path); }},
    {"moved", [](const std::string& path) { fs::rename(path, path + ".away"); }},
    {"replaced",
     [](const std::string& path) {
         std::ofstream(path + ".new") << std::string(4096, '\xAA');
         fs::rename(path + ".new", path);
     }},
    {"cut to nothing", [](const std::string& path) { fs::resize_file(path, 0); }},
    {"cut to a byte", [](const std::string& path) { fs::resize_file(path, 1); }},
    {"cut to a half", [](const std::string& path) { fs::resize_file(path, 2048); }},
    {"cut by a byte", [](const std::string& path) { fs::resize_file(path, 4095); }},
};

/// Nobody sends a line meanwhile: the service notices by itself, and writes what is present.
TEST(TakenAway, RegistersAreNoticedAndWrittenAgain)
{
    for (const Way& way : ways) {
        SCOPED_TRACE(way.name);
        const TemporaryFolder folder;
        const Service service(folder);
        ASSERT_TRUE(service.ready());
        EXPECT_EQ(Host::on_socket(service.control()).ask("SET ZM=2"), "OK seq=1 changed=1");
        std::vector<std::uint32_t> wanted = original_words;
        wanted[1] = 0x02000000;
        ASSERT_EQ(service.words(), wanted);
        way.take(service.registers());
        ASSERT_TRUE(service.says("the register block has gone away")) << service.process.errors();
        ASSERT_TRUE(eventually([&] {
            return fs::exists(service.registers()) && fs::file_size(service.registers()) == 4096 &&
                   service.words() == wanted;
        }));
        EXPECT_TRUE(eventually([&] { return service.status("hardware") == "ok"; }));
        EXPECT_EQ(Host::on_socket(service.control()).ask("SET ZM=3"), "OK seq=2 changed=1");
        EXPECT_EQ(service.words(), original_words);
        EXPECT_EQ(service.count("the register block has gone away"), 1U);
    }
}

TEST(TakenAway, AStraySignalChangesNothing)
{
    const TemporaryFolder folder;
    Service service(folder);
    ASSERT_TRUE(service.ready());
    for (int i = 0; i < 3; ++i) {
        service.process.signal(SIGBUS);
        EXPECT_EQ(Host::on_socket(service.control()).ask("PING"), "OK");
    }
    fs::resize_file(service.registers(), 0);
    EXPECT_TRUE(service.says("the register block has gone away"));
    EXPECT_TRUE(eventually([&] { return service.status("hardware") == "ok"; }));
}

} // namespace
} // namespace raymarch::tests
