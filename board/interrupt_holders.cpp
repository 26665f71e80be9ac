// SPDX-License-Identifier: MIT
#include "board/interrupt_holders.hpp"

#include "board/flat_tree.hpp"
#include "drivers/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace raymarch::board
{
namespace
{

constexpr const char* interrupts_property = "interrupts";
/// A limit for properties in the live tree. Names and interrupts have some ten bytes.
constexpr std::size_t largest_property = 4096;

/// An interrupt of the Zynq's controller has three cells: type, number, flags.
constexpr std::size_t interrupt_cells = 3;
constexpr std::uint32_t shared_type = 0;

/// A value of another length belongs to another controller, such as that of a GPIO block.
std::vector<SharedInterrupt> shared_interrupts(TreeBytes value)
{
    std::vector<SharedInterrupt> numbers;
    if (value.size() % (interrupt_cells * sizeof(std::uint32_t)) != 0)
        return numbers;
    const auto cells = cells_of(value);
    for (std::size_t i = 0; i < cells.size(); i += interrupt_cells)
        if (cells[i] == shared_type)
            numbers.push_back(cells[i + 1]);
    return numbers;
}

/// Returns an empty string if the device has no such property.
std::string property_of(const KernelTree& tree, const std::string& device, const char* name)
{
    return drivers::read_file(tree.path(fmt::format("{}/{}/of_node/{}", uio_driver, device, name)),
                              largest_property)
        .value_or("");
}

Result<void> tell_driver(KernelTree& tree, const char* file, const InterruptHolder& holder)
{
    return tree.write(fmt::format("{}/{}", uio_driver, file), holder.device + "\n");
}

} // namespace

Result<std::vector<SharedInterrupt>> overlay_interrupts(std::span<const std::uint8_t> blob,
                                                        const std::string& file)
{
    const auto values = values_of(blob, interrupts_property, file);
    if (!values)
        return fail(values.error());
    std::vector<SharedInterrupt> all;
    for (const TreeBytes value : *values)
        std::ranges::copy(shared_interrupts(value), std::back_inserter(all));
    return all;
}

std::vector<InterruptHolder> interrupt_holders(const KernelTree& tree,
                                               std::span<const SharedInterrupt> interrupts,
                                               std::string_view own)
{
    std::vector<InterruptHolder> holders;
    // The folder also has files and a link to the module. They have no device tree node.
    for (const std::string& device : tree.entries(uio_driver)) {
        if (property_of(tree, device, "linux,uio-name").c_str() == own)
            continue;
        const std::string held = property_of(tree, device, interrupts_property);
        const auto numbers = shared_interrupts(drivers::as_bytes(held));
        const auto wanted = std::ranges::find_first_of(numbers, interrupts);
        if (wanted != numbers.end())
            holders.push_back({.device = device, .interrupt = *wanted});
    }
    return holders;
}

Result<void> unbind(KernelTree& tree, const InterruptHolder& holder)
{
    const auto told = tell_driver(tree, "unbind", holder);
    if (told)
        return {};
    return fail(plain_error(
        told.error().kind,
        fmt::format("{}, a UIO device, holds an interrupt of the overlay, SPI {}, and cannot be "
                    "unbound: {}; root can, or the board's device tree has to leave it out",
                    holder.device, holder.interrupt, told.error().message)));
}

Result<void> bind(KernelTree& tree, const InterruptHolder& holder)
{
    return tell_driver(tree, "bind", holder);
}

} // namespace raymarch::board
