// SPDX-License-Identifier: MIT
#include "base/log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

namespace raymarch::log
{
namespace
{

struct LevelRow
{
    const char* name;
    Level level;
    int priority; ///< the number in syslog(3)
};
constexpr std::array levels = {
    LevelRow{"error", Level::Error, 3},   LevelRow{"warning", Level::Warning, 4},
    LevelRow{"notice", Level::Notice, 5}, LevelRow{"info", Level::Info, 6},
    LevelRow{"debug", Level::Debug, 7},
};

class Log : public testing::Test
{
  protected:
    ~Log() override { set_level(Level::Notice); }
};

TEST_F(Log, LevelsHaveNamesAndPriorities)
{
    for (const LevelRow& row : levels) {
        EXPECT_EQ(level_named(row.name), row.level) << row.name;
        EXPECT_EQ(static_cast<int>(row.level), row.priority) << row.name;
    }
    for (const char* name : {"", "Error", "warn", "none", "debug "})
        EXPECT_FALSE(level_named(name)) << name;
}

TEST_F(Log, NoticeIsTheDefault)
{
    EXPECT_TRUE(enabled(Level::Notice));
    EXPECT_FALSE(enabled(Level::Info));
}

TEST_F(Log, ALevelLetsItselfAndTheMoreImportantOnesThrough)
{
    for (const LevelRow& threshold : levels) {
        set_level(threshold.level);
        for (const LevelRow& row : levels)
            EXPECT_EQ(enabled(row.level), row.priority <= threshold.priority)
                << row.name << " at " << threshold.name;
    }
}

TEST_F(Log, APersonReadsTheNameOfTheProgram)
{
    if (std::getenv("JOURNAL_STREAM") != nullptr) // NOLINT(concurrency-mt-unsafe)
        GTEST_SKIP() << "a journal reads standard error";
    testing::internal::CaptureStderr();
    warning("{} of {}", 1, "two");
    info("below the level");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "raymarchd: 1 of two\n");
}

[[noreturn]] void log_to_a_journal()
{
    ::setenv("JOURNAL_STREAM", "8:1", 1); // NOLINT(concurrency-mt-unsafe)
    warning("lost");
    std::exit(0); // NOLINT(concurrency-mt-unsafe)
}

TEST_F(Log, AJournalReadsThePriority)
{
    // A process checks JOURNAL_STREAM only once, so this test runs in a child process.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(log_to_a_journal(), testing::ExitedWithCode(0), "<4>lost");
}

} // namespace
} // namespace raymarch::log
