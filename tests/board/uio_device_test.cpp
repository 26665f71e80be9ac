// SPDX-License-Identifier: MIT
#include "board/uio_device.hpp"

#include "drivers/lock_file.hpp"
#include "drivers/mapped_window.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/file_size_limit.hpp"
#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/word_in.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace raymarch::board
{
namespace
{

constexpr std::size_t page = 4096;

/// A sysfs tree, and an ordinary file in place of the device.
class Uio : public testing::Test
{
  protected:
    void add(const std::string& device, const std::string& name, const std::string& size,
             const std::string& offset = "0x0\n")
    {
        test::add_uio(root, device, size, name + "\n");
        test::write_text(root + "/class/uio/" + device + "/maps/map0/offset", offset);
        test::write_text(folder / ("dev/" + device), std::string(2 * page, '\0'));
    }
    [[nodiscard]] std::string node(const std::string& device) const
    {
        return folder / ("dev/" + device);
    }
    [[nodiscard]] Result<std::unique_ptr<drivers::MappedWindow>>
    open(const std::string& device) const
    {
        const auto description = describe_uio(tree, node(device));
        if (!description)
            return fail(description.error());
        return drivers::MappedWindow::open_uio(*description, page);
    }
    void expect_unavailable(const std::string& device, const std::string& part) const
    {
        const auto window = open(device);
        ASSERT_FALSE(window);
        EXPECT_EQ(window.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(window.error().message.find(part), std::string::npos) << window.error().message;
    }

    test::TemporaryFolder folder;
    std::string root = folder / "sys";
    KernelTree tree{root};
};

TEST_F(Uio, IsFoundByItsName)
{
    add("uio0", "other", "0x1000\n");
    add("uio3", "raymarch", "0x00001000\n", "0x40\n");
    add("uio12", "raymarch2", "0x2000\n");
    const auto device = find_uio(tree, "raymarch");
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ(device->node, node("uio3"));
    EXPECT_EQ(device->name, "raymarch");
    EXPECT_EQ(device->address, 0x43C0'0000U);
    EXPECT_EQ(device->size, 0x1000U);
    EXPECT_EQ(device->offset, 0x40U);
    EXPECT_EQ(find_uio(tree, "raymarch2")->node, node("uio12"));
}

TEST_F(Uio, NodesOfTheSystemAreInItsDev)
{
    EXPECT_EQ(KernelTree().beside("dev/uio0"), "/dev/uio0");
}

TEST_F(Uio, IsDescribedThroughALinkToo)
{
    add("uio3", "raymarch", "0x1000\n");
    std::filesystem::create_symlink("uio3", folder / "dev/raymarch");
    const auto device = describe_uio(tree, folder / "dev/raymarch");
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ(device->node, folder / "dev/raymarch");
    EXPECT_EQ(device->size, 0x1000U);
}

TEST_F(Uio, NoDeviceOrTwoOfANameAreErrors)
{
    EXPECT_FALSE(find_uio(tree, "raymarch")); // there is no tree
    add("uio0", "raymarch", "0x1000\n");
    add("uio1", "raymarch", "0x1000\n");
    const auto two = find_uio(tree, "raymarch");
    ASSERT_FALSE(two);
    EXPECT_EQ(two.error().kind, ErrorKind::Config); // waiting would not help
    EXPECT_EQ(two.error().message, "2 UIO devices are named raymarch");
    const auto none = find_uio(tree, "nothing");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(none.error().message.find("nothing"), std::string::npos);
}

TEST_F(Uio, OpensWhatSysfsDescribes)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    (*window)->write({0x20}, 0x1234'5678);
    EXPECT_EQ(test::word_in(node("uio0"), 0x20), 0x1234'5678U);
    EXPECT_GE((*window)->interrupt_fd(), 0);
    EXPECT_EQ(test::word_in(node("uio0"), 0), 1U); // writing 1 to the device unmasks the interrupt
}

TEST_F(Uio, RegistersBeginAtTheOffset)
{
    add("uio0", "raymarch", "0x1000\n", "0x40\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    (*window)->write({0x20}, 0x1234'5678);
    EXPECT_EQ(test::word_in(node("uio0"), 0x60), 0x1234'5678U);
    (*window)->write({0xFFC}, 9);
    EXPECT_EQ(test::word_in(node("uio0"), 0x103C), 9U);
}

TEST_F(Uio, RefusalsNameTheDevice)
{
    expect_unavailable("uio9", "uio9");
    add("uio0", "raymarch", "0x800\n");
    expect_unavailable("uio0", "4096");
    add("uio1", "raymarch", "many\n");
    expect_unavailable("uio1", "map0/size");
    add("uio2", "raymarch", "");
    expect_unavailable("uio2", "uio2");
    add("uio3", "raymarch", "0x1000\n", "0x1000\n");
    expect_unavailable("uio3", "one page");
    add("uio4", "raymarch", "0x1000\n");
    std::filesystem::remove(node("uio4"));
    expect_unavailable("uio4", "open");
}

TEST_F(Uio, HasOneOwnerWhoIsNamed)
{
    add("uio0", "raymarch", "0x1000\n");
    std::filesystem::create_symlink("uio0",
                                    folder / "dev/raymarch"); // the udev rule makes such a link
    const test::OtherProcess other([&] { return open("uio0"); });
    ASSERT_TRUE(other.has_it());
    for (const char* const device : {"uio0", "raymarch"}) {
        const auto second = open(device);
        ASSERT_FALSE(second);
        EXPECT_TRUE(drivers::held_by_another(second.error()));
        EXPECT_NE(second.error().message.find("process " + std::to_string(other.pid())),
                  std::string::npos)
            << second.error().message;
    }
}

TEST_F(Uio, ADeviceWhoseNodeIsGoneIsLost)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window);
    EXPECT_FALSE((*window)->lost());
    std::filesystem::remove(node("uio0"));
    EXPECT_TRUE((*window)->lost());
}

/// The first bytes of the file stand for the interrupts: each read takes the next four, and each
/// write goes there. The registers follow.
TEST_F(Uio, InterruptsAreCountedAndArmedAgain)
{
    add("uio0", "raymarch", "0x1000\n", "0x40\n");
    const auto counts = [](std::uint32_t count) {
        return std::string(reinterpret_cast<const char*>(&count), sizeof count);
    };
    const std::string zero(4, '\0');
    test::write_text(node("uio0"),
                     zero + counts(7) + zero + counts(10) + std::string(2 * page, '\0'));
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    EXPECT_EQ(test::word_in(node("uio0"), 0), 1U) << "armed when opened";
    EXPECT_EQ((*window)->take_interrupt().value(), 7U);
    EXPECT_EQ(test::word_in(node("uio0"), 8), 0U);
    (*window)->arm_interrupt();
    EXPECT_EQ(test::word_in(node("uio0"), 8), 1U);
    EXPECT_EQ((*window)->take_interrupt().value(), 10U) << "two came unseen";
}

/// A device without an interrupt refuses the write that arms it. Here the file size limit does.
TEST_F(Uio, ADeviceWithoutALineHasNoInterrupt)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto device = describe_uio(tree, node("uio0"));
    ASSERT_TRUE(device);
    const test::FileSizeLimit none(0); // no write succeeds
    const auto window = drivers::MappedWindow::open_uio(*device, page);
    ASSERT_TRUE(window) << window.error().message;
    EXPECT_EQ((*window)->interrupt_fd(), -1);
    (*window)->arm_interrupt(); // it has no effect
    (*window)->write({0}, 5);
    EXPECT_EQ((*window)->read({0}), 5U);
}

} // namespace
} // namespace raymarch::board
