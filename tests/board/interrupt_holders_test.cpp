// SPDX-License-Identifier: MIT
#include "board/interrupt_holders.hpp"

#include "drivers/atomic_file.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/overlay_blob.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raymarch::board
{
namespace
{

using namespace std::string_literals; // such strings may contain NUL

using Interrupts = std::vector<SharedInterrupt>;

Interrupts interrupts_in(const test::OverlayInterrupts& devices)
{
    return overlay_interrupts(drivers::as_bytes(test::overlay_blob(devices)), "x.dtbo").value();
}

class Holders : public testing::Test
{
  protected:
    std::vector<std::string> names(const Interrupts& interrupts) const
    {
        std::vector<std::string> found;
        for (const InterruptHolder& holder : interrupt_holders(kernel, interrupts, "raymarch"))
            found.push_back(holder.device);
        return found;
    }
    test::TemporaryFolder folder;
    test::FakeKernel kernel{folder};
};

TEST(OverlayInterrupts, AreTheSharedOnesOfAllNodes)
{
    EXPECT_EQ(interrupts_in({{0, 29, 4}, {0, 30, 4}, {0, 31, 4, 0, 52, 1}}),
              (Interrupts{29, 30, 31, 52}));
    EXPECT_EQ(interrupts_in({{1, 29, 4}}), Interrupts{}) << "one of a processor's own";
    EXPECT_EQ(interrupts_in({{0, 29}, {}}), Interrupts{}) << "of another controller";
}

TEST_F(Holders, AreTheDriversDevicesWithTheSameInterrupt)
{
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    test::add_platform_device(folder / "sys", "40010000.other",
                              {0, 10, 4}); // the byte 10 is a line feed
    test::add_platform_device(folder / "sys", "40020000.percpu", {1, 29, 4});
    test::add_platform_device(folder / "sys", "40030000.second", {0, 40, 4, 0, 30, 1});
    test::add_platform_device(folder / "sys", "40040000.none", {});
    test::add_platform_device(folder / "sys", "e0001000.serial", {0, 29, 4}, "xuartps");
    EXPECT_EQ(names({29, 30, 31}),
              (std::vector<std::string>{"40000000.fabric", "40030000.second"}));
    EXPECT_EQ(interrupt_holders(kernel, Interrupts{30}, "raymarch").front().interrupt, 30U);
    EXPECT_EQ(names({10}), std::vector<std::string>{"40010000.other"});
    EXPECT_EQ(names({}), std::vector<std::string>{});
}

TEST_F(Holders, TheOverlaysOwnDeviceIsNotAHolder)
{
    test::add_platform_device(folder / "sys", "43c00000.raymarch", {0, 29, 4});
    const std::string name = kernel.path("devices/platform/43c00000.raymarch/of_node/"
                                         "linux,uio-name");
    test::write_text(name, "raymarch\0"s);
    EXPECT_EQ(names({29}), std::vector<std::string>{});
    test::write_text(name, "raymarched\0"s);
    EXPECT_EQ(names({29}), std::vector<std::string>{"43c00000.raymarch"});
}

TEST_F(Holders, WithoutTheDriverThereIsNoHolder)
{
    EXPECT_EQ(names({29}), std::vector<std::string>{});
}

TEST_F(Holders, GiveWayAndComeBack)
{
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    const auto holder = interrupt_holders(kernel, Interrupts{29}, "raymarch").front();
    ASSERT_TRUE(unbind(kernel, holder));
    EXPECT_EQ(names({29}), std::vector<std::string>{});
    ASSERT_TRUE(bind(kernel, holder));
    EXPECT_EQ(names({29}), std::vector<std::string>{"40000000.fabric"});
    EXPECT_EQ(kernel.calls, (std::vector<std::string>{"write unbind 40000000.fabric",
                                                      "write bind 40000000.fabric"}));
}

} // namespace
} // namespace raymarch::board
