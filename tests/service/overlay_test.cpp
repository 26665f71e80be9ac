// SPDX-License-Identifier: MIT
/// @file
/// The board's logic as the programs meet it, with a folder in place of /sys: raymarchd leaves
/// logic alone that is not configured, and raymarchctl loads it, or says why not.
#include "service/support.hpp"
#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/overlay_blob.hpp"

#include <gtest/gtest.h>

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;

/// Whether a file has been opened since this began to watch it.
class OpenWatch
{
  public:
    explicit OpenWatch(const std::string& path) : fd_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
    {
        EXPECT_GE(::inotify_add_watch(fd_.get(), path.c_str(), IN_OPEN), 0) << path;
    }
    [[nodiscard]] bool opened() const
    {
        std::array<char, 4096> events{};
        return ::read(fd_.get(), events.data(), events.size()) > 0;
    }

  private:
    UniqueFd fd_;
};

TEST(Logic, IsNotTouchedUntilItIsConfigured)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    const std::string device = folder / "dev/uio0";
    test::add_uio(root);
    test::add_fpga_manager(root, "write init error");
    test::write_text(device, std::string(4096, '\0'));
    const OpenWatch watch(device);
    const Service service(folder, {"--sysfs-root", root, "--registers", "uio-name:raymarch"});
    ASSERT_TRUE(service.ready());
    EXPECT_EQ(service.status("hardware"), "absent");
    EXPECT_EQ(service.status("logic"), "write_init_error");
    EXPECT_EQ(service.status("overlay"), "unknown");
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SET ZM=2").substr(0, 12), "ERR HARDWARE");
    EXPECT_FALSE(watch.opened());

    test::write_text(root + "/kernel/config/device-tree/overlays/raymarch/status", "applied\n");
    test::add_fpga_manager(root, "operating");
    ASSERT_TRUE(eventually([&] { return service.status("hardware") == "ok"; }));
    EXPECT_TRUE(watch.opened());
    EXPECT_EQ(service.status("logic"), "operating");
    EXPECT_EQ(service.status("overlay"), "loaded");
    EXPECT_EQ(host.ask(original_line).substr(0, 3), "OK ");
    std::vector<std::uint32_t> words(8);
    const std::string bytes = test::read_text(device);
    std::memcpy(words.data(), bytes.data(), 32);
    EXPECT_EQ(words, original_words);
}

/// A kernel that has all, as far as a folder can play it: it makes no files in a new folder.
void make_kernel(const std::string& root)
{
    test::add_fpga_manager(root, "operating");
    const std::string manager = root + "/" + test::fpga0;
    test::write_text(manager + "/flags", "20\n");
    test::write_text(manager + "/firmware", "");
    fs::create_directories(root + "/kernel/config/device-tree/overlays");
    fs::create_directories(root + "/../lib/firmware");
}

TEST(OverlayTool, SaysHowThingsStand)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    test::add_uio(root);
    test::write_text(root + "/kernel/config/device-tree/overlays/raymarch/status", "applied\n");
    const auto status = run_tool(folder, {"overlay", "status", "--sysfs-root", root});
    EXPECT_EQ(status.status, 0) << status.errors;
    EXPECT_EQ(status.output, "logic      operating (Xilinx Zynq FPGA Manager)\n"
                             "overlay    loaded\n"
                             "registers  " +
                                 (folder / "dev/uio0") +
                                 ", 4096 bytes at 0x43C00000\n"
                                 "clock      the device tree does not tell\n");
}

TEST(OverlayTool, SaysWhoHoldsAnInterruptOfTheOverlay)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    test::add_platform_device(root, "40000000.fabric", {0, 29, 4});
    const auto row = [&](const std::string& verb) {
        return "interrupt  SPI 29 of the overlay is held by " + root +
               "/bus/platform/drivers/uio_pdrv_genirq/40000000.fabric; '" + verb + "' unbinds it\n";
    };
    const auto status = [&](const std::string& overlay) {
        return run_tool(folder, {"overlay", "status", "--sysfs-root", root, "--overlay", overlay})
            .output;
    };
    test::write_text(folder / "top.dtbo", test::overlay_blob());
    EXPECT_NE(status(folder / "top.dtbo").find(row("overlay load")), std::string::npos);
    EXPECT_EQ(status(folder / "missing.dtbo").find("interrupt"), std::string::npos);
    test::write_text(folder / "top.dtbo", test::overlay_blob({{0, 30, 4}}));
    EXPECT_EQ(status(folder / "top.dtbo").find("interrupt"), std::string::npos);

    test::write_text(folder / "lib/firmware/raymarch.dtbo", test::overlay_blob());
    test::write_text(root + "/kernel/config/device-tree/overlays/raymarch/status", "applied\n");
    const auto loaded = run_tool(folder, {"overlay", "status", "--sysfs-root", root});
    EXPECT_NE(loaded.output.find(row("overlay unload' and then 'overlay load")), std::string::npos)
        << loaded.output;
}

TEST(OverlayTool, NamesWhatAKernelLacks)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    fs::create_directories(root);
    const auto status = run_tool(folder, {"overlay", "status", "--sysfs-root", root});
    EXPECT_EQ(status.status, 0);
    EXPECT_NE(status.output.find("overlay    unknown\n"), std::string::npos);
    EXPECT_NE(status.output.find("missing    " + root + "/class/fpga_manager/* is missing"),
              std::string::npos)
        << status.output;
    test::write_text(folder / "top.bit", test::make_bit());
    test::write_text(folder / "top.dtbo", test::overlay_blob());
    const auto load = run_tool(folder, {"overlay", "load", "--sysfs-root", root, "--bitstream",
                                        folder / "top.bit", "--overlay", folder / "top.dtbo"});
    EXPECT_EQ(load.status, 69);
    EXPECT_NE(load.errors.find("CONFIG_FPGA_MGR_ZYNQ_FPGA"), std::string::npos) << load.errors;
    EXPECT_NE(load.errors.find("CONFIG_CONFIGFS_FS"), std::string::npos) << load.errors;
    const auto unload = run_tool(folder, {"overlay", "unload", "--sysfs-root", root});
    EXPECT_EQ(unload.status, 69);
}

/// The last step fails here, as the folder has no kernel that makes `dtbo`: all is as before.
TEST(OverlayTool, ALoadThatFailsLeavesNothingBehind)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    const std::string firmware = folder / "lib/firmware";
    test::write_text(firmware + "/raymarch.bit", test::make_bit()); // the default places
    test::write_text(firmware + "/raymarch.dtbo", test::overlay_blob());
    const auto load = run_tool(folder, {"overlay", "load", "--sysfs-root", root});
    EXPECT_EQ(load.status, 74);
    EXPECT_NE(load.errors.find("overlays/raymarch/dtbo: No such file"), std::string::npos)
        << load.errors;
    EXPECT_FALSE(fs::exists(root + "/kernel/config/device-tree/overlays/raymarch"));
    EXPECT_FALSE(fs::exists(firmware + "/raymarch.bin"));
    EXPECT_EQ(test::read_text(root + "/" + test::fpga0 + "/flags"), "20\n");
    EXPECT_EQ(test::read_text(root + "/" + test::fpga0 + "/firmware"), "raymarch.bin\n");
}

TEST(OverlayTool, RefusesABitstreamForAnotherDevice)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    test::write_text(folder / "top.bit", test::make_bit({.part = "7z010clg400"}));
    test::write_text(folder / "top.dtbo", test::overlay_blob());
    const auto load = run_tool(folder, {"overlay", "load", "--sysfs-root", root, "--bitstream",
                                        folder / "top.bit", "--overlay", folder / "top.dtbo"});
    EXPECT_EQ(load.status, 65);
    EXPECT_NE(load.errors.find("top.bit: it is for part 7z010clg400, the board's is 7z020clg400"),
              std::string::npos)
        << load.errors;
    const auto missing = run_tool(folder, {"overlay", "load", "--sysfs-root", root});
    EXPECT_EQ(missing.status, 69);
    EXPECT_NE(missing.errors.find("lib/firmware/raymarch.bit"), std::string::npos)
        << missing.errors;
}

/// Nothing is changed, though the file is for the board and as long as it should be.
TEST(OverlayTool, RefusesADamagedBitstream)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    const std::string firmware = folder / "lib/firmware";
    std::string bit = test::make_bit();
    char& damaged = bit[bit.size() / 3];
    damaged = static_cast<char>(damaged ^ 0x10);
    test::write_text(firmware + "/raymarch.bit", bit);
    test::write_text(firmware + "/raymarch.dtbo", test::overlay_blob());
    const auto load = run_tool(folder, {"overlay", "load", "--sysfs-root", root});
    EXPECT_EQ(load.status, 65);
    EXPECT_NE(load.errors.find("raymarch.bit: damaged: "), std::string::npos) << load.errors;
    EXPECT_FALSE(fs::exists(firmware + "/raymarch.bin"));
}

/// As the open tools write it; only the last step fails here, which needs a kernel.
TEST(OverlayTool, SaysOfABitstreamWithoutACheckThatItHasNone)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    const std::string firmware = folder / "lib/firmware";
    test::write_text(firmware + "/raymarch.bit",
                     test::make_bit({.part = "xc7z020clg400-1", .check = test::Check::Reset}));
    test::write_text(firmware + "/raymarch.dtbo", test::overlay_blob());
    const auto load = run_tool(folder, {"overlay", "load", "--sysfs-root", root});
    EXPECT_EQ(load.status, 74) << load.errors;
    EXPECT_NE(load.errors.find("raymarch.bit: the bitstream carries no check of its contents"),
              std::string::npos)
        << load.errors;
    EXPECT_NE(load.errors.find("overlays/raymarch/dtbo: No such file"), std::string::npos)
        << load.errors;
}

TEST(OverlayTool, UnloadsOnceAndThenSaysSo)
{
    const TemporaryFolder folder;
    const std::string root = folder / "sys";
    make_kernel(root);
    fs::create_directories(root + "/kernel/config/device-tree/overlays/raymarch");
    const auto first = run_tool(folder, {"overlay", "unload", "--sysfs-root", root});
    EXPECT_EQ(first.status, 0) << first.errors;
    EXPECT_FALSE(fs::exists(root + "/kernel/config/device-tree/overlays/raymarch"));
    const auto second = run_tool(folder, {"overlay", "unload", "--sysfs-root", root});
    EXPECT_EQ(second.status, 0);
    EXPECT_EQ(second.output, "the overlay is not loaded\n");
}

} // namespace
} // namespace raymarch::tests
