// SPDX-License-Identifier: MIT
/// @file
/// The register block behind a UIO device, with a folder in place of sysfs and a block in memory
/// that counts its accesses: logic that is not there is never touched, and interrupts bring what
/// waits for a frame.
#include "daemon/hardware.hpp"

#include "board/logic_loader.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/recording_bus.hpp"

#include <gtest/gtest.h>

#include <sys/eventfd.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using namespace std::chrono_literals;

/// The block outlives the service's hold on it, as hardware does.
class Borrowed final : public drivers::RegisterBus
{
  public:
    explicit Borrowed(drivers::RegisterBus& bus) : bus_(bus) {}
    [[nodiscard]] std::uint32_t read(drivers::RegOffset at) noexcept override
    {
        return bus_.read(at);
    }
    void write(drivers::RegOffset at, std::uint32_t word) noexcept override
    {
        bus_.write(at, word);
    }
    [[nodiscard]] int interrupt_fd() const noexcept override { return bus_.interrupt_fd(); }
    void arm_interrupt() noexcept override { bus_.arm_interrupt(); }
    [[nodiscard]] Result<std::uint32_t> take_interrupt() override { return bus_.take_interrupt(); }
    [[nodiscard]] bool lost() const noexcept override { return bus_.lost(); }

  private:
    drivers::RegisterBus& bus_;
};

class UioHardware : public testing::Test
{
  protected:
    UioHardware()
    {
        config.registers = UioName{board::overlay_uio_name};
        config.sysfs_root = root;
        bus.memory[0x20] = protocol::id_value;
    }
    /// Plays a script in the loop, which runs once in its life: each step is asked every few
    /// milliseconds until it says that it is done.
    void play(const std::vector<std::function<bool()>>& steps)
    {
        int patience = 4000;
        std::size_t step = 0;
        Source look;
        look = loop->add_timer([&] {
            while (step < steps.size() && steps[step]())
                ++step;
            if (step == steps.size() || --patience == 0)
                loop->quit();
            else
                look->arm(5ms);
        });
        look->arm(0ms);
        ASSERT_TRUE(loop->run());
        ASSERT_EQ(step, steps.size()) << "this step did not come to its end";
    }
    /// A step that is done at once.
    template <typename Action>
    static std::function<bool()> act(Action action)
    {
        return [action] {
            action();
            return true;
        };
    }
    std::function<bool()> until_ready(int times)
    {
        return [this, times] { return ready == times; };
    }
    [[nodiscard]] std::string status()
    {
        protocol::ReplyWriter reply;
        protocol::StatusValues status;
        hardware.write_status(status);
        status.write(reply);
        return std::string(reply.text());
    }
    /// The value of one field; empty when there is none.
    [[nodiscard]] std::string status(const std::string& field)
    {
        const std::string text = status() + " ";
        const std::size_t at = text.find(" " + field + "=");
        if (at == std::string::npos)
            return "";
        const std::size_t begin = at + field.size() + 2;
        return text.substr(begin, text.find_first_of(" \r", begin) - begin);
    }
    BusResult open_uio(const drivers::UioDevice& device)
    {
        opened.push_back(device.node);
        if (device.size < protocol::register_page_bytes)
            return open_uio_window(device); // which refuses it before it opens anything
        return std::make_unique<Borrowed>(bus);
    }

    test::TemporaryFolder folder;
    std::string root = folder / "sys";
    Config config = default_config();
    Result<EventLoop> loop = EventLoop::open();
    test::RecordingBus bus;
    std::vector<std::string> opened;
    int ready = 0;
    Hardware hardware{config, *loop, [this] { ++ready; },
                      [this](const drivers::UioDevice& device) { return open_uio(device); }};
};

TEST_F(UioHardware, LogicThatIsNotConfiguredIsNeverTouched)
{
    test::add_uio(root);
    test::add_fpga_manager(root, "unknown");
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(hardware.apply(protocol::Words(8)), Applied::Absent);
    // Each retry asks the kernel anew; the wait between them begins at a quarter of a second.
    const auto begin = std::chrono::steady_clock::now();
    const auto in_state_until = [&](const std::string& state, std::chrono::milliseconds end) {
        return [&, state, end] {
            test::add_fpga_manager(root, state);
            EXPECT_EQ(status("hardware"), "absent") << state;
            return std::chrono::steady_clock::now() - begin > end;
        };
    };
    play({in_state_until("write", 400ms), in_state_until("write error", 900ms), act([&] {
              EXPECT_EQ(bus.take_accesses(), std::vector<std::string>{});
              EXPECT_EQ(opened, std::vector<std::string>{}) << "the device is not even opened";
              EXPECT_EQ(ready, 0);
              test::add_fpga_manager(root, "operating");
          }),
          until_ready(1)});
    EXPECT_EQ(status("hardware"), "ok");
    EXPECT_EQ(opened, std::vector<std::string>{folder / "dev/uio0"});
    EXPECT_EQ(bus.take_accesses().front(), "R 20") << "the first access is the ID";
}

TEST_F(UioHardware, AMapThatIsTooSmallIsNotTouched)
{
    test::add_uio(root, "uio0", "0x00000800\n");
    test::add_fpga_manager(root, "operating");
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(bus.take_accesses(), std::vector<std::string>{});
    test::add_uio(root);
    play({until_ready(1)});
    EXPECT_EQ(status("hardware"), "ok");
}

TEST_F(UioHardware, AWrongSelfTestEnablesNothing)
{
    test::add_uio(root);
    test::add_fpga_manager(root, "operating");
    bus.stuck_at_zero[0x48] = 1;
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    for (const std::string& access : bus.take_accesses())
        EXPECT_TRUE(access == "R 20" || access == "R 48" || access.starts_with("W 48")) << access;
}

TEST_F(UioHardware, ADeviceGivenByItsNodeIsCheckedToo)
{
    test::add_uio(root, "uio3");
    test::add_fpga_manager(root, "unknown");
    config.registers = UioNode{folder / "dev/uio3"};
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(opened.size(), 0U);
    test::add_fpga_manager(root, "operating");
    play({until_ready(1)});
    EXPECT_EQ(opened, std::vector<std::string>{folder / "dev/uio3"});
}

/// A device of that name is there: no emulation stands in for it.
TEST_F(UioHardware, ADeviceThatIsFoundByItselfIsCheckedToo)
{
    test::add_uio(root);
    test::add_fpga_manager(root, "unknown");
    config.registers = AutoRegisters{};
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(opened.size(), 0U);
}

/// A board's logic may come later than the service: it waits, whatever the order at the boot.
TEST_F(UioHardware, OnAZynqNothingIsEmulatedByItself)
{
    test::make_zynq(root);
    config.registers = AutoRegisters{};
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(hardware.apply(protocol::Words(8)), Applied::Absent);
    test::add_uio(root);
    play({until_ready(1)});
    EXPECT_EQ(status("hardware"), "ok");
    EXPECT_EQ(opened, std::vector<std::string>{folder / "dev/uio0"});
}

TEST_F(UioHardware, LogicWhoseClockIsStoppedIsNeverTouched)
{
    test::make_zynq(root);
    test::set_fclk_enable(root, 0);
    test::add_uio(root);
    test::add_fpga_manager(root, "operating");
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    EXPECT_EQ(opened, std::vector<std::string>{}) << "the device is not even opened";
    test::set_fclk_enable(root, 1);
    play({until_ready(1)});
    EXPECT_EQ(status("hardware"), "ok");
}

TEST_F(UioHardware, WithoutAManagerTheDeviceAloneCounts)
{
    ASSERT_TRUE(hardware.start());
    EXPECT_EQ(status("hardware"), "absent");
    test::add_uio(root); // as when a boot loader has configured the logic
    play({until_ready(1)});
    EXPECT_EQ(status("hardware"), "ok");
    EXPECT_EQ(status("interrupts"), "") << "there is no line";
}

/// An update that finds a commit pending goes out at the interrupt of the frame.
TEST_F(UioHardware, AnInterruptBringsWhatWaitsForTheFrame)
{
    const UniqueFd line(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    bus.interrupt = line.get();
    const auto interrupt_at = [&](std::uint32_t count) {
        bus.interrupts = count;
        const std::uint64_t one = 1;
        ASSERT_EQ(::write(line.get(), &one, sizeof one), 8);
    };
    test::add_uio(root);
    ASSERT_TRUE(hardware.start());
    ASSERT_EQ(ready, 1);
    EXPECT_EQ(status("interrupts"), "0");
    protocol::Words words(8);
    ASSERT_EQ(hardware.apply(words), Applied::Written);

    const auto defer = [&](std::uint32_t word) {
        bus.memory[0x38] = protocol::status::commit_pending;
        words[0] = word;
        static_cast<void>(bus.take_accesses());
        ASSERT_EQ(hardware.apply(words), Applied::Deferred);
        EXPECT_EQ(bus.take_accesses(), (std::vector<std::string>{"R 38", "arm"}));
    };
    play({act([&] {
              defer(7);
              bus.memory[0x38] = protocol::status::frame_done;
              bus.memory[0x3C] = 1;
              interrupt_at(41);
          }),
          [&] { return bus.memory[0] == 7; }, act([&] {
              EXPECT_EQ(status("interrupts"), "1");
              EXPECT_EQ(status("interrupts_missed"), "0");
              EXPECT_EQ(status("frames"), "1");
              defer(8);
              bus.memory[0x38] = 0;
              interrupt_at(44); // two came unseen
          }),
          [&] { return bus.memory[0] == 8; }});
    EXPECT_EQ(status("interrupts"), "4");
    EXPECT_EQ(status("interrupts_missed"), "2");
}

/// The line may be missing, or dead: what waits goes out all the same.
class WithoutInterrupt : public UioHardware, public testing::WithParamInterface<bool>
{};

TEST_P(WithoutInterrupt, WhatWaitsForTheFrameGoesOutToo)
{
    const UniqueFd dead(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    bus.interrupt = GetParam() ? dead.get() : -1;
    test::add_uio(root);
    ASSERT_TRUE(hardware.start());
    protocol::Words words(8);
    ASSERT_EQ(hardware.apply(words), Applied::Written);
    bus.memory[0x38] = protocol::status::commit_pending;
    words[0] = 9;
    ASSERT_EQ(hardware.apply(words), Applied::Deferred);
    EXPECT_EQ(bus.memory[0], 0U);
    bus.memory[0x38] = 0;
    play({[&] { return bus.memory[0] == 9; }});
}
INSTANTIATE_TEST_SUITE_P(Line, WithoutInterrupt, testing::Values(false, true),
                         [](const auto& param) { return param.param ? "Dead" : "Missing"; });

TEST_F(UioHardware, ALineThatBreaksIsADeviceThatIsGone)
{
    const UniqueFd line(::eventfd(1, EFD_NONBLOCK | EFD_CLOEXEC));
    bus.interrupt = line.get();
    bus.interrupt_breaks = true;
    test::add_uio(root);
    ASSERT_TRUE(hardware.start());
    ASSERT_EQ(ready, 1);
    play({[&] { return status("hardware") == "absent"; },
          act([&] { bus.interrupt_breaks = false; }), until_ready(2)});
}

} // namespace
} // namespace raymarch::daemon
