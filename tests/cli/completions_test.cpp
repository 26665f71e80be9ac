// SPDX-License-Identifier: MIT
#include "cli/completions.hpp"

#include "cli/history_file.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::cli
{
namespace
{

struct Row
{
    std::string_view before;
    std::size_t typed;
    std::string_view text;
};
constexpr std::array rows = {
    Row{"PIN", 3, "PING "},   Row{"pin", 3, "PING "},        Row{"PING", 4, "PING "},
    Row{"RE", 2, "RE"}, // REGS and RESET
    Row{"SET OB", 2, "OBJ="}, Row{"SET OBJ=cu", 2, "cube "}, Row{"SET ZM=1,OB", 2, "OBJ="},
    Row{"GET OB", 2, "OBJ "}, Row{"ECHO of", 2, "off "},     Row{"RESET li", 2, "light "},
    Row{"nosuch", 6, ""},
};

TEST(Completions, AWholeWordGetsABlank)
{
    for (const Row& row : rows) {
        const Completion found = complete(protocol::default_accelerator, row.before);
        EXPECT_EQ(found.typed, row.typed) << row.before;
        EXPECT_EQ(found.text, row.text) << row.before;
        EXPECT_EQ(found.words.empty(), row.text.empty()) << row.before;
    }
}

TEST(HistoryFile, StandsWhereXdgWantsIt)
{
    EXPECT_EQ(history_file("/state", "/home/x"), "/state/raymarchctl_history");
    for (const char* const unset : {static_cast<const char*>(nullptr), "", "state", "./state", "~"})
        EXPECT_EQ(history_file(unset, "/home/x"), "/home/x/.local/state/raymarchctl_history");
    EXPECT_EQ(history_file("", nullptr), "");
    EXPECT_EQ(history_file(nullptr, ""), "");
    EXPECT_EQ(history_file(nullptr, "home"), "");
}

} // namespace
} // namespace raymarch::cli
