// SPDX-License-Identifier: MIT
/// Several hosts at once: none of them holds up the others, and one that reads loses no reply.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <list>
#include <string>

namespace raymarch::tests
{
namespace
{

std::string repeated(std::string_view line, int count)
{
    std::string lines;
    for (int i = 0; i < count; ++i)
        lines += line;
    return lines;
}

/// The mandelbulb's dearest steps, on a small picture.
class BesideAFlood : public testing::Test
{
  protected:
    BesideAFlood()
    {
        EXPECT_TRUE(service.ready());
        Host host = Host::on_socket(service.control());
        for (const std::string line :
             {"ACCELERATOR mandelbulb", "PRESET deep58", "SET N=64,K=64,I=64"})
            EXPECT_TRUE(host.ask(line).starts_with("OK")) << line;
    }
    [[nodiscard]] unsigned long applied() const { return std::stoul(service.status("applied")); }

    const TemporaryFolder folder;
    Service service{folder, {"--registers", "emulated", "--emulated-size", "16x16"}};
    static constexpr int lines = 900; ///< far more work than the test has time for
    const std::string flood = repeated("WALK forward 1000\n", lines);
};

TEST_F(BesideAFlood, OthersAreServed)
{
    const Host hostile = Host::on_socket(service.control());
    hostile.send(flood);
    Host other = Host::on_socket(service.control());
    Host serial = Host::on_terminal(service.terminal());
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(other.ask("PING"), "OK");
        ASSERT_EQ(serial.ask("PING"), "OK");
    }
    ASSERT_TRUE(serial.ask("SET ITER=5").starts_with("ERR UNKNOWN_KEY"));
    ASSERT_TRUE(serial.ask("SET N=32").starts_with("OK seq="));
    EXPECT_LT(applied(), lines) << "the flood was done first";
}

/// The serial port goes first, and still is not alone.
TEST_F(BesideAFlood, OthersAreServedBesideTheSerialPortToo)
{
    const Host hostile = Host::on_terminal(service.terminal());
    hostile.send(repeated("WALK forward 1000\n", 100));
    Host other = Host::on_socket(service.control());
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(other.ask("PING"), "OK");
    EXPECT_LT(applied(), 100U) << "the flood was done first";
}

/// Whoever opens the terminal next gets nothing that the one before has asked for.
TEST_F(BesideAFlood, TheNextHostGetsNoReplyToALongLine)
{
    Host::on_terminal(service.terminal()).send("WALK back 100\nSTATUS\nGET\n");
    ASSERT_TRUE(eventually([&] { return service.status("hang_ups") == "1"; }));
    EXPECT_EQ(Host::on_terminal(service.terminal()).ask("PING"), "OK");
}

TEST_F(BesideAFlood, TheServiceEndsWhenItIsTold)
{
    const Host hostile = Host::on_socket(service.control());
    hostile.send(flood);
    Host other = Host::on_socket(service.control());
    ASSERT_EQ(other.ask("PING"), "OK");
    service.process.signal(SIGTERM);
    EXPECT_EQ(service.process.wait(), 0);
    EXPECT_FALSE(std::filesystem::exists(service.control()));
    EXPECT_FALSE(std::filesystem::is_symlink(service.terminal()));
}

/// The picture takes minutes; neither another accelerator nor the end of the service waits for it.
TEST(Turns, AFrameThatIsBeingDrawnIsNotWaitedFor)
{
    const TemporaryFolder folder;
    Service service(folder, {"--registers", "emulated", "--emulated-size", "1920x1080", "--state",
                             folder / "state"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(host.ask("ACCELERATOR mandelbulb"), "OK accelerator=mandelbulb");
        EXPECT_TRUE(host.ask("PRESET deep58").starts_with("OK seq="));
        EXPECT_TRUE(host.ask("SET N=64,K=64,I=64").starts_with("OK seq="));
        EXPECT_EQ(host.ask("ACCELERATOR whitted"), "OK accelerator=whitted");
        EXPECT_TRUE(host.ask("PRESET").starts_with("OK presets="));
    }
    EXPECT_EQ(host.ask("ACCELERATOR mandelbulb"), "OK accelerator=mandelbulb");
    service.process.signal(SIGTERM);
    EXPECT_EQ(service.process.wait(), 0) << service.process.errors();
    EXPECT_FALSE(std::filesystem::exists(service.control()));
    EXPECT_FALSE(std::filesystem::is_symlink(service.terminal()));
    EXPECT_TRUE(std::filesystem::exists(folder / "state")) << "what was asked for is kept";
}

/// The drawing thread draws what the block has become, whatever it was busy with.
TEST(Turns, AfterASwitchThePictureIsTheNewOne)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated", "--emulated-size", "160x120"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("ACCELERATOR mandelbulb"), "OK accelerator=mandelbulb");
    EXPECT_EQ(host.ask("ACCELERATOR marcher"), "OK accelerator=marcher");
    EXPECT_TRUE(eventually([&] { return service.status("frames") == "1"; }))
        << service.status("frames");
    EXPECT_EQ(service.status("accelerator"), "marcher");
}

class Burst : public testing::TestWithParam<bool>
{
  protected:
    [[nodiscard]] Host host() const
    {
        return GetParam() ? Host::on_socket(service.control())
                          : Host::on_terminal(service.terminal());
    }
    const TemporaryFolder folder;
    const Service service{folder};
    const bool is_ready = service.ready();
};
INSTANTIATE_TEST_SUITE_P(Ports, Burst, testing::Bool(), [](const auto& row) {
    return row.param ? std::string("Socket") : std::string("Terminal");
});

TEST_P(Burst, AHostThatReadsLosesNoReply)
{
    Host one = host();
    // A terminal holds 4096 bytes for the service; more would wait in send().
    one.send(repeated("GET\n", 900) + repeated("HELP\n", 20) + "PING\n");
    for (int i = 0; i < 900; ++i)
        ASSERT_TRUE(one.reply().starts_with("OK FX=")) << i;
    for (int i = 0; i < 20; ++i) {
        std::string line = "#";
        while (line.starts_with("#"))
            line = one.reply();
        ASSERT_EQ(line, "OK") << i;
    }
    EXPECT_EQ(one.reply(), "OK");
    EXPECT_EQ(service.status("dropped_replies"), "0");
}

TEST_P(Burst, EnterIsCarriageReturn)
{
    Host one = host();
    one.send("PING\r");
    EXPECT_EQ(one.reply(), "OK");
    one.send("\nPING\r\nGET ZM\r");
    EXPECT_EQ(one.reply(), "OK");
    EXPECT_EQ(one.reply(), "OK ZM=3");
}

TEST_P(Burst, AnEchoIsNotAnswered)
{
    Host one = host();
    for (const std::string_view line : {"PING", "hello", "SET ZM=11", "GET", "PING*10"})
        one.send(one.ask(line) + "\r\n");
    const std::string status = one.ask("STATUS");
    EXPECT_NE(status.find(" rejected=2 echoed=5 "), std::string::npos) << status;
}

/// The place of a client that has closed is free at once.
TEST(Turns, AClosedConnectionKeepsNoPlace)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    std::list<Host> hosts;
    for (int i = 0; i < 16; ++i)
        ASSERT_EQ(hosts.emplace_back(Host::on_socket(service.control())).ask("PING"), "OK");
    for (int i = 0; i < 50; ++i) {
        hosts.pop_front();
        ASSERT_EQ(hosts.emplace_back(Host::on_socket(service.control())).ask("PING"), "OK") << i;
    }
}

/// Every reply is read or counted.
TEST(Turns, AHostThatClosesItsSendingSideGetsItsReplies)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const int lines : {1, 1000, 20'000}) {
        const auto dropped_before = std::stoul(service.status("dropped_replies"));
        Host host = Host::on_socket(service.control());
        host.send(repeated("GET\n", lines));
        ASSERT_EQ(::shutdown(host.fd(), SHUT_WR), 0);
        // What has not been read for long is dropped, so that the connection can end.
        if (lines == 20'000) {
            ASSERT_TRUE(eventually([&] { return service.status("clients") == "1"; }));
        }
        unsigned long read = 0;
        while (host.reply().starts_with("OK FX="))
            ++read;
        const auto dropped = std::stoul(service.status("dropped_replies")) - dropped_before;
        EXPECT_EQ(read + dropped, static_cast<unsigned long>(lines)) << read << " read";
        if (lines < 20'000) {
            EXPECT_EQ(dropped, 0U) << lines;
        }
    }
}

} // namespace
} // namespace raymarch::tests
