// SPDX-License-Identifier: MIT
#include "board/board_tree.hpp"

#include "tests/fakes/fake_kernel.hpp"

#include <gtest/gtest.h>

namespace raymarch::board
{
namespace
{

using namespace std::string_literals; // such strings may contain NUL

using test::write_text;

class BoardTree : public testing::Test
{
  protected:
    void enable_clocks(std::uint32_t bits, const std::string& bus = "axi") const
    {
        test::set_fclk_enable(folder / "sys", bits, bus);
    }

    test::TemporaryFolder folder;
    KernelTree tree{folder / "sys"};
};

TEST_F(BoardTree, AZynqIsKnownByWhatItIsCompatibleWith)
{
    EXPECT_FALSE(is_zynq(tree));
    write_text(tree.path("firmware/devicetree/base/compatible"),
               "raspberrypi,4-model-b\0brcm,bcm2711\0"s);
    EXPECT_FALSE(is_zynq(tree));
    test::make_zynq(folder / "sys");
    EXPECT_TRUE(is_zynq(tree));
}

TEST_F(BoardTree, TheClockIsKeptByTheDeviceTreeTheCommandLineOrItsDriver)
{
    EXPECT_EQ(keeps_logic_clock(tree), std::nullopt);
    EXPECT_TRUE(require_logic_clock(tree));
    enable_clocks(0xF);
    EXPECT_EQ(keeps_logic_clock(tree), true);
    enable_clocks(2); // another clock
    EXPECT_EQ(keeps_logic_clock(tree), false);
    enable_clocks(0);
    EXPECT_EQ(keeps_logic_clock(tree), false);

    const std::string device = "bus/platform/devices/fclk0";
    write_text(tree.path(device + "/of_node/compatible"), "xlnx,fclk\0"s);
    const auto set_clock = [&](std::size_t number) {
        write_text(tree.path(device + "/of_node/clocks"),
                   test::big_endian(1, 4) + test::big_endian(number, 4));
    };
    set_clock(15);
    EXPECT_EQ(keeps_logic_clock(tree), false) << "no driver has taken it";
    write_text(tree.path(device + "/driver/uevent"), "");
    EXPECT_EQ(keeps_logic_clock(tree), true);
    set_clock(16);
    EXPECT_EQ(keeps_logic_clock(tree), false) << "it keeps another one";
    std::filesystem::remove_all(tree.path(device));

    write_text(tree.path("firmware/devicetree/base/chosen/bootargs"), "ro clk_ignore_unused quiet");
    EXPECT_EQ(keeps_logic_clock(tree), true);
}

TEST_F(BoardTree, AnOlderTreeCallsTheBusAmba)
{
    enable_clocks(0, "amba");
    EXPECT_EQ(keeps_logic_clock(tree), false);
    enable_clocks(1, "amba");
    EXPECT_EQ(keeps_logic_clock(tree), true);
}

TEST_F(BoardTree, ARefusalSaysWhatKeepsTheClock)
{
    enable_clocks(0);
    const auto runs = require_logic_clock(tree);
    ASSERT_FALSE(runs);
    EXPECT_EQ(runs.error().kind, ErrorKind::Unavailable);
    for (const char* const remedy : {"fclk-enable", "clk_ignore_unused"})
        EXPECT_NE(runs.error().message.find(remedy), std::string::npos) << runs.error().message;
}

} // namespace
} // namespace raymarch::board
