// SPDX-License-Identifier: MIT
#include "conformance/table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace raymarch::conformance
{
namespace
{

std::string sent(const std::string& column)
{
    const auto rows = parse_table(column + "\tOK\t=\twhy");
    EXPECT_TRUE(rows) << column;
    return rows && rows->size() == 1 ? rows->front().send : std::string();
}

TEST(Table, EscapesAreBytes)
{
    EXPECT_EQ(sent("PING"), "PING\n");
    EXPECT_EQ(sent("PING\\r"), "PING\r\n");
    EXPECT_EQ(sent("PING\\r\\n"), "PING\r\n");
    EXPECT_EQ(sent("A\\nB"), "A\nB");       // has its LF: none is added
    EXPECT_EQ(sent("\\t\\\\n"), "\t\\n\n"); // a backslash and a letter are no LF
    EXPECT_EQ(sent("\\x20\\xfF\\x0A"), " \xFF\n");
    EXPECT_EQ(sent("\\(3*ab)c"), "abababc\n");
    EXPECT_EQ(sent("\\(0*x)y"), "y\n");
    EXPECT_EQ(sent("\\(2* )*3"), "  *3\n");
}

TEST(Table, ARowHasItsFourColumns)
{
    const auto rows = parse_table("# comment\n\n"
                                  "PING\tOK | ERR X col=#\t00000001 FFFFFFFF\twith words\n"
                                  "\\n\t-\t-\tnothing\n"
                                  "REGS\tOK ...\t=\tthe same\n");
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 3U);
    const Row& first = (*rows)[0];
    EXPECT_EQ(first.line, 3U);
    EXPECT_EQ(first.replies, (std::vector<std::string>{"OK", "ERR X col=#"}));
    EXPECT_EQ(first.words_check, WordsCheck::Exact);
    EXPECT_EQ(first.words, (std::vector<std::uint32_t>{1, 0xFFFF'FFFF}));
    EXPECT_EQ(first.why, "with words");
    EXPECT_TRUE((*rows)[1].replies.empty());
    EXPECT_EQ((*rows)[1].words_check, WordsCheck::Unchecked);
    EXPECT_EQ((*rows)[2].words_check, WordsCheck::Same);
    EXPECT_EQ((*rows)[2].line, 5U);
}

TEST(Table, AnErrorNamesItsLine)
{
    constexpr std::array<std::string_view, 13> wrong = {
        "PING",                       // one column
        "PING\tOK\t=",                // three
        "PING\tOK\t=\twhy\tmore",     // five
        "PING\t\t=\twhy",             // an empty column
        "\\q\tOK\t=\twhy",            // no such escape
        "end\\\tOK\t=\twhy",          // nothing after the backslash
        "\\x4\tOK\t=\twhy",           // one hex digit
        "\\xG0\tOK\t=\twhy",          // no hex digit
        "\\(x*y)\tOK\t=\twhy",        // no count
        "\\(3*y\tOK\t=\twhy",         // no end
        "\\(99999999*y)\tOK\t=\twhy", // more than anyone means
        "PING\tOK\t1234\twhy",        // a short word
        "PING\tOK\t0000000G\twhy",    // no hex
    };
    for (const std::string_view line : wrong) {
        const auto rows = parse_table("# one\n\n" + std::string(line) + "\n");
        ASSERT_FALSE(rows) << line;
        EXPECT_EQ(rows.error().kind, ErrorKind::BadData) << line;
        EXPECT_TRUE(rows.error().message.starts_with("line 3: ")) << rows.error().message;
    }
}

struct MatchRow
{
    std::string_view pattern;
    std::string_view reply;
    bool matches;
};

constexpr std::array match_rows = {
    MatchRow{"OK", "OK", true},
    MatchRow{"OK", "OK seq=1", false},
    MatchRow{"OK seq=1", "OK", false},
    MatchRow{"ERR RANGE col=4 key=FX", "ERR RANGE col=4 key=FX : FX is a number -1 to 1", true},
    MatchRow{"ERR RANGE col=4", "ERR RANGE col=4 key=FX : FX is", false},
    MatchRow{"ERR RANGE col=4 key=F", "ERR RANGE col=4 key=FX : FX is", false},
    MatchRow{"OK seq=# changed=2", "OK seq=17 changed=2", true},
    MatchRow{"OK seq=# changed=2", "OK seq= changed=2", false}, // at least one digit
    MatchRow{"OK seq=# changed=2", "OK seq=x changed=2", false},
    MatchRow{"OK seq=#", "OK seq=1a", false},
    MatchRow{"OK ...", "OK anything at all", true},
    MatchRow{"OK ...", "OK", false}, // the blank belongs to the prefix
    MatchRow{"OK...", "OK", true},
    MatchRow{"OK*04", "OK*04", true}, // O xor K
    MatchRow{"OK*??", "OK*04", true},
    MatchRow{"OK*??", "OK*05", false},
    MatchRow{"OK*??", "OK", false},
    MatchRow{"OK a=#*??", "OK a=5*4D", true},     // 04 xor 20 61 3D 35
    MatchRow{"ERR X*??", "ERR X : no*06", true},  // the sum covers the sentence
    MatchRow{"ERR X*??", "ERR X : no*3D", false}, // and not only what is compared
    MatchRow{"*??", "*00", true},                 // the sum of nothing
    MatchRow{"", "", true},
};

TEST(Match, ComparesUpToTheSentence)
{
    for (const MatchRow& row : match_rows)
        EXPECT_EQ(match(row.pattern, row.reply), row.matches) << row.pattern << " / " << row.reply;
}

} // namespace
} // namespace raymarch::conformance
