// SPDX-License-Identifier: MIT
/// @file
/// A kernel for the loading of logic: a folder with the files of sysfs and configfs, in the formats
/// that Linux prints them, which answers what is written to it as the kernel does.
#pragma once

#include "board/device_tree_overlay.hpp"
#include "board/kernel_tree.hpp"
#include "tests/fakes/bitstreams.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::test
{

inline constexpr const char* fpga0 = "class/fpga_manager/fpga0";

/// A UIO device of the overlay's register page.
inline void add_uio(const std::string& root, const std::string& device = "uio0",
                    const std::string& size = "0x00001000\n",
                    const std::string& name = "raymarch\n")
{
    const std::string folder = root + "/class/uio/" + device;
    write_text(folder + "/name", name);
    write_text(folder + "/event", "0\n");
    write_text(folder + "/maps/map0/addr", "0x43c00000\n");
    write_text(folder + "/maps/map0/offset", "0x0\n");
    write_text(folder + "/maps/map0/size", size);
}

inline void add_fpga_manager(const std::string& root, const std::string& state)
{
    write_text(root + "/" + fpga0 + "/name", "Xilinx Zynq FPGA Manager\n");
    write_text(root + "/" + fpga0 + "/state", state + "\n");
    write_text(root + "/" + fpga0 + "/status", "");
}

/// What the live device tree of a Zynq says of itself.
inline void make_zynq(const std::string& root)
{
    using namespace std::string_literals; // they know their length, with every zero
    write_text(root + "/firmware/devicetree/base/compatible",
               "digilent,pynq-z1\0xlnx,zynq-7000\0"s);
}

/// Which clocks of the logic Linux leaves on, a bit each.
inline void set_fclk_enable(const std::string& root, std::uint32_t bits,
                            const std::string& bus = "axi")
{
    write_text(root + "/firmware/devicetree/base/" + bus + "/slcr@f8000000/clkc@100/fclk-enable",
               big_endian(bits, 4));
}

/// A platform device, bound to its driver; the interrupts are cells as the device tree has them.
inline void add_platform_device(const std::string& root, const std::string& name,
                                const std::vector<std::uint32_t>& interrupts,
                                const std::string& driver = "uio_pdrv_genirq")
{
    const std::string device = root + "/devices/platform/" + name;
    std::string value;
    for (const std::uint32_t cell : interrupts)
        value += big_endian(cell, 4);
    write_text(device + "/of_node/interrupts", value);
    const std::string folder = root + "/bus/platform/drivers/" + driver;
    for (const char* const file : {"bind", "unbind", "uevent"})
        write_text(folder + "/" + file, "");
    std::filesystem::create_directories(root + "/module/" + driver);
    std::error_code there_already;
    std::filesystem::create_directory_symlink("../../../../module/" + driver, folder + "/module",
                                              there_already);
    std::filesystem::create_directory_symlink("../../../../devices/platform/" + name,
                                              folder + "/" + name);
}

class FakeKernel final : public board::KernelTree
{
  public:
    /// The root is `sys` in `folder`, the firmware in `lib/firmware` beside it. What it has is that
    /// of a vendor kernel: an FPGA manager that takes files, and overlays.
    explicit FakeKernel(const TemporaryFolder& folder)
        : KernelTree(folder / "sys")
        , root_(folder / "sys")
    {
        add_fpga_manager(root_, "unknown");
        write_text(path(std::string(fpga0) + "/flags"), "20\n");
        write_text(path(std::string(fpga0) + "/firmware"), "");
        std::filesystem::create_directories(path(board::overlays_folder));
        std::filesystem::create_directories(beside("lib/firmware"));
    }

    Result<void> write(std::string_view file, std::string_view bytes) override
    {
        const bool is_blob = file.ends_with("/dtbo");
        calls.push_back("write " + name_of(file) + (is_blob ? "" : " " + one_line(bytes)));
        if (refuses.contains(name_of(file)))
            return refuse(file);
        if (exists(file) && (name_of(file) == "unbind" || name_of(file) == "bind"))
            return set_bound(parent_of(file) + "/" + one_line(bytes), name_of(file) == "bind");
        auto written = KernelTree::write(file, bytes);
        if (file.ends_with("/firmware"))
            set_state(configures && exists_beside("lib/firmware/" + one_line(bytes))
                          ? "operating"
                          : "write error");
        if (is_blob && applies) {
            write_text(path(parent_of(file) + "/status"), "applied\n");
            if (loads_by_region)
                set_state("operating");
        }
        return written;
    }
    Result<void> make_folder(std::string_view folder) override
    {
        calls.push_back("make " + name_of(folder));
        if (refuses.contains(name_of(folder)))
            return refuse(folder);
        auto made = KernelTree::make_folder(folder);
        write_text(path(std::string(folder) + "/status"), "unapplied\n");
        write_text(path(std::string(folder) + "/path"), "\n");
        write_text(path(std::string(folder) + "/dtbo"), "");
        return made;
    }
    Result<void> remove_folder(std::string_view folder) override
    {
        calls.push_back("remove " + name_of(folder));
        std::filesystem::remove_all(path(folder)); // the files are the kernel's
        return {};
    }

    void set_state(const std::string& state) const
    {
        write_text(path(std::string(fpga0) + "/state"), state + "\n");
    }

    std::vector<std::string> calls; ///< "write flags 0", "make raymarch", in order
    std::set<std::string> refuses;  ///< names of files and folders whose change fails
    bool configures = true;         ///< a file that is loaded makes the logic run
    bool applies = true;            ///< an overlay that is written is applied
    bool loads_by_region = false;   ///< an overlay that is applied makes the logic run

  private:
    /// A driver's link to the device comes and goes.
    [[nodiscard]] Result<void> set_bound(const std::string& link, bool bound) const
    {
        if (exists(link) == bound)
            return fail(plain_error(ErrorKind::InputOutput, link + ": No such device"));
        if (bound)
            std::filesystem::create_directory_symlink(
                "../../../../devices/platform/" + name_of(link), path(link));
        else
            std::filesystem::remove(path(link));
        return {};
    }
    static std::string name_of(std::string_view file)
    {
        return std::filesystem::path(file).filename().string();
    }
    static std::string parent_of(std::string_view file)
    {
        return std::filesystem::path(file).parent_path().string();
    }
    static std::string one_line(std::string_view text)
    {
        return std::string(text.substr(0, text.find('\n')));
    }
    [[nodiscard]] bool exists_beside(const std::string& file) const
    {
        return std::filesystem::exists(beside(file));
    }
    static Result<void> refuse(std::string_view file)
    {
        return fail(plain_error(ErrorKind::InputOutput, name_of(file) + ": refused"));
    }
    std::string root_;
};

} // namespace raymarch::test
