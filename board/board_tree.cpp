// SPDX-License-Identifier: MIT
#include "board/board_tree.hpp"

#include "board/flat_tree.hpp"
#include "drivers/atomic_file.hpp"

#include <algorithm>
#include <array>

namespace raymarch::board
{
namespace
{

const std::string live_tree = "firmware/devicetree/base";
const std::string platform_devices = "bus/platform/devices";
/// The property of the Zynq's clock controller that lists the running clocks. In older device trees
/// its bus is named amba.
constexpr std::array enabled_clocks = {"/axi/slcr@f8000000/clkc@100/fclk-enable",
                                       "/amba/slcr@f8000000/clkc@100/fclk-enable"};
constexpr std::uint32_t first_clock = 1;
/// The number of FCLK0 among the clocks of the controller (dt-bindings: xlnx,ps7-clkc).
constexpr std::uint32_t fclk0 = 15;

/// Returns the last cell of a property that has exactly `cells` cells.
std::optional<std::uint32_t> last_cell(const KernelTree& tree, const std::string& property,
                                       std::size_t cells)
{
    const std::size_t size = cells * sizeof(std::uint32_t);
    const auto bytes = drivers::read_file(tree.path(property), size);
    if (!bytes || bytes->size() != size)
        return std::nullopt;
    return cells_of(drivers::as_bytes(*bytes)).back();
}

/// Returns whether a property with NUL-terminated strings contains `text`.
bool says(const KernelTree& tree, const std::string& property, std::string_view text)
{
    return tree.line(property).value_or("").find(text) != std::string::npos;
}

bool has_clock_driver(const KernelTree& tree)
{
    return std::ranges::any_of(tree.entries(platform_devices), [&](const std::string& device) {
        const std::string folder = platform_devices + "/" + device;
        return tree.exists(folder + "/driver") &&
               says(tree, folder + "/of_node/compatible", "xlnx,fclk") &&
               last_cell(tree, folder + "/of_node/clocks", 2) == fclk0;
    });
}

} // namespace

bool is_zynq(const KernelTree& tree)
{
    return says(tree, live_tree + "/compatible", "xlnx,zynq-7");
}

std::optional<bool> keeps_logic_clock(const KernelTree& tree)
{
    for (const char* const property : enabled_clocks)
        if (const auto clocks = last_cell(tree, live_tree + property, 1))
            return (*clocks & first_clock) != 0 ||
                   says(tree, live_tree + "/chosen/bootargs", "clk_ignore_unused") ||
                   has_clock_driver(tree);
    return std::nullopt;
}

Result<void> require_logic_clock(const KernelTree& tree)
{
    if (keeps_logic_clock(tree) != false)
        return {};
    return fail(plain_error(ErrorKind::Unavailable,
                            "the logic is not touched: Linux stops its clock, FCLK0, because "
                            "fclk-enable of the device tree does not list it and the kernel's "
                            "command line has no clk_ignore_unused"));
}

} // namespace raymarch::board
