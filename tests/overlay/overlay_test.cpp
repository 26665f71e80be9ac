// SPDX-License-Identifier: MIT
/// @file
/// The overlays, applied to a Zynq's tree, against the tables: what Linux is told of the logic is
/// what the service, the tool and the register tables say.
#include "board/device_tree_overlay.hpp"
#include "board/interrupt_holders.hpp"
#include "board/logic_loader.hpp"
#include "daemon/actions.hpp"
#include "drivers/atomic_file.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace raymarch
{
namespace
{

/// What a command prints; its failure fails the test.
std::string output_of(const std::string& command)
{
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    EXPECT_NE(pipe, nullptr);
    std::string text;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr)
        text += part.data();
    EXPECT_EQ(::pclose(pipe), 0) << command;
    return text;
}

const std::string overlays = RAYMARCH_OVERLAYS;

/// The words that `fdtget` prints.
template <typename Word>
std::vector<Word> words_of(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<Word> words;
    stream >> std::hex;
    for (Word word; stream >> word;)
        words.push_back(word);
    return words;
}

/// The base tree with overlays applied to it.
class Tree
{
  public:
    explicit Tree(const std::string& names)
    {
        std::string command =
            std::string(RAYMARCH_FDTOVERLAY) + " -i " + overlays + "/base_for_test.dtb -o " + file_;
        for (const auto& name : words_of<std::string>(names))
            command.append(" ").append(overlays).append("/").append(name);
        static_cast<void>(output_of(command));
    }
    [[nodiscard]] std::vector<std::uint64_t> cells(const std::string& node,
                                                   const std::string& property) const
    {
        return words_of<std::uint64_t>(get("-t x", node + " " + property));
    }
    [[nodiscard]] std::vector<std::string> strings(const std::string& node,
                                                   const std::string& property) const
    {
        return words_of<std::string>(get("-t s", node + " " + property));
    }
    [[nodiscard]] std::vector<std::string> children(const std::string& node) const
    {
        return words_of<std::string>(get("-l", node));
    }

  private:
    [[nodiscard]] std::string get(const std::string& how, const std::string& what) const
    {
        return output_of(std::string(RAYMARCH_FDTGET) + " " + how + " " + file_ + " " + what);
    }
    test::TemporaryFolder folder_;
    std::string file_ = folder_ / "merged.dtb";
};

const std::string registers = "/axi/raymarch@43c00000";

/// The devices of the logic, which the overlay adds.
std::vector<std::string> logic_nodes(const Tree& tree)
{
    std::vector<std::string> nodes;
    for (const std::string& name : tree.children("/axi"))
        if (name.starts_with("raymarch@") || name.starts_with("gpio@"))
            nodes.push_back("/axi/" + name);
    return nodes;
}

TEST(Overlay, TheRegisterPageIsThatOfTheTables)
{
    const Tree tree("raymarch.dtbo");
    EXPECT_EQ(tree.cells(registers, "reg"),
              (std::vector<std::uint64_t>{0x43C0'0000, protocol::register_page_bytes}));
    for (const protocol::RegisterRow& row : protocol::extended_registers)
        EXPECT_LE(static_cast<std::size_t>(row.at) + 4, tree.cells(registers, "reg")[1]);
    for (const protocol::Accelerator* const accelerator : protocol::accelerators)
        EXPECT_LE(accelerator->first_word_offset + 4 * accelerator->word_count,
                  tree.cells(registers, "reg")[1])
            << accelerator->name;
}

TEST(Overlay, TheNamesAreThoseThatTheProgramsLookFor)
{
    const Tree tree("raymarch.dtbo");
    EXPECT_EQ(tree.strings(registers, "linux,uio-name"),
              std::vector<std::string>{board::overlay_uio_name});
    EXPECT_EQ(tree.strings(registers, "compatible"), std::vector<std::string>{"generic-uio"});
    EXPECT_EQ(tree.strings("/fpga-full", "firmware-name"),
              std::vector<std::string>{board::overlay_firmware});
}

TEST(Overlay, EveryInterruptIsALevelOfItsOwnFromTheLogic)
{
    const Tree tree("raymarch.dtbo");
    EXPECT_EQ(tree.cells(registers, "interrupts"), (std::vector<std::uint64_t>{0, 29, 4}));
    std::set<std::uint64_t> lines;
    for (const std::string& node :
         {registers, std::string("/axi/gpio@41200000"), std::string("/axi/gpio@41210000")}) {
        const auto interrupt = tree.cells(node, "interrupts");
        ASSERT_EQ(interrupt.size(), 3U) << node;
        EXPECT_EQ(interrupt[0], 0U) << "shared peripheral interrupt";
        EXPECT_TRUE(lines.insert(interrupt[1]).second && interrupt[1] >= 29)
            << node; // IRQ_F2P[0] is 29;
        EXPECT_EQ(interrupt[2], 4U) << "level, active high";
    }
}

/// What the loader takes from the file, against what dtc's own tool reads there.
TEST(Overlay, ItsInterruptsAreReadFromTheCompiledFile)
{
    const Tree tree("raymarch.dtbo");
    std::vector<board::SharedInterrupt> expected;
    for (const std::string& node : logic_nodes(tree))
        if (node != "/axi/gpio@41220000") // outputs only
            expected.push_back(
                static_cast<board::SharedInterrupt>(tree.cells(node, "interrupts")[1]));
    ASSERT_EQ(expected.size(), 3U);
    const auto blob =
        drivers::read_file(overlays + "/raymarch.dtbo", board::largest_overlay).value();
    const auto read = board::overlay_interrupts(drivers::as_bytes(blob), "raymarch.dtbo");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(std::ranges::is_permutation(*read, expected)) << testing::PrintToString(*read);
    for (std::size_t size = 0; size < blob.size(); ++size)
        EXPECT_FALSE(board::overlay_interrupts(drivers::as_bytes(blob).first(size), "cut"));
}

TEST(Overlay, AddressesAreThoseOfTheNodesAndDoNotOverlap)
{
    const Tree tree("raymarch.dtbo");
    constexpr std::uint64_t port_begin = 0x4000'0000; // general purpose port 0 of the Zynq
    constexpr std::uint64_t port_end = 0x8000'0000;
    std::uint64_t end = port_begin;
    const auto nodes = logic_nodes(tree);
    ASSERT_EQ(nodes.size(), 4U);
    std::set<std::pair<std::uint64_t, std::uint64_t>> ranges;
    for (const std::string& node : nodes) {
        const auto reg = tree.cells(node, "reg");
        ASSERT_EQ(reg.size(), 2U) << node;
        EXPECT_EQ(std::stoull(node.substr(node.find('@') + 1), nullptr, 16), reg[0]) << node;
        ranges.emplace(reg[0], reg[1]);
    }
    for (const auto& [address, size] : ranges) {
        EXPECT_GE(address, end) << std::hex << address;
        end = address + size;
    }
    EXPECT_LE(end, port_end);
}

TEST(Overlay, TheLinesAreThoseOfTheActions)
{
    const Tree tree("raymarch.dtbo");
    std::vector<std::string> names;
    for (const std::string node :
         {"/axi/gpio@41200000", "/axi/gpio@41210000", "/axi/gpio@41220000"}) {
        const auto lines = tree.strings(node, "gpio-line-names");
        EXPECT_EQ(tree.cells(node, "xlnx,gpio-width"), std::vector<std::uint64_t>{lines.size()})
            << node;
        names.insert(names.end(), lines.begin(), lines.end());
    }
    std::vector<std::string> lines;
    for (const daemon::Action& action : daemon::actions())
        lines.emplace_back(action.line);
    EXPECT_TRUE(std::ranges::is_permutation(names, lines)) << testing::PrintToString(names);
}

TEST(Overlay, TheClockIsKeptByTheOneForTheStart)
{
    const std::string clock = "/axi/slcr@f8000000/clkc@100";
    EXPECT_EQ(Tree("raymarch.dtbo").cells(clock, "fclk-enable"), std::vector<std::uint64_t>{0})
        << "in a running kernel this would claim what is not so";
    const Tree both("raymarch.dtbo raymarch_clock.dtbo");
    EXPECT_EQ(both.cells(clock, "fclk-enable"), std::vector<std::uint64_t>{1});
}

} // namespace
} // namespace raymarch
