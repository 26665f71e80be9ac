// SPDX-License-Identifier: MIT
/// @file
/// Tests sources that cannot be added, and exceptions in handlers.
#include "daemon/event_loop.hpp"

#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sys/epoll.h>
#include <sys/resource.h>

#include <cerrno>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using namespace std::chrono_literals;

/// A source that cannot be added does nothing, and the loop reports why.
TEST(EventLoop, ASourceIsNeverNull)
{
    EventLoop loop = *EventLoop::open();
    EXPECT_FALSE(loop.take_problem());
    const auto nothing = [](std::uint32_t) { FAIL(); };
    const Source source = loop.add_io(-1, EPOLLIN, nothing);
    ASSERT_NE(source, nullptr);
    source->watch(EPOLLIN | EPOLLET);
    source->arm(0ms);
    const auto problem = loop.take_problem();
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->kind, ErrorKind::Unavailable);
    EXPECT_NE(problem->message, "");
    EXPECT_FALSE(loop.take_problem()) << "it is told once";

    const test::TemporaryFolder folder;
    const Source watch =
        loop.add_inotify((folder / "missing").c_str(), IN_CREATE, [](const inotify_event&) {});
    ASSERT_NE(watch, nullptr);
    ASSERT_TRUE(loop.take_problem());
    EXPECT_FALSE(loop.take_problem());
}

TEST(EventLoop, WithoutDescriptorsThereAreNoTimersAndNoCrash)
{
    EventLoop loop = *EventLoop::open();
    rlimit before = {};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none = {.rlim_cur = 0, .rlim_max = before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    const Source timer = loop.add_timer([] { FAIL(); });
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    ASSERT_NE(timer, nullptr);
    timer->arm(0ms);
    const auto problem = loop.take_problem();
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->number, EMFILE);
}

TEST(EventLoop, ChangesOfAFolderAreTold)
{
    const test::TemporaryFolder folder;
    EventLoop loop = *EventLoop::open();
    std::vector<std::string> names;
    const Source watch = loop.add_inotify(
        (folder / ".").c_str(), IN_CREATE | IN_DELETE, [&](const inotify_event& e) {
            names.emplace_back(e.name); // NOLINT(*-array-to-pointer-decay)
            if (names.size() == 3)
                loop.quit();
        });
    ASSERT_FALSE(loop.take_problem());
    test::write_text(folder / "one", "");
    test::write_text(folder / "two", "");
    std::filesystem::remove(folder / "one");
    ASSERT_TRUE(loop.run());
    EXPECT_EQ(names, (std::vector<std::string>{"one", "two", "one"}));
}

/// sd-event is C, so an exception in a handler ends the loop with an error, and not the process.
TEST(EventLoop, AHandlerThatThrowsEndsTheLoop)
{
    struct Row
    {
        std::function<void()> handler;
        int number;
    };
    const std::vector<Row> rows = {
        {[] { throw std::bad_alloc(); }, ENOMEM},
        {[] { throw std::system_error(EAGAIN, std::generic_category()); }, EAGAIN},
    };
    for (const Row& row : rows) {
        EventLoop loop = *EventLoop::open();
        const Source timer = loop.add_timer(row.handler);
        timer->arm(0ms);
        const auto ended = loop.run();
        ASSERT_FALSE(ended);
        EXPECT_EQ(ended.error().kind, ErrorKind::InputOutput);
        EXPECT_EQ(ended.error().number, row.number);
    }
}

} // namespace
} // namespace raymarch::daemon
