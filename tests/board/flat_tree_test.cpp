// SPDX-License-Identifier: MIT
#include "board/flat_tree.hpp"

#include "drivers/atomic_file.hpp"
#include "tests/fakes/overlay_blob.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace raymarch::board
{
namespace
{

using Cells = std::vector<std::uint32_t>;

std::vector<Cells> interrupts_of(const std::string& blob)
{
    const auto values = values_of(drivers::as_bytes(blob), "interrupts", "x.dtbo");
    EXPECT_TRUE(values) << values.error().message;
    std::vector<Cells> found;
    for (const TreeBytes value : values.value_or(std::vector<TreeBytes>{}))
        found.push_back(cells_of(value));
    return found;
}

void expect_bad(const std::string& blob, const std::string& part)
{
    const auto values = values_of(drivers::as_bytes(blob), "interrupts", "x.dtbo");
    ASSERT_FALSE(values) << part;
    EXPECT_EQ(values.error().kind, ErrorKind::BadData);
    EXPECT_NE(values.error().message.find(part), std::string::npos) << values.error().message;
}

/// Returns the blob with another cell at `at`.
std::string with_cell(std::string blob, std::size_t at, std::uint32_t cell)
{
    return blob.replace(at, 4, test::big_endian(cell, 4));
}

/// Returns the offset of a part, as the header gives it.
std::size_t begin_of(const std::string& blob, std::size_t header_cell)
{
    return cells_of(drivers::as_bytes(blob))[header_cell];
}

TEST(FlatTree, CellsAreHighByteFirstAndARestIsLeftOut)
{
    EXPECT_EQ(cells_of(drivers::as_bytes(std::string("\x12\x34\x56\x78\x00\x00\x00\x0A\xFF", 9))),
              (Cells{0x1234'5678, 10}));
    EXPECT_EQ(cells_of({}), Cells{});
}

TEST(FlatTree, EveryNodesValueIsFound)
{
    EXPECT_EQ(interrupts_of(test::overlay_blob({{0, 29, 4}, {}, {0, 30, 4, 1, 7, 1}})),
              (std::vector<Cells>{{0, 29, 4}, {}, {0, 30, 4, 1, 7, 1}}));
    EXPECT_EQ(interrupts_of(test::overlay_blob({})), std::vector<Cells>{});
}

TEST(FlatTree, OnlyTheWholeNameCounts)
{
    const std::string blob = test::overlay_blob();
    for (const std::string_view name : {"interrupt", "interrupts-extended", "nterrupt", "eg"})
        EXPECT_TRUE(values_of(drivers::as_bytes(blob), name, "x.dtbo").value().empty()) << name;
    EXPECT_EQ(values_of(drivers::as_bytes(blob), "reg", "x.dtbo").value().size(), 1U);
}

TEST(FlatTree, AHeaderThatIsNoneOrLiesIsRefused)
{
    const std::string blob = test::overlay_blob();
    expect_bad("", "it is not a compiled device tree");
    expect_bad(blob.substr(0, 39), "it is not a compiled device tree");
    expect_bad(with_cell(blob, 0, 0xD00D'FEEE), "it is not a compiled device tree");
    expect_bad(with_cell(blob, 4, 41), "its header says 41 bytes");
    for (const std::size_t part : {8U, 12U}) {
        expect_bad(with_cell(blob, part, static_cast<std::uint32_t>(blob.size()) + 1), "after");
        expect_bad(with_cell(blob, part, 0xFFFF'FFFF), "after its end");
    }
}

/// The blob is cut at every byte, and the header gives the new length.
TEST(FlatTree, ATreeThatIsCutIsRefused)
{
    const std::string blob = test::overlay_blob();
    const std::size_t strings = begin_of(blob, 3);
    for (std::size_t size = 40; size < strings; ++size) {
        std::string cut = with_cell(blob.substr(0, size), 4, static_cast<std::uint32_t>(size));
        cut = with_cell(cut, 12, 40);
        expect_bad(cut, size < begin_of(blob, 2) ? "x.dtbo: " : "cut or damaged before byte ");
    }
}

TEST(FlatTree, AnUnknownTokenOrALengthBehindTheEndIsRefused)
{
    const std::string blob = test::overlay_blob();
    const std::size_t first = begin_of(blob, 2);
    for (const std::uint32_t token : {0U, 5U, 0x100U, 0xFFFF'FFFFU})
        expect_bad(with_cell(blob, first, token), "damaged before byte");
    const std::size_t length =
        first + 8 + 12 + 4; // the length of the first property, in the second node
    ASSERT_EQ(cells_of(drivers::as_bytes(blob).subspan(length)).front(), 4U);
    for (const std::uint32_t wrong : {0x1000U, 0x7FFF'FFFFU, 0xFFFF'FFFCU, 0xFFFF'FFFFU})
        expect_bad(with_cell(blob, length, wrong), "damaged before byte");
}

/// All cells are there, but a wrong token makes the tree invalid.
TEST(FlatTree, NodesThatDoNotCloseAreRefused)
{
    const std::string blob = test::overlay_blob();
    const std::size_t root = begin_of(blob, 2);
    const std::size_t device = root + 8;
    const std::size_t property = device + 12;
    const std::size_t ends = begin_of(blob, 3) - 12;     // the ends of two nodes and of the tree
    expect_bad(with_cell(blob, ends, 4), "damaged");     // one end of a node is missing
    expect_bad(with_cell(blob, ends + 4, 9), "damaged"); // the tree ends too early
    expect_bad(with_cell(blob, ends + 8, 2), "damaged"); // there is one end of a node too many
    expect_bad(with_cell(blob, root, 9), "damaged");     // the tree is empty
    expect_bad(with_cell(blob, root, 2), "damaged");     // a node ends before any begins
    expect_bad(with_cell(with_cell(blob, root, 4), root + 4, 4), "damaged"); // one end too many
    expect_bad(with_cell(blob, property + 8, 0x7FFF'FFFF), "damaged"); // the name is after the end
    std::string stray = blob;
    stray.insert(ends + 8, test::big_endian(3, 4) +
                               std::string(8, '\0')); // the property is outside all nodes
    stray = with_cell(stray, 4, static_cast<std::uint32_t>(stray.size()));
    stray = with_cell(stray, 12, static_cast<std::uint32_t>(begin_of(blob, 3)) + 12);
    expect_bad(stray, "damaged");
    std::string two = blob;
    two.insert(ends + 8, test::big_endian(1, 4) + std::string(4, '\0') + test::big_endian(2, 4));
    two = with_cell(two, 4, static_cast<std::uint32_t>(two.size()));
    two = with_cell(two, 12, static_cast<std::uint32_t>(begin_of(blob, 3)) + 12);
    expect_bad(two, "damaged"); // a second root
}

/// Each byte is wrong once. The memory block has exactly the blob's size, so that a sanitizer finds
/// a read past the end.
TEST(FlatTree, WhatIsGarbledIsReadWithinItsBytes)
{
    const std::string blob = test::overlay_blob();
    const auto copy = std::make_unique<std::uint8_t[]>(blob.size());
    const TreeBytes bytes(copy.get(), blob.size());
    for (std::size_t at = 0; at < blob.size(); ++at)
        for (const char wrong : {'\x00', '\x01', '\x03', '\x09', '\x7F', '\x80', '\xFF'}) {
            std::ranges::copy(blob, copy.get());
            copy[at] = static_cast<std::uint8_t>(wrong);
            const auto values = values_of(bytes, "interrupts", "x.dtbo");
            for (const TreeBytes value : values.value_or(std::vector<TreeBytes>{})) {
                EXPECT_GE(value.data(), bytes.data()) << at;
                EXPECT_LE(value.data() + value.size(), bytes.data() + bytes.size()) << at;
            }
        }
}

} // namespace
} // namespace raymarch::board
