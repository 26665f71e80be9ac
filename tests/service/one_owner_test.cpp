// SPDX-License-Identifier: MIT
/// @file
/// Two services that would use one thing: it has one owner, the second says who that is, and waits
/// where waiting is promised.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <signal.h>
#include <sysexits.h>

#include <filesystem>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;

/// How the log names the process of a service.
std::string name_of(const Service& service)
{
    return "in use by process " + std::to_string(service.process.pid()) + " (";
}

TEST(OneOwner, RegistersOfAnotherServiceEndTheStart)
{
    const TemporaryFolder folder;
    const TemporaryFolder other;
    Service first(folder);
    ASSERT_TRUE(first.ready());
    fs::create_symlink(first.registers(), other / "alias");
    for (const std::string& path : {first.registers(), other / "alias"}) {
        Service second(other, {"--registers", "file:" + path});
        EXPECT_EQ(second.process.wait(), EX_UNAVAILABLE);
        EXPECT_EQ(second.count(path + " is " + name_of(first)), 1U) << second.process.errors();
        EXPECT_FALSE(fs::exists(second.control()));
    }
    EXPECT_EQ(first.words(), original_words);
    first.process.signal(SIGKILL);
    ASSERT_EQ(first.process.wait(), 128 + SIGKILL);
    const Service second(other, {"--registers", "file:" + first.registers()});
    EXPECT_TRUE(second.ready()) << "the lock has ended with its process";
}

/// Taken only later, it is one more thing that is not there.
TEST(OneOwner, RegistersThatAnotherServiceTookMeanwhileAreLookedFor)
{
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const Service first(folder, {"--registers", "file:" + folder / "run/registers"});
    ASSERT_TRUE(first.ready());
    EXPECT_EQ(first.status("hardware"), "absent") << "its folder is missing";
    fs::create_directory(other / "run");
    {
        const Service second(other, {"--registers", "file:" + other / "run/registers"});
        ASSERT_TRUE(second.ready());
        fs::create_directory_symlink(other / "run", folder / "run");
        ASSERT_TRUE(
            first.says("no register block: " + folder / "run/registers" + " is " + name_of(second)))
            << first.process.errors();
        EXPECT_EQ(first.status("hardware"), "absent");
    }
    EXPECT_TRUE(eventually([&] { return first.status("hardware") == "ok"; }));
}

TEST(OneOwner, TheTerminalsLinkIsKeptUntilItsServiceEnds)
{
    for (const int how : {SIGTERM, SIGKILL}) {
        const TemporaryFolder folder;
        const TemporaryFolder other;
        Service first(folder);
        ASSERT_TRUE(first.ready());
        const Service second(other, {"--serial", "pty:" + first.terminal()});
        ASSERT_TRUE(second.ready());
        ASSERT_TRUE(second.says(name_of(first))) << second.process.errors();
        EXPECT_EQ(second.status("serial"), "down");
        Host host = Host::on_terminal(first.terminal());
        EXPECT_EQ(host.ask("SET ZM=7"), "OK seq=1 changed=1");
        EXPECT_EQ(first.status("applied"), "1") << "the host is the first one's";
        first.process.signal(how);
        ASSERT_NE(first.process.wait(), -1);
        ASSERT_TRUE(eventually([&] { return second.status("serial") == "up"; }));
        EXPECT_EQ(Host::on_terminal(first.terminal()).ask("SET ZM=8"), "OK seq=1 changed=1");
        EXPECT_EQ(second.status("applied"), "1");
        EXPECT_EQ(second.count(name_of(first)), 1U) << "said once";
    }
}

TEST(OneOwner, TheSocketIsKeptUntilItsServiceEnds)
{
    for (const int how : {SIGTERM, SIGKILL}) {
        const TemporaryFolder folder;
        const TemporaryFolder other;
        Service first(folder);
        ASSERT_TRUE(first.ready());
        const Service second(other, {"--control", first.control()});
        Host host = Host::on_terminal(second.terminal());
        EXPECT_EQ(host.ask("SET ZM=9"), "OK seq=1 changed=1") << "it serves its other hosts";
        ASSERT_TRUE(second.says(name_of(first))) << second.process.errors();
        EXPECT_EQ(Host::on_socket(first.control()).ask("GET ZM"), "OK ZM=3");
        first.process.signal(how);
        ASSERT_NE(first.process.wait(), -1);
        ASSERT_TRUE(eventually([&] {
            Host next = Host::on_socket(first.control());
            return next.connected() && next.ask("GET ZM") == "OK ZM=9";
        })) << "it looks again, and gets it";
        EXPECT_EQ(second.count(name_of(first)), 1U) << "said once";
    }
}

TEST(OneOwner, NoLockIsLeftBehindByACleanEnd)
{
    const TemporaryFolder folder;
    Service service(folder);
    ASSERT_TRUE(service.ready());
    service.process.signal(SIGTERM);
    ASSERT_EQ(service.process.wait(), 0);
    for (const auto& entry : fs::directory_iterator(folder / ""))
        EXPECT_NE(entry.path().extension(), ".lock") << entry.path();
}

} // namespace
} // namespace raymarch::tests
