// SPDX-License-Identifier: MIT
#include "pictures/numbered_name.hpp"

#include <gtest/gtest.h>

namespace raymarch::pictures
{
namespace
{

TEST(NumberedName, PatternsAndWhatTheyGive)
{
    struct Row
    {
        const char* path;
        std::size_t number;
        const char* expected;
    };
    for (const Row& row : {
             Row{"name_%04d.png", 7, "name_0007.png"},
             Row{"name_%04d.png", 12345, "name_12345.png"}, // longer, not cut
             Row{"%d.png", 0, "0.png"},
             Row{"%09d.png", 3, "000000003.png"},
             Row{"a/%02dz.tga", 3, "a/03z.tga"},
             Row{"folder/name.png", 2, "folder/name_0002.png"}, // without a pattern
             Row{"100%/name.png", 2, "100%/name_0002.png"},     // a folder's name is as it is
             Row{"a.b/name.png", 0, "a.b/name_0000.png"},
         }) {
        const auto name = numbered_name(row.path);
        ASSERT_TRUE(name) << row.path;
        EXPECT_EQ(name->at(row.number), row.expected);
    }
}

TEST(NumberedName, WhatIsNoPattern)
{
    for (const char* path : {"%.png", "%s.png", "%4d.png", "%00d.png", "%012d.png", "%d_%d.png",
                             "50%_%04d.png", "%04d%.png", "%04", "%0"}) {
        const auto name = numbered_name(path);
        ASSERT_FALSE(name) << path;
        EXPECT_EQ(name.error().kind, ErrorKind::Usage);
        EXPECT_NE(name.error().message.find("%09d"), std::string::npos);
    }
}

} // namespace
} // namespace raymarch::pictures
