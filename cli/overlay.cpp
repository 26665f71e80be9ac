// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl overlay`: loads the board's logic and its device tree overlay, removes the overlay,
/// and prints the state of both.
#include "board/board_tree.hpp"
#include "board/device_tree_overlay.hpp"
#include "board/fpga_manager.hpp"
#include "board/interrupt_holders.hpp"
#include "board/logic_loader.hpp"
#include "board/uio_device.hpp"
#include "cli/subcommands.hpp"
#include "drivers/atomic_file.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

using board::KernelTree;

struct OverlayOptions
{
    std::string root = "/sys";
    std::string bitstream; ///< empty means raymarch.bit in the firmware folder
    std::string overlay;   ///< empty means raymarch.dtbo in the firmware folder
};

std::string or_firmware(const KernelTree& tree, const std::string& given, const char* name)
{
    return given.empty() ? tree.beside(fmt::format("{}/{}", board::firmware_folder, name)) : given;
}

void warn(const std::string& text)
{
    fmt::print(stderr, "raymarchctl: {}\n", text);
}

/// Warns of problems that are not errors for the kernel, but for the service.
void print_warnings(const KernelTree& tree)
{
    if (const auto device = board::find_uio(tree, board::overlay_uio_name); !device)
        warn(device.error().message + ": is the driver there, with uio_pdrv_genirq.of_id="
                                      "generic-uio on the kernel's command line?");
    if (const auto runs = board::require_logic_clock(tree); !runs)
        warn(runs.error().message);
}

void print_unbound(const std::vector<board::InterruptHolder>& holders)
{
    std::string names;
    for (const auto& [device, interrupt] : holders)
        names += fmt::format("{}{} (SPI {})", names.empty() ? "" : ", ", device, interrupt);
    if (!names.empty())
        fmt::print("unbound {} from its driver: the interrupt is the overlay's now\n", names);
}

/// Such a bitstream is loaded, because the open tools write no check sequences.
void warn_of_unchecked(const board::LogicFiles& files)
{
    const auto bitstream =
        board::parse_bitstream(drivers::as_bytes(files.bitstream), files.bitstream_name);
    if (bitstream && !bitstream->checked)
        warn(files.bitstream_name + ": the bitstream carries no check of its contents, so damage "
                                    "to them cannot be seen");
}

int load(const OverlayOptions& options)
{
    KernelTree tree(options.root);
    board::LogicFiles files{.bitstream_name = or_firmware(tree, options.bitstream, "raymarch.bit"),
                            .bitstream = {},
                            .overlay_name = or_firmware(tree, options.overlay, "raymarch.dtbo"),
                            .overlay = {}};
    auto bitstream = drivers::read_file(files.bitstream_name, board::largest_bitstream_file);
    if (!bitstream)
        return report(bitstream.error());
    auto overlay = drivers::read_file(files.overlay_name, board::largest_overlay);
    if (!overlay)
        return report(overlay.error());
    files.bitstream = std::move(*bitstream);
    files.overlay = std::move(*overlay);
    warn_of_unchecked(files);
    const auto unbound = board::load_logic(tree, files);
    if (!unbound)
        return report(unbound.error());
    print_unbound(*unbound);
    fmt::print("loaded {} and {}\n", files.bitstream_name, files.overlay_name);
    print_warnings(tree);
    return EX_OK;
}

int unload(const OverlayOptions& options)
{
    KernelTree tree(options.root);
    const auto removed = board::unload_logic(tree);
    if (!removed)
        return report(removed.error());
    fmt::print("{}\n", *removed ? "the overlay is unloaded; the logic stays configured"
                                : "the overlay is not loaded");
    return EX_OK;
}

void print_row(const char* what, const std::string& text)
{
    fmt::print("{:<10} {}\n", what, text);
}

/// Prints the devices that hold an interrupt of the overlay. Prints nothing if the overlay cannot
/// be read.
void print_holders(const KernelTree& tree, const std::string& overlay_name)
{
    const auto overlay = drivers::read_file(overlay_name, board::largest_overlay);
    const auto interrupts =
        board::overlay_interrupts(drivers::as_bytes(overlay.value_or("")), overlay_name);
    if (!interrupts)
        return;
    const bool absent = overlay_state(tree, board::overlay_name) == board::OverlayState::Absent;
    for (const auto& [device, interrupt] :
         board::interrupt_holders(tree, *interrupts, board::overlay_uio_name))
        print_row("interrupt", fmt::format("SPI {} of the overlay is held by {}/{}; 'overlay {}' "
                                           "unbinds it",
                                           interrupt, tree.path(board::uio_driver), device,
                                           absent ? "load" : "unload' and then 'overlay load"));
}

int status(const OverlayOptions& options)
{
    const KernelTree tree(options.root);
    const auto manager = board::find_fpga_manager(tree);
    print_row("logic", manager ? fmt::format("{} ({})", manager->state, manager->driver)
                               : "no FPGA manager");
    print_row("overlay", std::string(to_text(overlay_state(tree, board::overlay_name))));
    const auto device = board::find_uio(tree, board::overlay_uio_name);
    print_row("registers", device ? fmt::format("{}, {} bytes at 0x{:08X}", device->node,
                                                device->size, device->address)
                                  : device.error().message);
    print_holders(tree, or_firmware(tree, options.overlay, "raymarch.dtbo"));
    const auto clock = board::keeps_logic_clock(tree);
    print_row("clock", !clock ? "the device tree does not tell" : *clock ? "kept" : "not kept");
    for (const std::string& feature : board::missing_features(tree))
        print_row("missing", feature);
    return EX_OK;
}

} // namespace

void add_overlay(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "overlay", "loads and unloads the board's logic and its device tree overlay");
    command->require_subcommand(1);
    const auto options = std::make_shared<OverlayOptions>();
    const auto add = [&](const char* name, const char* help, int (*action)(const OverlayOptions&)) {
        CLI::App* const verb = command->add_subcommand(name, help);
        verb->add_option("--sysfs-root", options->root,
                         "folder in place of /sys; the firmware folder and the devices are looked "
                         "for beside it, in ../lib/firmware and ../dev")
            ->type_name("PATH");
        verb->callback([options, action, &run] { run = [=] { return action(*options); }; });
        return verb;
    };
    const auto add_overlay_file = [&](CLI::App* verb) {
        verb->add_option(
                "--overlay", options->overlay,
                "file of the compiled overlay (default: raymarch.dtbo in the firmware folder)")
            ->type_name("FILE");
    };
    CLI::App* const loading =
        add("load", "checks both files, then loads the logic and the overlay", load);
    loading
        ->add_option("--bitstream", options->bitstream,
                     "file of the bitstream: a .bit, or a byte-swapped .bin (default: raymarch.bit "
                     "in the firmware folder)")
        ->type_name("FILE");
    add_overlay_file(loading);
    add("unload", "removes the overlay; the logic stays configured", unload);
    add_overlay_file(
        add("status", "prints the state of logic, overlay and registers, and what the kernel lacks",
            status));
}

} // namespace raymarch::cli
