// SPDX-License-Identifier: MIT
#include "daemon/state_store.hpp"

#include "base/unique_fd.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <string>

namespace raymarch::daemon
{
namespace
{

constexpr const protocol::Accelerator& described = protocol::marcher::description;
constexpr const protocol::Accelerator& other = protocol::fractal::description;

protocol::State with_zoom(std::int64_t code)
{
    protocol::State state = protocol::initial_state(described);
    state.codes[protocol::marcher::ZM] = code;
    return state;
}

/// Returns whether `store` reports that it has saved the state.
bool save(StateStore& store, const protocol::State& state)
{
    return store.save(described, state).get() == state;
}

/// Returns the states that a new service reads.
std::optional<protocol::State> last_in(const std::string& path)
{
    StateStore store(path, {});
    store.read();
    return store.last(described);
}

std::string file_of(const protocol::State& state)
{
    PersistedStates states;
    states.of(described) = {.last = state, .saved = state};
    return format_state_file(states);
}

class Store : public testing::Test
{
  protected:
    const test::TemporaryFolder folder;
    const std::string path = folder / "state";
};

TEST_F(Store, WithoutAFileThereIsNothing)
{
    StateStore store(path, {});
    testing::internal::CaptureStderr();
    store.read();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); // the level of the message is `info`
    EXPECT_FALSE(store.last(described));
    EXPECT_FALSE(store.load(described).get());
}

TEST_F(Store, WithoutAPathNothingIsKept)
{
    StateStore store("", {});
    store.read();
    store.changed(described, with_zoom(1));
    EXPECT_FALSE(save(store, with_zoom(1)));
    EXPECT_FALSE(store.load(described).get());
}

TEST_F(Store, WhatIsSavedIsInTheFile)
{
    StateStore store(path, {});
    ASSERT_TRUE(save(store, with_zoom(1)));
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(1)));
    ASSERT_TRUE(save(store, with_zoom(2)));
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(2)));
    EXPECT_EQ(store.load(described).get(), with_zoom(2));
    EXPECT_EQ(last_in(path), with_zoom(2));
    EXPECT_EQ(test::names_in(folder / ""),
              std::vector<std::string>{"state"}); // no other file is left
}

/// After OK the file has the state, whatever it had before.
TEST_F(Store, ASaveLooksAtTheFile)
{
    StateStore store(path, {});
    ASSERT_TRUE(save(store, with_zoom(9)));
    for (const std::string& content : {file_of(with_zoom(1)), std::string()}) {
        test::write_text(path, content);
        ASSERT_TRUE(save(store, with_zoom(9)));
        EXPECT_EQ(test::read_text(path), file_of(with_zoom(9)));
    }
    std::filesystem::remove(path);
    ASSERT_TRUE(save(store, with_zoom(9)));
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(9)));
}

TEST_F(Store, WhatTheFileHoldsIsNotWrittenAgain)
{
    StateStore store(path, {});
    ASSERT_TRUE(save(store, with_zoom(1)));
    struct stat before = {};
    ASSERT_EQ(::stat(path.c_str(), &before), 0);
    ASSERT_TRUE(save(store, with_zoom(1)));
    struct stat after = {};
    ASSERT_EQ(::stat(path.c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
}

TEST_F(Store, AChangeIsWrittenLater)
{
    const UniqueFd moves(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
    ASSERT_GE(::inotify_add_watch(moves.get(), (folder / "").c_str(), IN_MOVED_TO), 0);
    StateStore store(path, {});
    store.changed(described, with_zoom(1));
    store.changed(described, with_zoom(2));
    EXPECT_EQ(store.last(described), with_zoom(2));
    ASSERT_TRUE(test::readable(moves.get()));
    EXPECT_EQ(last_in(path), with_zoom(2));
}

TEST_F(Store, AChangeIsWrittenAtTheEnd)
{
    {
        StateStore store(path, {});
        store.changed(described, with_zoom(1));
    }
    EXPECT_EQ(last_in(path), with_zoom(1));
}

TEST_F(Store, TheLastAndTheSavedStateAreTwo)
{
    {
        StateStore store(path, {});
        ASSERT_TRUE(save(store, with_zoom(1)));
        store.changed(described, with_zoom(2));
        store.changed(other, protocol::initial_state(other));
        EXPECT_EQ(store.load(described).get(), with_zoom(1));
    }
    StateStore store(path, {});
    store.read();
    EXPECT_EQ(store.last(described), with_zoom(2));
    EXPECT_EQ(store.load(described).get(), with_zoom(1));
    EXPECT_EQ(store.load(other).get(),
              protocol::initial_state(other)); // no state was saved, so it is the last one
}

TEST_F(Store, TellsThatAnAnswerIsThere)
{
    std::atomic<int> told = 0;
    {
        StateStore store(path, [&] { ++told; });
        ASSERT_TRUE(save(store, with_zoom(1)));
        static_cast<void>(store.load(described).get());
    }
    EXPECT_EQ(told, 2);
}

TEST_F(Store, NobodyNeedsToTakeAnAnswer)
{
    {
        StateStore store(path, {});
        static_cast<void>(store.save(described, with_zoom(3)));
    }
    EXPECT_EQ(last_in(path), with_zoom(3));
}

TEST_F(Store, ManySavesAtOnceAreAllAnswered)
{
    StateStore store(path, {});
    std::vector<StoredState> answers;
    answers.reserve(50);
    for (int i = 0; i < 50; ++i)
        answers.push_back(store.save(described, with_zoom(i)));
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(answers[static_cast<std::size_t>(i)].get(), with_zoom(i));
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(49)));
}

/// The user restores an older copy of the file while the service runs.
TEST_F(Store, AFileThatSomebodyPutsThereIsLoaded)
{
    {
        StateStore store(path, {});
        ASSERT_TRUE(save(store, with_zoom(1)));
        test::write_text(path, file_of(with_zoom(7)));
        EXPECT_EQ(store.load(described).get(), with_zoom(7));
        store.changed(described, with_zoom(8));
    }
    StateStore store(path, {});
    store.read();
    EXPECT_EQ(store.last(described), with_zoom(8));
    EXPECT_EQ(store.load(described).get(), with_zoom(7));
}

struct BadFile
{
    const char* name;
    std::string content;
};
void PrintTo(const BadFile& file, std::ostream* stream)
{
    *stream << file.name;
}
class BadFiles : public Store, public testing::WithParamInterface<BadFile>
{};
INSTANTIATE_TEST_SUITE_P(All, BadFiles,
                         testing::Values(BadFile{"Text", "no state\n"}, BadFile{"Empty", ""},
                                         BadFile{"TooLong", std::string(70'000, 'x')},
                                         BadFile{"Newer", "raymarch-state 2\ncrc32 00000000\n"},
                                         BadFile{"Cut", file_of(with_zoom(5)).substr(0, 40)},
                                         BadFile{"Flipped",
                                                 [] {
                                                     std::string text = file_of(with_zoom(5));
                                                     text[20] = static_cast<char>(text[20] ^ 1);
                                                     return text;
                                                 }()}),
                         [](const auto& row) { return row.param.name; });

/// The file is reported at once, and renamed before the next write.
TEST_P(BadFiles, AreKept)
{
    test::write_text(path, GetParam().content);
    testing::internal::CaptureStderr();
    {
        StateStore store(path, {});
        store.read();
        EXPECT_EQ(test::read_text(path), GetParam().content);
        EXPECT_FALSE(store.last(described));
        EXPECT_FALSE(store.load(described).get());
        EXPECT_EQ(test::read_text(path), GetParam().content);
        ASSERT_TRUE(save(store, with_zoom(1)));
        ASSERT_TRUE(save(store, with_zoom(2)));
    }
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(2)));
    EXPECT_EQ(test::read_text(path + ".bad"), GetParam().content);
    EXPECT_NE(log.find("starting from the defaults: " + path), std::string::npos) << log;
    EXPECT_NE(log.find("renamed to " + path + ".bad"), std::string::npos) << log;
    EXPECT_EQ(std::ranges::count(log, '\n'), 2) << log;
}

TEST_P(BadFiles, AreKeptWhenTheyComeLater)
{
    StateStore store(path, {});
    store.read();
    ASSERT_TRUE(save(store, with_zoom(1)));
    test::write_text(path, GetParam().content);
    test::write_text(path + ".bad", "an earlier one");
    testing::internal::CaptureStderr();
    ASSERT_TRUE(save(store, with_zoom(2)));
    static_cast<void>(testing::internal::GetCapturedStderr());
    EXPECT_EQ(test::read_text(path), file_of(with_zoom(2)));
    EXPECT_EQ(test::read_text(path + ".bad"), "an earlier one");
    EXPECT_EQ(test::read_text(path + ".bad-2"), GetParam().content);
}

/// A file that could not be read at the start is not overwritten later.
TEST_F(Store, AFileThatMayNotBeReadIsKept)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may read everything";
    test::write_text(path, file_of(with_zoom(5)));
    ASSERT_EQ(::chmod(path.c_str(), 0), 0);
    testing::internal::CaptureStderr();
    StateStore store(path, {});
    store.read();
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_NE(log.find(path), std::string::npos) << log;
    ASSERT_EQ(::chmod(path.c_str(), 0600), 0); // it can be read now
    testing::internal::CaptureStderr();
    ASSERT_TRUE(save(store, with_zoom(1)));
    static_cast<void>(testing::internal::GetCapturedStderr());
    EXPECT_EQ(test::read_text(path + ".bad"), file_of(with_zoom(5)));
}

TEST_F(Store, WhatIsNoFileIsLeftAlone)
{
    std::filesystem::create_directory(path);
    testing::internal::CaptureStderr();
    {
        StateStore store(path, {});
        store.read();
        EXPECT_FALSE(save(store, with_zoom(1)));
        EXPECT_FALSE(save(store, with_zoom(2)));
    }
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(std::filesystem::is_directory(path));
    EXPECT_EQ(std::ranges::count(log, '\n'), 2) << log; // at the start and at the write
}

TEST_F(Store, AFifoIsNotWaitedFor)
{
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    testing::internal::CaptureStderr();
    {
        StateStore store(path, {});
        store.read();
        EXPECT_FALSE(save(store, with_zoom(1)));
        EXPECT_FALSE(store.load(described).get());
    }
    static_cast<void>(testing::internal::GetCapturedStderr());
    EXPECT_TRUE(std::filesystem::is_fifo(path));
}

TEST_F(Store, AFolderThatIsNotThereIsAWarningOnceAndTheStateIsWrittenWhenItIs)
{
    const std::string missing = folder / "missing";
    testing::internal::CaptureStderr();
    {
        StateStore store(missing + "/state", {});
        store.read();
        for (int i = 0; i < 3; ++i)
            EXPECT_FALSE(save(store, with_zoom(i)));
        store.changed(described, with_zoom(4));
        std::filesystem::create_directory(missing);
    }
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::ranges::count(log, '\n'), 1) << log;
    EXPECT_NE(log.find(missing + "/state"), std::string::npos) << log;
    EXPECT_EQ(last_in(missing + "/state"), with_zoom(4));
}

TEST_F(Store, ASaveThatFailedIsNotWhatIsLoaded)
{
    StateStore store(path, {});
    ASSERT_TRUE(save(store, with_zoom(1)));
    std::filesystem::rename(path, folder / "away");
    std::filesystem::create_directory(path);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(save(store, with_zoom(2)));
    std::filesystem::remove(path);
    std::filesystem::rename(folder / "away", path);
    static_cast<void>(testing::internal::GetCapturedStderr());
    EXPECT_EQ(store.load(described).get(), with_zoom(1));
}

/// States of a newer version stay in the file.
TEST_F(Store, StatesOfUnknownAcceleratorsStay)
{
    PersistedStates states;
    states.of(described).last = with_zoom(1);
    states.others = "last unheard_of CX=0\nsaved unheard_of CX=1\n";
    test::write_text(path, format_state_file(states));
    StateStore store(path, {});
    store.read();
    ASSERT_TRUE(save(store, with_zoom(2)));
    EXPECT_NE(test::read_text(path).find(states.others), std::string::npos);
}

} // namespace
} // namespace raymarch::daemon
