// SPDX-License-Identifier: MIT
#include "board/logic_loader.hpp"

#include "board/device_tree_overlay.hpp"
#include "board/fpga_manager.hpp"
#include "drivers/atomic_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <utility>

namespace raymarch::board
{
namespace
{

namespace fs = std::filesystem;

/// The destructor undoes all steps, the last one first, unless keep() was called.
class Undo
{
  public:
    Undo() = default;
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    ~Undo()
    {
        for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
            (*step)();
    }
    void add(std::function<void()> step) { steps_.push_back(std::move(step)); }
    void keep() { steps_.clear(); }

  private:
    std::vector<std::function<void()>> steps_;
};

/// Writes the `.bin` to the firmware folder and replaces an earlier one.
Result<void> install(const KernelTree& tree, std::span<const std::uint8_t> bin, Undo& undo)
{
    const std::string path = tree.beside(fmt::format("{}/{}", firmware_folder, overlay_firmware));
    const auto target = find_target(path);
    if (!target)
        return fail(target.error());
    auto before = drivers::read_file(path, largest_bitstream_file);
    if (!before && target->file) // the old file could not be restored
        return fail(before.error());
    if (auto written = drivers::replace_file(path, bin, drivers::Durability::Durable); !written)
        return written;
    undo.add([file = target->path, before = std::move(before)] {
        std::error_code ignored; // the first error is reported
        if (!before)
            fs::remove(file, ignored);
        else
            static_cast<void>(drivers::replace_file(file, drivers::as_bytes(*before),
                                                    drivers::Durability::Durable));
    });
    return {};
}

/// Unbinds all other devices that hold an interrupt of the overlay.
Result<std::vector<InterruptHolder>>
unbind_holders(KernelTree& tree, std::span<const SharedInterrupt> interrupts, Undo& undo)
{
    auto holders = interrupt_holders(tree, interrupts, overlay_uio_name);
    for (const InterruptHolder& holder : holders) {
        if (auto unbound = unbind(tree, holder); !unbound)
            return fail(unbound.error());
        undo.add([&tree, holder] { static_cast<void>(bind(tree, holder)); });
    }
    return holders;
}

Result<void> require_features(const KernelTree& tree)
{
    const auto missing = missing_features(tree);
    if (missing.empty())
        return {};
    return fail(plain_error(ErrorKind::Unavailable,
                            fmt::format("this kernel cannot load the logic and its overlay: {}",
                                        fmt::join(missing, "; "))));
}

Result<void> require_absent_overlay(const KernelTree& tree)
{
    const OverlayState state = overlay_state(tree, overlay_name);
    if (state == OverlayState::Absent)
        return {};
    return fail(plain_error(ErrorKind::Unavailable,
                            fmt::format("the overlay {} already exists ({}); unload it first",
                                        overlay_name, to_text(state))));
}

/// The content of both files. The bitstream points into the bytes of its file.
struct CheckedFiles
{
    Bitstream bitstream;
    std::vector<SharedInterrupt> interrupts; ///< the interrupts of the overlay
};

Result<CheckedFiles> check_files(const LogicFiles& files, const LogicDevice& device)
{
    auto bitstream = parse_bitstream(drivers::as_bytes(files.bitstream), files.bitstream_name);
    if (!bitstream)
        return fail(bitstream.error());
    if (auto fits = check_bitstream(*bitstream, device, files.bitstream_name); !fits)
        return fail(fits.error());
    const auto overlay = drivers::as_bytes(files.overlay);
    if (auto whole = check_overlay(overlay, files.overlay_name); !whole)
        return fail(whole.error());
    auto interrupts = overlay_interrupts(overlay, files.overlay_name);
    if (!interrupts)
        return fail(interrupts.error());
    return CheckedFiles{std::move(*bitstream), std::move(*interrupts)};
}

} // namespace

std::vector<std::string> missing_features(const KernelTree& tree)
{
    std::vector<std::string> missing;
    const auto missing_at = [&](std::string_view path, std::string_view why) {
        missing.push_back(fmt::format("{} is missing ({})", tree.path(path), why));
    };
    const auto manager = find_fpga_manager(tree);
    if (!manager)
        missing_at("class/fpga_manager/*", "an FPGA manager: CONFIG_FPGA_MGR_ZYNQ_FPGA, and the "
                                           "device tree's devcfg");
    else if (!manager->takes_firmware && tree.entries("class/fpga_region").empty())
        missing_at(manager->folder + "/firmware",
                   "a vendor kernel's way to load the logic), and so is class/fpga_region/* (the "
                   "overlay's way: CONFIG_OF_FPGA_REGION");
    if (!tree.exists("kernel/config"))
        missing_at("kernel/config", "configfs: CONFIG_CONFIGFS_FS, and mounted");
    else if (!tree.exists(overlays_folder))
        missing_at(overlays_folder, "overlays while the kernel runs: CONFIG_OF_CONFIGFS of a "
                                    "vendor kernel; without it, apply the overlay before the "
                                    "start");
    return missing;
}

Result<std::vector<InterruptHolder>> load_logic(KernelTree& tree, const LogicFiles& files,
                                                const LogicDevice& device)
{
    const auto logic = check_files(files, device);
    if (!logic)
        return fail(logic.error());
    if (auto able = require_features(tree); !able)
        return fail(able.error());
    if (auto absent = require_absent_overlay(tree); !absent)
        return fail(absent.error());
    Undo undo;
    if (auto installed = install(tree, bin_of(logic->bitstream), undo); !installed)
        return fail(installed.error());
    auto unbound = unbind_holders(tree, logic->interrupts, undo); // while their logic still runs
    if (!unbound)
        return unbound;
    const auto manager = find_fpga_manager(tree);
    if (manager->takes_firmware)
        if (auto loaded = load_firmware(tree, *manager, overlay_firmware); !loaded)
            return fail(loaded.error());
    if (auto applied = apply_overlay(tree, overlay_name, files.overlay); !applied)
        return fail(applied.error());
    undo.add([&tree] { static_cast<void>(remove_overlay(tree, overlay_name)); });
    if (auto runs = require_operating_logic(tree); !runs) // the overlay may have loaded the logic
        return fail(runs.error());
    undo.keep();
    return unbound;
}

Result<bool> unload_logic(KernelTree& tree)
{
    switch (overlay_state(tree, overlay_name)) {
    case OverlayState::Unknown:
        return fail(plain_error(ErrorKind::Unavailable,
                                fmt::format("this kernel cannot load overlays: {} is missing",
                                            tree.path(overlays_folder))));
    case OverlayState::Absent:
        return false;
    case OverlayState::Loaded:
    case OverlayState::Failed:
        break;
    }
    if (auto removed = remove_overlay(tree, overlay_name); !removed)
        return fail(removed.error());
    return true;
}

} // namespace raymarch::board
