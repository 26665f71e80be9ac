// SPDX-License-Identifier: MIT
#include "drivers/logic_loader.hpp"

#include "drivers/device_tree_overlay.hpp"
#include "drivers/fpga_manager.hpp"
#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/fake_kernel.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using Calls = std::vector<std::string>;

/// A header that says how long it is, and 24 bytes more.
std::string blob()
{
    return test::big_endian(0xD00D'FEED, 4) + test::big_endian(64, 4) + std::string(56, 'x');
}

/// A compressed one: short, so that the tests are quick.
const test::BitstreamPlan plan{.bytes = 512, .compressed = true};

LogicFiles files()
{
    return {"top.bit", test::make_bit(plan), "top.dtbo", blob()};
}

/// Every file under a folder with what it holds.
std::map<std::string, std::string> contents(const std::string& folder)
{
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        found[entry.path().string()] =
            entry.is_directory() ? "folder" : test::read_text(entry.path().string());
    return found;
}

class Loading : public testing::Test
{
  protected:
    void expect_failure(const LogicFiles& logic, ErrorKind kind, const std::string& part)
    {
        const auto loaded = load_logic(kernel, logic);
        ASSERT_FALSE(loaded) << part;
        EXPECT_EQ(loaded.error().kind, kind) << loaded.error().message;
        EXPECT_NE(loaded.error().message.find(part), std::string::npos) << loaded.error().message;
    }
    /// As a vendor kernel without the files by which logic is loaded: the mainline's manager.
    void take_firmware_attribute_away() const
    {
        fs::remove(kernel.path(std::string(test::fpga0) + "/firmware"));
        fs::remove(kernel.path(std::string(test::fpga0) + "/flags"));
    }
    test::TemporaryFolder folder;
    test::FakeKernel kernel{folder};
    std::string installed = folder / "lib/firmware/raymarch.bin";
};

TEST_F(Loading, GoesStepByStep)
{
    const auto loaded = load_logic(kernel, files());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(kernel.calls, (Calls{"write flags 0", "write firmware raymarch.bin", "write flags 20",
                                   "make raymarch", "write dtbo"}));
    EXPECT_EQ(test::read_text(installed), test::make_bin(plan));
    EXPECT_EQ(test::read_text(kernel.path(overlays_folder) + "/raymarch/dtbo"), blob());
    EXPECT_EQ(overlay_state(kernel, overlay_name), OverlayState::Loaded);
    EXPECT_TRUE(require_operating_logic(kernel));
}

TEST_F(Loading, WhatIsLoadedIsNotLoadedAgain)
{
    ASSERT_TRUE(load_logic(kernel, files()));
    kernel.calls.clear();
    expect_failure(files(), ErrorKind::Unavailable, "unload it first");
    EXPECT_EQ(kernel.calls, Calls{});
}

TEST_F(Loading, UnloadingTakesTheOverlayAwayAndLeavesTheLogic)
{
    ASSERT_TRUE(load_logic(kernel, files()));
    EXPECT_EQ(unload_logic(kernel).value(), true);
    EXPECT_EQ(overlay_state(kernel, overlay_name), OverlayState::Absent);
    EXPECT_TRUE(require_operating_logic(kernel));
    EXPECT_EQ(unload_logic(kernel).value(), false);
    EXPECT_TRUE(load_logic(kernel, files()));
}

TEST_F(Loading, AWrongFileChangesNothing)
{
    const auto before = contents(folder / "");
    LogicFiles wrong = files();
    wrong.bitstream = test::make_bit({.part = "7a35tcpg236", .bytes = 512, .compressed = true});
    expect_failure(wrong, ErrorKind::BadData, "top.bit: it is for part 7a35tcpg236");
    wrong = files();
    wrong.overlay[0] = 'x';
    expect_failure(wrong, ErrorKind::BadData, "top.dtbo: no compiled device tree");
    wrong.overlay = blob() + 'x';
    expect_failure(wrong, ErrorKind::BadData, "64 bytes, and there are 65");
    wrong.overlay.clear();
    expect_failure(wrong, ErrorKind::BadData, "top.dtbo");
    wrong.overlay = test::big_endian(0xD00D'FEED, 4) + test::big_endian(largest_overlay + 1, 4) +
                    std::string(largest_overlay - 7, 'x');
    expect_failure(wrong, ErrorKind::BadData, "at most 1048576");
    EXPECT_EQ(kernel.calls, Calls{});
    EXPECT_EQ(contents(folder / ""), before);
}

/// Whichever step fails, files and folders are as before; only the logic cannot be taken back.
TEST_F(Loading, AStepThatFailsUndoesThoseBeforeIt)
{
    test::write_text(installed, "an earlier one");
    for (const bool first_time : {false, true}) {
        if (first_time)
            fs::remove(installed);
        for (const std::string step : {"flags", "firmware", "raymarch", "dtbo"}) {
            kernel.set_state("unknown");
            const auto before = contents(folder / "");
            kernel.refuses = {step};
            expect_failure(files(), ErrorKind::InputOutput, step + ": refused");
            kernel.set_state("unknown");
            test::write_text(kernel.path(std::string(test::fpga0) + "/firmware"), "");
            EXPECT_EQ(contents(folder / ""), before) << step;
        }
    }
}

TEST_F(Loading, LogicThatDoesNotComeUpIsReported)
{
    kernel.configures = false;
    expect_failure(files(), ErrorKind::InputOutput, "the FPGA manager says 'write error'");
    EXPECT_FALSE(fs::exists(installed));
    EXPECT_EQ(kernel.calls.back(), "write flags 20");
}

TEST_F(Loading, AnOverlayThatIsNotAppliedIsTakenAway)
{
    kernel.applies = false;
    expect_failure(files(), ErrorKind::InputOutput, "did not apply it (status: unapplied)");
    EXPECT_EQ(kernel.calls.back(), "remove raymarch");
    EXPECT_EQ(overlay_state(kernel, overlay_name), OverlayState::Absent);
    EXPECT_FALSE(fs::exists(installed));
}

TEST_F(Loading, AManagerThatTakesNoFileLeavesItToTheRegion)
{
    take_firmware_attribute_away();
    fs::create_directories(kernel.path("class/fpga_region/region0"));
    kernel.loads_by_region = true;
    const auto loaded = load_logic(kernel, files());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(kernel.calls, (Calls{"make raymarch", "write dtbo"}));
    EXPECT_EQ(test::read_text(installed), test::make_bin(plan));
}

TEST_F(Loading, ARegionThatLoadsNothingIsAFailure)
{
    take_firmware_attribute_away();
    fs::create_directories(kernel.path("class/fpga_region/region0"));
    expect_failure(files(), ErrorKind::Unavailable, "state says 'unknown'");
    EXPECT_EQ(kernel.calls, (Calls{"make raymarch", "write dtbo", "remove raymarch"}));
    EXPECT_FALSE(fs::exists(installed));
}

TEST_F(Loading, MissingFeaturesAreNamed)
{
    EXPECT_EQ(missing_features(kernel), Calls{});
    take_firmware_attribute_away();
    expect_failure(files(), ErrorKind::Unavailable, "CONFIG_OF_FPGA_REGION");
    fs::remove_all(kernel.path("class/fpga_manager"));
    fs::remove_all(kernel.path(overlays_folder));
    expect_failure(files(), ErrorKind::Unavailable, "CONFIG_FPGA_MGR_ZYNQ_FPGA");
    expect_failure(files(), ErrorKind::Unavailable, "CONFIG_OF_CONFIGFS");
    fs::remove_all(kernel.path("kernel"));
    expect_failure(files(), ErrorKind::Unavailable, "CONFIG_CONFIGFS_FS");
    EXPECT_EQ(missing_features(kernel).size(), 2U);
    EXPECT_EQ(kernel.calls, Calls{});
    const auto unloaded = unload_logic(kernel);
    ASSERT_FALSE(unloaded);
    EXPECT_EQ(unloaded.error().kind, ErrorKind::Unavailable);
}

TEST_F(Loading, AnOverlayIsLoadedAbsentFailedOrUnknown)
{
    EXPECT_EQ(to_text(overlay_state(kernel, overlay_name)), "absent");
    ASSERT_TRUE(load_logic(kernel, files()));
    EXPECT_EQ(to_text(overlay_state(kernel, overlay_name)), "loaded");
    test::write_text(kernel.path(overlays_folder) + "/raymarch/status", "unapplied\n");
    EXPECT_EQ(to_text(overlay_state(kernel, overlay_name)), "failed");
    fs::remove_all(kernel.path("kernel"));
    EXPECT_EQ(to_text(overlay_state(kernel, overlay_name)), "unknown");
}

TEST(FpgaManager, WithoutOneNothingForbidsAnAccess)
{
    const test::TemporaryFolder folder;
    EXPECT_TRUE(require_operating_logic(KernelTree(folder / "sys")));
}

TEST(FpgaManager, OnlyOperatingLogicMayBeTouched)
{
    const test::TemporaryFolder folder;
    const KernelTree tree(folder / "sys");
    // Every other state that the kernel knows, and none at all.
    for (const std::string state :
         {"unknown", "power off", "power up", "reset", "firmware request", "firmware request error",
          "parse header", "parse header error", "write init", "write init error", "write",
          "write error", "write complete", "write complete error", ""}) {
        test::add_fpga_manager(folder / "sys", state);
        const auto safe = require_operating_logic(tree);
        ASSERT_FALSE(safe) << state;
        EXPECT_EQ(safe.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(safe.error().message.find("'" + state + "'"), std::string::npos);
    }
    fs::remove(tree.path(std::string(test::fpga0) + "/state"));
    EXPECT_FALSE(require_operating_logic(tree));
    test::add_fpga_manager(folder / "sys", "operating");
    EXPECT_TRUE(require_operating_logic(tree));
}

TEST(FpgaManager, TheProcessorsOwnComesFirst)
{
    const test::TemporaryFolder folder;
    const KernelTree tree(folder / "sys");
    test::write_text(tree.path("class/fpga_manager/fpga0/name"), "Lattice iCE40 FPGA Manager\n");
    test::write_text(tree.path("class/fpga_manager/fpga0/state"), "operating\n");
    EXPECT_EQ(find_fpga_manager(tree)->driver, "Lattice iCE40 FPGA Manager");
    test::write_text(tree.path("class/fpga_manager/fpga1/name"), "Xilinx Zynq FPGA Manager\n");
    test::write_text(tree.path("class/fpga_manager/fpga1/state"), "unknown\n");
    EXPECT_EQ(find_fpga_manager(tree)->folder, "class/fpga_manager/fpga1");
    EXPECT_FALSE(require_operating_logic(tree));
}

} // namespace
} // namespace raymarch::drivers
