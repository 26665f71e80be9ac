// SPDX-License-Identifier: MIT
#include "daemon/state_store.hpp"

#include "base/unique_fd.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

namespace raymarch::daemon
{
namespace
{

constexpr const protocol::Accelerator& accelerator = protocol::marcher::description;

PersistedStates with_zoom(std::int64_t code)
{
    protocol::State state = protocol::initial_state(accelerator);
    state.codes[protocol::marcher::ZM] = code;
    PersistedStates states;
    states.of(accelerator).last = state;
    return states;
}

TEST(StateStore, WithoutAFileThereIsNothing)
{
    const test::TemporaryFolder folder;
    const StateStore store(folder / "state");
    const auto loaded = store.load();
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(loaded.error().message.find(folder / "state"), std::string::npos);
}

TEST(StateStore, WritesNow)
{
    const test::TemporaryFolder folder;
    StateStore store(folder / "state");
    ASSERT_TRUE(store.write_now(with_zoom(1)));
    EXPECT_EQ(store.load().value(), with_zoom(1));
    ASSERT_TRUE(store.write_now(with_zoom(2)));
    EXPECT_EQ(StateStore(folder / "state").load().value(), with_zoom(2));
    EXPECT_FALSE(std::filesystem::exists(folder / "state.new"));
}

TEST(StateStore, WritesLater)
{
    const test::TemporaryFolder folder;
    const UniqueFd moves(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
    ASSERT_GE(::inotify_add_watch(moves.get(), (folder / "").c_str(), IN_MOVED_TO), 0);
    StateStore store(folder / "state");
    store.write_later(with_zoom(1));
    ASSERT_TRUE(test::readable(moves.get()));
    EXPECT_EQ(store.load().value(), with_zoom(1));
}

TEST(StateStore, AWrongFileIsNamed)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "state", "no state\n");
    const auto loaded = StateStore(folder / "state").load();
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(loaded.error().message.starts_with(folder / "state")) << loaded.error().message;
}

TEST(StateStore, AFileThatIsNoStateFileAtAllIsNotReadWhole)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "state", std::string(70'000, 'x'));
    const auto loaded = StateStore(folder / "state").load();
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().kind, ErrorKind::BadData);
}

TEST(StateStore, AFolderThatIsNotThereIsAnErrorEachTimeAndAWarningOnce)
{
    const test::TemporaryFolder folder;
    StateStore store(folder / "missing/state");
    testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) {
        const auto written = store.write_now(with_zoom(1));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().kind, ErrorKind::InputOutput);
        EXPECT_NE(written.error().message.find("missing/state"), std::string::npos);
    }
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::ranges::count(log, '\n'), 1) << log;
}

TEST(StateStore, WhatCouldNotBeWrittenIsStillOwed)
{
    const test::TemporaryFolder folder;
    testing::internal::CaptureStderr();
    {
        StateStore store(folder / "missing/state");
        EXPECT_FALSE(store.behind());
        store.write_later(with_zoom(1));
        EXPECT_FALSE(store.write_now(with_zoom(2))); // the older one is dropped, or has failed
        std::filesystem::create_directory(folder / "missing");
        EXPECT_TRUE(store.write_now(with_zoom(3)));
        EXPECT_FALSE(store.behind());
        EXPECT_EQ(store.load().value(), with_zoom(3));
    }
    static_cast<void>(testing::internal::GetCapturedStderr());
}

TEST(StateStore, AnOlderStateNeverFollowsANewerOne)
{
    const test::TemporaryFolder folder;
    for (std::int64_t code = 0; code < 50; ++code) {
        {
            StateStore store(folder / "state");
            store.write_later(with_zoom(code));
            ASSERT_TRUE(store.write_now(with_zoom(code + 1000)));
        } // whatever the worker was doing is over
        ASSERT_EQ(StateStore(folder / "state").load().value(), with_zoom(code + 1000));
    }
}

} // namespace
} // namespace raymarch::daemon
