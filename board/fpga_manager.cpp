// SPDX-License-Identifier: MIT
#include "board/fpga_manager.hpp"

namespace raymarch::board
{
namespace
{

constexpr const char* manager_class = "class/fpga_manager";
constexpr const char* zynq_driver = "Xilinx Zynq FPGA Manager";
/// No flag is set: the bitstream is for all of the logic and not encrypted.
constexpr const char* whole_logic = "0\n";

std::string state_of(const KernelTree& tree, const std::string& folder)
{
    return tree.line(folder + "/state").value_or("unreadable");
}

} // namespace

std::optional<FpgaManager> find_fpga_manager(const KernelTree& tree)
{
    std::optional<FpgaManager> first;
    for (const std::string& id : tree.entries(manager_class)) {
        const std::string folder = std::string(manager_class) + "/" + id;
        FpgaManager manager{.folder = folder,
                            .driver = tree.line(folder + "/name").value_or(id),
                            .state = state_of(tree, folder),
                            .takes_firmware = tree.exists(folder + "/firmware")};
        if (manager.driver == zynq_driver)
            return manager;
        if (!first)
            first = std::move(manager);
    }
    return first;
}

Result<void> require_operating_logic(const KernelTree& tree)
{
    const auto manager = find_fpga_manager(tree);
    if (!manager || manager->operating())
        return {};
    return fail(plain_error(ErrorKind::Unavailable,
                            "the logic is not touched: " + tree.path(manager->folder) +
                                "/state says '" + manager->state + "', not 'operating'"));
}

Result<void> load_firmware(KernelTree& tree, const FpgaManager& manager,
                           const std::string& firmware)
{
    const std::string flags = manager.folder + "/flags";
    const auto flags_before = tree.line(flags); // some kernels with `firmware` have no `flags`
    if (flags_before)
        if (auto written = tree.write(flags, whole_logic); !written)
            return written;
    const auto loaded = tree.write(manager.folder + "/firmware", firmware + "\n");
    const std::string state = state_of(tree, manager.folder);
    if (flags_before) // other programs need the old flags; an error of the load is reported first
        if (auto restored = tree.write(flags, *flags_before + "\n"); loaded && !restored)
            return restored;
    if (loaded && state == "operating")
        return {};
    return fail(plain_error(ErrorKind::InputOutput,
                            (loaded ? "loading " + firmware : loaded.error().message) +
                                ": the FPGA manager says '" + state +
                                "'; the kernel's log may say why"));
}

} // namespace raymarch::board
