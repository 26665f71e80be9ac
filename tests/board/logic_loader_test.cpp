// SPDX-License-Identifier: MIT
#include "board/logic_loader.hpp"

#include "board/device_tree_overlay.hpp"
#include "board/fpga_manager.hpp"
#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/overlay_blob.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raymarch::board
{
namespace
{

namespace fs = std::filesystem;
using Calls = std::vector<std::string>;

/// The overlay's interrupts are SPI 29 and 30.
std::string blob()
{
    return test::overlay_blob({{0, 29, 4}, {0, 30, 4}});
}

/// A compressed bitstream is short, so the tests are quick.
const test::BitstreamPlan plan = test::compressed_plan();

LogicFiles files()
{
    static const std::string bit = test::make_bit(plan);
    return {"top.bit", bit, "top.dtbo", blob()};
}

/// Returns every file under a folder with its content.
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
    /// The FPGA manager of a mainline kernel has no files to load logic.
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
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    const auto before = contents(folder / "");
    LogicFiles wrong = files();
    wrong.bitstream = test::make_bit({.part = "7a35tcpg236", .frames = 1});
    expect_failure(wrong, ErrorKind::BadData, "top.bit: it is for part 7a35tcpg236");
    wrong = files();
    char& damaged = wrong.bitstream[wrong.bitstream.size() / 2];
    damaged = static_cast<char>(damaged ^ 1);
    expect_failure(wrong, ErrorKind::BadData, "top.bit: damaged: ");
    wrong.bitstream = test::make_bit({.frames = 2, .repeated_frames = 1});
    expect_failure(wrong, ErrorKind::BadData, "top.bit: it configures only a part of the logic");
    wrong = files();
    wrong.overlay[0] = 'x';
    expect_failure(wrong, ErrorKind::BadData, "top.dtbo: it is not a compiled device tree");
    wrong.overlay = blob() + 'x';
    expect_failure(wrong, ErrorKind::BadData, std::to_string(blob().size() + 1));
    wrong.overlay = blob().replace(59, 1, "x"); // the first token
    expect_failure(wrong, ErrorKind::BadData, "top.dtbo: its nodes are cut or damaged");
    wrong.overlay.clear();
    expect_failure(wrong, ErrorKind::BadData, "top.dtbo");
    wrong.overlay = blob().replace(4, 4, test::big_endian(largest_overlay + 1, 4));
    wrong.overlay.resize(largest_overlay + 1);
    expect_failure(wrong, ErrorKind::BadData, "at most 1048576");
    EXPECT_EQ(kernel.calls, Calls{});
    EXPECT_EQ(contents(folder / ""), before);
}

/// Whichever step fails, files and folders are as before. Only the logic stays changed.
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

/// PYNQ's device tree has such a device. The other devices have another driver or interrupt.
TEST_F(Loading, WhoHoldsAnInterruptOfTheOverlayGivesWay)
{
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    test::add_platform_device(folder / "sys", "40010000.other", {0, 52, 4});
    test::add_platform_device(folder / "sys", "e0001000.serial", {0, 30, 4}, "xuartps");
    const auto loaded = load_logic(kernel, files());
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_EQ(loaded->size(), 1U);
    EXPECT_EQ(loaded->front().device, "40000000.fabric");
    EXPECT_EQ(loaded->front().interrupt, 29U);
    EXPECT_EQ(kernel.calls,
              (Calls{"write unbind 40000000.fabric", "write flags 0", "write firmware raymarch.bin",
                     "write flags 20", "make raymarch", "write dtbo"}));
    kernel.calls.clear();
    ASSERT_TRUE(unload_logic(kernel));
    EXPECT_EQ(kernel.calls, Calls{"remove raymarch"}) << "its logic is gone: it stays unbound";
    EXPECT_TRUE(load_logic(kernel, files()).value().empty());
}

TEST_F(Loading, WhoGaveWayComesBackWhenALaterStepFails)
{
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    test::add_platform_device(folder / "sys", "40010000.second", {0, 30, 4});
    const auto before = contents(folder / "");
    for (const std::string step : {"flags", "raymarch", "dtbo"}) {
        kernel.refuses = {step};
        expect_failure(files(), ErrorKind::InputOutput, step + ": refused");
        const std::size_t count = kernel.calls.size();
        EXPECT_EQ(Calls(kernel.calls.begin() + static_cast<std::ptrdiff_t>(count) - 2,
                        kernel.calls.end()),
                  (Calls{"write bind 40010000.second", "write bind 40000000.fabric"}));
        kernel.set_state("unknown");
        test::write_text(kernel.path(std::string(test::fpga0) + "/firmware"), "");
        EXPECT_EQ(contents(folder / ""), before) << step;
    }
}

TEST_F(Loading, WhoDoesNotGiveWayIsAnErrorThatNamesTheFile)
{
    test::add_platform_device(folder / "sys", "40000000.fabric", {0, 29, 4});
    const auto before = contents(folder / "");
    kernel.refuses = {"unbind"};
    expect_failure(files(), ErrorKind::InputOutput,
                   "40000000.fabric, a UIO device, holds an "
                   "interrupt of the overlay, SPI 29");
    expect_failure(files(), ErrorKind::InputOutput, "unbind: refused");
    EXPECT_EQ(contents(folder / ""), before);
    kernel.refuses.clear();
    fs::remove(kernel.path(std::string(uio_driver) + "/unbind"));
    expect_failure(files(), ErrorKind::Unavailable,
                   "open " + kernel.path(uio_driver) + "/unbind: No such file");
    EXPECT_FALSE(fs::exists(installed));
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
    // The list has every other state that the kernel knows, and no state.
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
} // namespace raymarch::board
