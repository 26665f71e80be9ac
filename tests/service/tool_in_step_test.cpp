// SPDX-License-Identifier: MIT
/// @file
/// raymarchctl on a line that an earlier host has left in whatever state.
#include "service/far_end.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>

#include <sysexits.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <utility>

namespace raymarch::tests
{
namespace
{

std::vector<std::string> joined(std::vector<std::string> front,
                                const std::vector<std::string>& more)
{
    front.insert(front.end(), more.begin(), more.end());
    return front;
}

Finished run_at(const TemporaryFolder& folder, const FarEnd& far_end,
                std::vector<std::string> command, std::string_view input = {})
{
    return run_tool(folder, joined(std::move(command), far_end.options()), input);
}

std::vector<Left> lefts()
{
    using namespace std::string_literals;
    std::string many;
    for (int i = 0; i < 300; ++i)
        many += "OK seq=" + std::to_string(i) + " changed=1\r\n";
    return {
        {},
        {.sent = "SET ZM"},
        {.sent = "GET "},
        {.sent = "\x01\xFF\0junk"s},
        {.sent = std::string(1024, 'x')},
        {.sent = std::string(1025, 'x')},
        {.sent = std::string(2000, 'x')},
        {.sent = std::string(5000, 'x')},
        {.sent = "ECHO on\nGET"},
        {.coming = "OK seq=7 changed=3\r\n"},
        {.coming = "OK\r\nOK\r\nOK\r\n"},
        {.coming = "ERR RANGE col=4 key=FX : FX is a number -1 to 1\r\n"},
        {.coming = "# HELP [WORD] : explains\r\n# GET\r\nOK\r\n"},
        {.coming = "# HELP [WORD] : explains\r\n"},
        {.coming = "nged=3\r\n"},
        {.coming = "OK seq=7 cha"},
        {.coming = "ERR"},
        {.coming = "\xFF\xFE\0\r\n\n\n"s},
        {.coming = many},
        {.coming = marked("OK") + marked("OK") + marked("OK")},
        {.coming = marked("OK accelerator=fractal")},
        {.coming = marked("OK accelerator=fractal") + marked("OK X=1,Y=1,Z=1,FX=1,FY=1")},
        {.coming = marked("OK accelerator=marcher")},
        {.coming = marked("OK accelerator=marcher serial=up uptime=1")},
        {.coming = marked("ERR ARGUMENT col=5 key=ABCDEFGHIJKLMNOP : GET takes keys")},
        {.coming = marked("OK ZM=9,FX=1")},
        {.sent = "SET ZM", .coming = "OK ZM=9\r\nOK", .echoes = true},
        {.echoes = true},
    };
}

TEST(ToolInStep, ALineLeftInAnyStateAnswersItsFirstCommand)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const Left& left : lefts()) {
        for (const FarEnd::Place place : places) {
            SCOPED_TRACE(testing::PrintToString(left.sent.substr(0, 40)) + ", then " +
                         testing::PrintToString(left.coming.substr(0, 60)));
            const FarEnd line(folder, place, relays(service.control(), left));
            const Finished sent = run_at(folder, line, {"send", "PING", "GET ZM", "HELP ZM"});
            EXPECT_EQ(sent.status, EX_OK) << sent.errors;
            EXPECT_TRUE(sent.output.starts_with("OK\nOK ZM=3\n# ZM : ")) << sent.output;
        }
    }
}

TEST(ToolInStep, EverySubcommandMakesTheSameFirstContact)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Left left = {.sent = std::string(2000, 'x'),
                       .coming = "OK seq=7 changed=3\r\n" + marked("OK accelerator=sphere")};
    for (const FarEnd::Place place : places) {
        const FarEnd status_line(folder, place, relays(service.control(), left));
        const Finished status = run_at(folder, status_line, {"status"});
        EXPECT_EQ(status.status, EX_OK) << status.errors;
        EXPECT_TRUE(status.output.starts_with("accelerator              marcher\n"))
            << status.output;
        EXPECT_EQ(status.output.find('*'), std::string::npos) << status.output;

        const FarEnd watch_line(folder, place, relays(service.control(), left));
        const Finished watch = run_at(folder, watch_line, {"watch", "--count", "1"});
        EXPECT_EQ(watch.status, EX_OK) << watch.errors;
        EXPECT_NE(watch.output.find(" accelerator=marcher "), std::string::npos) << watch.output;
        EXPECT_NE(watch.output.find(" OBJ=sphere\n"), std::string::npos) << watch.output;

        const FarEnd console_line(folder, place, relays(service.control(), left));
        const Finished console = run_at(folder, console_line, {"console"}, "PING\nGET ZM\n");
        EXPECT_EQ(console.status, EX_OK) << console.errors;
        EXPECT_EQ(console.output, "OK\nOK ZM=3\n");

        const FarEnd conformance_line(folder, place, relays(service.control(), left));
        const Finished conformance = run_at(folder, conformance_line, {"conformance"});
        EXPECT_EQ(conformance.status, EX_OK) << conformance.output << conformance.errors;
    }
}

TEST(ToolInStep, APortMayHaveAnAtInItsPath)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    std::filesystem::create_directory(folder / "jane@corp.example");
    for (const std::string name : {"jane@corp.example/tty", "tty@home", "tty@9600"}) {
        std::filesystem::create_symlink(service.terminal(), folder / name);
        for (const std::string rate : {"", "@115200"}) {
            const Finished sent =
                run_tool(folder, {"send", "--port", folder / name + rate, "PING"});
            EXPECT_EQ(sent.output, "OK\n") << name << rate << ": " << sent.errors;
        }
    }
    EXPECT_EQ(run_tool(folder, {"send", "--port", folder / "none@fast", "PING"}).status, EX_USAGE);
}

TEST(ToolInStep, LinesThatLookLikeListsAreLines)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished sent = run_tool(folder, {"send", "--socket", service.control(), "[PING,VERSION]",
                                            "{}", "%%", "[]", "PING", "# no line", "OK", " "});
    EXPECT_EQ(sent.status, 1);
    EXPECT_EQ(std::ranges::count(sent.output, '\n'), 5) << sent.output;
    EXPECT_TRUE(sent.output.ends_with("\nOK\n")) << sent.output;
    const Finished words = run_tool(folder, {"decode", "[1,2]"});
    EXPECT_NE(words.errors.find("8 register words, not 1"), std::string::npos) << words.errors;
    const Finished view = run_tool(folder, {"sheet", "-o", folder / "x.ppm", "[a,b]"});
    EXPECT_NE(view.errors.find("'[a,b]'"), std::string::npos) << view.errors;
    const Finished many = run_tool(folder, {"send", "PING", "--socket", service.control(), "PING"});
    EXPECT_EQ(many.output, "OK\nOK\n") << many.errors;
}

TEST(ToolInStep, TheFirstContactLeavesNoTrace)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const std::string subcommand : {"status", "console"})
        EXPECT_EQ(run_tool(folder, {subcommand, "--socket", service.control()}).status, EX_OK);
    EXPECT_EQ(run_tool(folder, {"watch", "--count", "1", "--port", service.terminal()}).status,
              EX_OK);
    EXPECT_EQ(service.status("rejected"), "0");
    EXPECT_EQ(service.status("applied"), "0");
}

TEST(ToolInStep, AServiceThatWantsMarksGetsThem)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--require-checksum", "true"});
    ASSERT_TRUE(eventually([&] { return Host::on_socket(service.control()).connected(); }));
    const Finished status = run_tool(folder, {"status", "--socket", service.control()});
    EXPECT_EQ(status.status, EX_OK) << status.errors;
    EXPECT_NE(status.output.find("hardware                 ok\n"), std::string::npos);
    const Finished watch =
        run_tool(folder, {"watch", "--count", "1", "--port", service.terminal()});
    EXPECT_EQ(watch.status, EX_OK) << watch.errors;
    // Lines of a user go out as they were typed, and so do their replies.
    const Finished typed =
        run_tool(folder, {"send", "--socket", service.control(), "PING", "PING*10", "PING*11"});
    EXPECT_EQ(typed.status, 1);
    EXPECT_TRUE(typed.output.starts_with("ERR CHECKSUM : ")) << typed.output;
    EXPECT_NE(typed.output.find("\nOK*04\nERR CHECKSUM col=6 : "), std::string::npos)
        << typed.output;
}

TEST(ToolInStep, AServiceThatSendsErrorsOnlyIsCalledSo)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--replies", "errors"});
    ASSERT_TRUE(eventually([&] { return Host::on_socket(service.control()).connected(); }));
    const Finished refused = run_tool(folder, {"send", "--socket", service.control(), "SET ZM=11"});
    EXPECT_EQ(refused.status, 1) << refused.errors;
    EXPECT_TRUE(refused.output.starts_with("ERR RANGE col=8 key=ZM")) << refused.output;
    const Finished taken = run_tool(folder, {"send", "--socket", service.control(), "SET ZM=2"});
    EXPECT_EQ(taken.status, EX_IOERR);
    EXPECT_EQ(taken.output, "");
    EXPECT_NE(taken.errors.find("no reply to 'SET ZM=2' came in time; the far end sends only ERR "
                                "replies"),
              std::string::npos)
        << taken.errors;
    EXPECT_EQ(service.words().at(1), 0x02000000U);
    const Finished status = run_tool(folder, {"status", "--socket", service.control()});
    EXPECT_EQ(status.status, EX_IOERR);
    EXPECT_EQ(status.output, "");
}

TEST(ToolInStep, AServiceThatSaysNothingStillGetsTheLine)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--replies", "none"});
    ASSERT_TRUE(eventually([&] { return Host::on_socket(service.control()).connected(); }));
    const Finished sent = run_tool(folder, {"send", "--socket", service.control(), "SET ZM=2"});
    EXPECT_EQ(sent.status, EX_IOERR);
    EXPECT_EQ(sent.output, "");
    EXPECT_NE(sent.errors.find("replies is none"), std::string::npos) << sent.errors;
    EXPECT_EQ(service.words().at(1), 0x02000000U);
}

TEST(ToolInStep, AFarEndThatIsDeadIsAnError)
{
    const TemporaryFolder folder;
    for (const FarEnd::Place place : places) {
        const bool echoes = place == FarEnd::Place::Terminal;
        const FarEnd dead(folder, place, [echoes](int fd) {
            for (std::string bytes = read_bytes(fd); !bytes.empty(); bytes = read_bytes(fd))
                if (echoes)
                    write_all(fd, bytes);
        });
        const Finished status = run_at(folder, dead, {"status"});
        EXPECT_EQ(status.status, EX_IOERR);
        EXPECT_EQ(status.output, "");
        EXPECT_NE(status.errors.find("nothing answers at the far end"), std::string::npos)
            << status.errors;
    }
}

/// Not the protocol's rules of marks, but replies.
/// As at a wrong baud rate: bytes come without a pause, and no line ever ends.
TEST(ToolInStep, AFarEndThatNeverEndsALineIsGivenUp)
{
    const TemporaryFolder folder;
    const FarEnd far(folder, FarEnd::Place::Socket, [](int fd) {
        while (::send(fd, "x", 1, MSG_NOSIGNAL) == 1) // the tool leaves first
            std::this_thread::sleep_for(std::chrono::milliseconds{20});
    });
    const Finished status = run_at(folder, far, {"status"});
    EXPECT_EQ(status.status, EX_IOERR);
    EXPECT_EQ(status.output, "");
    EXPECT_NE(status.errors.find("no line ends"), std::string::npos) << status.errors;
}

TEST(ToolInStep, AFarEndThatKnowsNoMarksIsAskedWithoutThem)
{
    const TemporaryFolder folder;
    const FarEnd simple(folder, FarEnd::Place::Socket, answers([](const std::string& line) {
                            return line == "STATUS" ? "OK hardware=ok\r\n"
                                                    : "ERR UNKNOWN_COMMAND col=1 : what?\r\n";
                        }));
    const Finished status = run_at(folder, simple, {"status"});
    EXPECT_EQ(status.status, EX_OK) << status.errors;
    EXPECT_EQ(status.output, "hardware                 ok\n");
}

TEST(ToolInStep, AReplyWithoutFieldsIsNoStatus)
{
    const TemporaryFolder folder;
    const FarEnd vague(folder, FarEnd::Place::Socket,
                       answers([](const std::string&) { return marked("OK"); }));
    const Finished status = run_at(folder, vague, {"status"});
    EXPECT_EQ(status.status, EX_IOERR);
    EXPECT_EQ(status.output, "");
    EXPECT_NE(status.errors.find("the reply to STATUS is 'OK'"), std::string::npos)
        << status.errors;
}

TEST(ToolInStep, HalfAReplyAndThenTheEndIsNoReply)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const FarEnd line(folder, FarEnd::Place::Socket, [](int fd) {
        static_cast<void>(read_bytes(fd));
        write_all(fd, "OK accelerator=mar");
    });
    const Finished status = run_at(folder, line, {"status"});
    EXPECT_EQ(status.status, EX_IOERR);
    EXPECT_EQ(status.output, "");
    EXPECT_NE(status.errors.find("closed the connection after 'OK accelerator=mar'"),
              std::string::npos)
        << status.errors;
}

TEST(ToolInStep, AFarEndThatWaitsForItsRepliesToBeReadIsNotWaitedFor)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    // From the long line on it says much before it reads any further.
    const FarEnd line(folder, FarEnd::Place::Socket, [&](int fd) {
        Host host = Host::on_socket(service.control());
        bool said = false;
        std::string pending;
        for (std::string bytes = read_bytes(fd); !bytes.empty(); bytes = read_bytes(fd)) {
            pending += bytes;
            if (pending.size() > 4096 && !std::exchange(said, true))
                for (int i = 0; i < 4000; ++i)
                    write_all(fd, "# " + std::string(998, 'x') + "\r\n");
            for (std::size_t end = pending.find('\n'); end != std::string::npos;
                 end = pending.find('\n')) {
                if (end > 0)
                    write_all(fd, host.ask(pending.substr(0, end)) + "\r\n");
                pending.erase(0, end + 1);
            }
        }
    });
    const Finished console =
        run_at(folder, line, {"console"}, std::string(4'000'000, 'x') + "\nPING\n");
    EXPECT_EQ(console.status, 1) << console.errors;
    EXPECT_TRUE(console.output.ends_with("\nOK\n"));
    EXPECT_NE(console.output.find("\nERR TOO_LONG : "), std::string::npos);
}

TEST(ToolInStep, WatchEndsQuietlyWhenNobodyReadsIt)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    // The shell's own way, which leaves SIGPIPE as it is, and a service manager's, which ignores
    // it.
    for (const std::string trap : {"", "trap '' PIPE; "}) {
        const std::string command =
            trap + "{ \"$0\" watch --interval 0.05 --socket \"$1\"; echo $? >\"$2\"; } | head -1";
        Process shell({"/bin/sh", "-c", command, RAYMARCHCTL, service.control(), folder / "status"},
                      folder / "shell");
        EXPECT_EQ(shell.wait(), 0);
        EXPECT_EQ(shell.errors(), "");
        EXPECT_EQ(std::ranges::count(shell.output(), '\n'), 1);
        Process cat({"/bin/cat", folder / "status"}, folder / "cat");
        EXPECT_EQ(cat.wait(), 0);
        EXPECT_EQ(cat.output(), "0\n");
    }
}

TEST(ToolInStep, WatchSaysThatTheServiceEnded)
{
    const TemporaryFolder folder;
    for (const bool terminal : {false, true}) {
        Service service(folder);
        ASSERT_TRUE(service.ready());
        const std::string option = terminal ? "--port" : "--socket";
        const std::string place = terminal ? service.terminal() : service.control();
        Process watch({RAYMARCHCTL, "watch", "--interval", "0.05", option, place},
                      folder / "watch");
        ASSERT_TRUE(eventually([&] { return !watch.output().empty(); })) << watch.errors();
        service.process.signal(SIGTERM);
        EXPECT_EQ(watch.wait(), EX_IOERR);
        EXPECT_NE(watch.errors().find("the service closed the connection"), std::string::npos)
            << watch.errors();
        EXPECT_EQ(service.process.wait(), 0);
    }
}

TEST(ToolInStep, CtrlCEndsAWaitAndTheNextRunIsInStep)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    Process watch({RAYMARCHCTL, "watch", "--port", service.terminal()}, folder / "watch");
    ASSERT_TRUE(eventually([&] { return !watch.output().empty(); })) << watch.errors();
    watch.signal(SIGINT);
    EXPECT_EQ(watch.wait(), 128 + SIGINT);
    EXPECT_EQ(watch.errors(), "");
    const Finished next = run_tool(folder, {"send", "--port", service.terminal(), "GET ZM"});
    EXPECT_EQ(next.output, "OK ZM=3\n") << next.errors;
}

TEST(ToolInStep, CtrlCEndsTheFirstContact)
{
    const TemporaryFolder folder;
    std::atomic<bool> there = false;
    const FarEnd dead(folder, FarEnd::Place::Terminal, [&](int fd) {
        while (!read_bytes(fd).empty())
            there = true;
    });
    Process status(joined({RAYMARCHCTL, "status"}, dead.options()), folder / "status");
    ASSERT_TRUE(eventually([&] { return there.load(); }));
    status.signal(SIGINT);
    EXPECT_EQ(status.wait(), 128 + SIGINT);
    EXPECT_EQ(status.errors(), "");
}

} // namespace
} // namespace raymarch::tests
