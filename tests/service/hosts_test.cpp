// SPDX-License-Identifier: MIT
/// @file
/// The service and its hosts: frames over a terminal, several clients, hosts that misbehave.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <stdlib.h>

namespace raymarch::tests
{
namespace
{

TEST(Hosts, FrameOverTheTerminalReachesTheRegisters)
{
    const TemporaryFolder folder;
    const Service service(folder);
    Host host = Host::on_terminal(service.terminal());
    EXPECT_EQ(host.ask("SET OBJ=tunnel,ZM=1"), "OK seq=1 changed=2");
    EXPECT_EQ(host.ask(original_line + "\r"), "OK seq=2 changed=2");
    EXPECT_EQ(service.words(), original_words);
}

TEST(Hosts, BytesMayComeOneByOne)
{
    const TemporaryFolder folder;
    const Service service(folder);
    Host host = Host::on_terminal(service.terminal());
    for (const char c : original_line + "\r\n")
        host.send({&c, 1});
    EXPECT_EQ(host.reply(), "OK seq=1 changed=0");
}

TEST(Hosts, FaultyFrameLeavesEverythingAsItWas)
{
    const TemporaryFolder folder;
    const Service service(folder);
    Host host = Host::on_terminal(service.terminal());
    EXPECT_EQ(host.ask("SET ZM=5,LX=64").substr(0, 23), "ERR RANGE col=13 key=LX");
    EXPECT_EQ(host.ask("GET ZM"), "OK ZM=3");
    EXPECT_EQ(service.words(), original_words);
}

TEST(Hosts, TwoClientsAndTheTerminalAtOnce)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Host first = Host::on_socket(service.control());
    Host second = Host::on_socket(service.control());
    Host third = Host::on_terminal(service.terminal());
    // Interleaved in the middle of lines: each has a line of its own.
    first.send("SET Z");
    second.send("SET LX=");
    third.send("SET OBJ=");
    first.send("M=4\n");
    EXPECT_EQ(first.reply(), "OK seq=1 changed=1");
    second.send("7\n");
    EXPECT_EQ(second.reply(), "OK seq=2 changed=1");
    third.send("cube\n");
    EXPECT_EQ(third.reply(), "OK seq=3 changed=1");
    EXPECT_EQ(first.ask("GET ZM,LX,OBJ"), "OK ZM=4,LX=7,OBJ=cube");
}

TEST(Hosts, HalfALineThenHangUpIsForgotten)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Host::on_terminal(service.terminal()).send("SET ZM=9,LX=");
    ASSERT_TRUE(eventually([&] { return service.status("hang_ups") == "1"; }));
    Host next = Host::on_terminal(service.terminal());
    EXPECT_EQ(next.ask("PING"), "OK") << "the next host starts with an empty line";
    EXPECT_EQ(next.ask("GET ZM"), "OK ZM=3");
}

TEST(Hosts, RepliesThatOneHostLeftDoNotGreetTheNext)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Host::on_terminal(service.terminal()).send(original_line + "\r\nGET\r\n");
    ASSERT_TRUE(eventually([&] { return service.status("hang_ups") == "1"; }));
    EXPECT_EQ(service.status("applied"), "1") << "what was said before the hang-up counts";
    EXPECT_EQ(Host::on_terminal(service.terminal()).ask("PING"), "OK");
}

TEST(Hosts, HostThatNeverReadsIsDroppedNotWaitedFor)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Host silent = Host::on_terminal(service.terminal());
    for (int i = 0; i < 2000; ++i) // 2000 replies of some 130 bytes: more than any buffer holds
        silent.send("GET\n");
    ASSERT_TRUE(eventually([&] { return service.status("dropped_replies") != "0"; }));
    Host other = Host::on_socket(service.control());
    EXPECT_EQ(other.ask("PING"), "OK") << "others are served meanwhile";
    EXPECT_EQ(other.ask("SET ZM=2"), "OK seq=1 changed=1");
}

TEST(Hosts, EchoModeIsForPeople)
{
    const TemporaryFolder folder;
    const Service service(folder);
    Host host = Host::on_terminal(service.terminal());
    EXPECT_EQ(host.ask("ECHO on"), "OK");
    host.send("PIMM\b\bNG\r");
    EXPECT_EQ(host.reply(), "PIMM\b \b\b \bNG");
    EXPECT_EQ(host.reply(), "OK");
}

TEST(Hosts, SerialDeviceIsRawAndRetriedWhenItGoes)
{
    const TemporaryFolder folder;
    UniqueFd line(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    ASSERT_TRUE(line);
    ASSERT_EQ(::grantpt(line.get()), 0);
    ASSERT_EQ(::unlockpt(line.get()), 0);
    std::array<char, 64> name{};
    ASSERT_EQ(::ptsname_r(line.get(), name.data(), name.size()), 0);

    const Service service(folder, {"--serial", std::string(name.data()) + "@9600"});
    ASSERT_TRUE(service.ready());
    ASSERT_TRUE(eventually([&] { return service.status("serial") == "up"; }));
    {
        Host host(std::move(line));
        EXPECT_EQ(host.ask("PING"), "OK") << "no echo before it: the line is raw";
    } // the cable is pulled
    EXPECT_TRUE(eventually([&] { return service.status("serial") == "down"; }));
    EXPECT_TRUE(service.ready());
}

} // namespace
} // namespace raymarch::tests
