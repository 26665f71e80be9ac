// SPDX-License-Identifier: MIT
/// @file
/// What is tried again, how often that is said, and what becomes of clients for whom there is no
/// room.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <thread>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;
constexpr std::size_t most_clients = 16;
const std::string busy = "ERR BUSY : there are 16 clients already";

/// All places at the socket, each with a client that has spoken.
std::vector<Host> fill(const Service& service)
{
    std::vector<Host> clients;
    for (std::size_t i = 0; i < most_clients; ++i) {
        clients.push_back(Host::on_socket(service.control()));
        EXPECT_EQ(clients.back().ask("PING"), "OK");
    }
    return clients;
}

TEST(Retries, ClientsThatAreTurnedAwayHearWhyAndTheLogSaysItOnce)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    std::vector<Host> clients = fill(service);
    for (std::size_t i = 0; i < 300; ++i) {
        Host late = Host::on_socket(service.control());
        ASSERT_TRUE(late.connected());
        ASSERT_EQ(late.reply(), busy);
        ASSERT_EQ(late.reply(), "") << "and it is closed";
        ASSERT_EQ(clients[i % most_clients].ask("PING"), "OK");
    }
    EXPECT_EQ(service.count("turned away"), 1U) << service.process.errors();
    clients.pop_back();
    EXPECT_TRUE(eventually([&] {
        Host next = Host::on_socket(service.control());
        return next.connected() && next.ask("PING") == "OK";
    }));
}

/// Connections that say nothing do not lock others out; those that speak are not closed.
TEST(Retries, TheClientThatIsSilentLongestGivesWay)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    std::vector<Host> clients = fill(service);
    Host& silent = clients[most_clients / 2];
    EXPECT_TRUE(eventually([&] {
        for (Host& client : clients)
            if (&client != &silent) {
                EXPECT_EQ(client.ask("PING"), "OK");
            }
        Host next = Host::on_socket(service.control());
        const std::string reply = next.ask("PING");
        EXPECT_TRUE(reply == "OK" || reply == busy) << reply;
        return reply == "OK";
    }));
    EXPECT_EQ(silent.reply(), "") << "its connection is closed";
    for (Host& client : clients)
        if (&client != &silent) {
            EXPECT_EQ(client.ask("PING"), "OK");
        }
}

/// The service may open `more` further descriptors: those are the lowest numbers that are free.
void allow_descriptors(const Service& service, unsigned more)
{
    const std::string path = "/proc/" + std::to_string(service.process.pid()) + "/fd/";
    rlim_t limit = 0;
    for (; more > 0; ++limit)
        more -= fs::exists(fs::symlink_status(path + std::to_string(limit))) ? 0 : 1;
    const rlimit limits = {.rlim_cur = limit, .rlim_max = 1024};
    ASSERT_EQ(::prlimit(service.process.pid(), RLIMIT_NOFILE, &limits, nullptr), 0);
}

/// Each shortage is logged, once, and over when there are descriptors again.
TEST(Retries, ClientsWaitWhileThereAreNoDescriptors)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (std::size_t shortage = 1; shortage <= 2; ++shortage) {
        std::vector<Host> clients;
        Host terminal = Host::on_terminal(service.terminal());
        // The service has closed its ends of those before, too.
        ASSERT_TRUE(eventually(
            [&] { return terminal.ask("STATUS").find(" clients=0 ") != std::string::npos; }));
        allow_descriptors(service, 3);
        for (std::size_t i = 1; i < most_clients; ++i) {
            clients.push_back(Host::on_socket(service.control()));
            clients.back().send("PING\n");
        }
        ASSERT_TRUE(eventually([&] { return service.count("Too many open files") == shortage; }))
            << service.process.errors();
        EXPECT_EQ(terminal.ask("PING"), "OK") << "others are served";
        allow_descriptors(service, 100);
        for (Host& client : clients)
            EXPECT_EQ(client.reply(), "OK");
    }
}

/// A pseudo-terminal that plays a serial device: its line's end, and the name of the device.
struct Line
{
    UniqueFd end{::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
    std::array<char, 64> name{};
    Line()
    {
        EXPECT_EQ(::grantpt(end.get()), 0);
        EXPECT_EQ(::unlockpt(end.get()), 0);
        EXPECT_EQ(::ptsname_r(end.get(), name.data(), name.size()), 0);
    }
};

TEST(Retries, ASerialDeviceThatComesBackIsUsedAgain)
{
    const TemporaryFolder folder;
    const std::string device = folder / "ttyUSB0";
    const Service service(folder, {"--serial", device + "@9600"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("serial"), "down");
    for (int times = 0; times < 2; ++times) {
        Line line;
        fs::create_symlink(line.name.data(), device);
        ASSERT_TRUE(eventually([&] { return service.status("serial") == "up"; }));
        {
            Host host(std::move(line.end));
            EXPECT_EQ(host.ask("PING"), "OK");
            fs::remove(device);
        } // the cable is pulled
        ASSERT_TRUE(eventually([&] { return service.status("serial") == "down"; }));
    }
    EXPECT_EQ(service.count("the serial port has gone away"), 2U);
}

/// A serial device that another program has locked, as terminal programs do, is looked for.
TEST(Retries, ASerialDeviceInUseIsLookedFor)
{
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const Line line;
    const std::vector<std::string> options = {"--serial", line.name.data()};
    Service first(other, options);
    ASSERT_TRUE(first.ready());
    const Service second(folder, options);
    ASSERT_TRUE(second.says("in use by process " + std::to_string(first.process.pid()) + " ("))
        << second.process.errors();
    ASSERT_TRUE(second.ready()); // it says so before it listens
    EXPECT_EQ(second.status("serial"), "down");
    first.process.signal(SIGTERM);
    ASSERT_EQ(first.process.wait(), 0);
    EXPECT_TRUE(eventually([&] { return second.status("serial") == "up"; }));
}

/// Nothing here waits for an event: the longer the service is left alone, the more it would say.
TEST(Retries, WhatIsMissingIsSaidOnce)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "in the way");
    const std::vector<std::pair<std::string, std::vector<std::string>>> missing = {
        {"no register block", {"--registers", "file:" + folder / "missing/registers"}},
        {"no serial host", {"--serial", folder / "missing/tty"}},
        {"no serial host", {"--serial", "pty:" + folder / "in the way"}},
        {"no control socket", {"--control", folder / "missing/control"}},
        {"no control socket", {"--control", folder / "in the way"}},
    };
    for (const auto& [message, options] : missing) {
        const TemporaryFolder own;
        const Service service(own, options);
        ASSERT_TRUE(service.says(message));
        std::this_thread::sleep_for(std::chrono::milliseconds(1000)); // looks at 0.25 and 0.75 s
        EXPECT_EQ(service.count(message), 1U) << service.process.errors();
    }
}

TEST(Retries, APreviewThatCannotBeWrittenIsSaidOnce)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated", "--emulated-size", "64x48",
                                   "--preview", folder / "missing/now.png"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    for (int frame = 1; frame <= 3; ++frame) {
        ASSERT_TRUE(eventually([&] { return std::stoi("0" + service.status("frames")) >= frame; }));
        EXPECT_TRUE(host.ask("SET ZM=" + std::to_string(frame + 3)).starts_with("OK"));
    }
    EXPECT_TRUE(service.says("no preview"));
    EXPECT_EQ(service.count("no preview"), 1U) << service.process.errors();
}

/// Each of the four settings that SIGHUP takes, by what it changes.
TEST(Retries, HupTakesEachOfItsSettings)
{
    const TemporaryFolder folder;
    const std::string config = folder / "config.toml";
    const auto write = [&](const std::string& text) { std::ofstream(config) << text; };
    write("");
    const Service service(folder, {"--config", config});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    const auto hup = [&](const std::string& text) {
        write(text);
        service.process.signal(SIGHUP);
    };

    EXPECT_EQ(host.ask("SET FX=1"), "OK seq=1 changed=1 warn=BASIS");
    hup("basis_check = \"off\"\n");
    EXPECT_TRUE(eventually([&] { return host.ask("SET FX=1").find("warn") == std::string::npos; }));
    EXPECT_EQ(service.count("configuration read again"), 1U);

    hup("require_checksum = true\n");
    EXPECT_TRUE(eventually([&] { return host.ask("PING").starts_with("ERR CHECKSUM"); }));
    EXPECT_EQ(host.ask("PING*10").substr(0, 2), "OK");
    EXPECT_EQ(service.count("configuration read again"), 2U);

    // An ERR ends each look, so that a look does not wait for an OK that is not sent.
    hup("replies = \"errors\"\n");
    EXPECT_TRUE(eventually([&] {
        host.send("PING\nNOTHING\n");
        if (host.reply().starts_with("ERR"))
            return true;
        static_cast<void>(host.reply());
        return false;
    }));
    EXPECT_EQ(service.count("configuration read again"), 3U);

    hup("log_level = \"error\"\n");
    EXPECT_TRUE(eventually([&] {
        host.send("PING\nNOTHING\n");
        if (host.reply().starts_with("ERR"))
            return false;
        static_cast<void>(host.reply());
        return true;
    }));
    EXPECT_EQ(service.count("configuration read again"), 3U) << "a notice is none of the errors";
}

} // namespace
} // namespace raymarch::tests
