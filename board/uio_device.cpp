// SPDX-License-Identifier: MIT
#include "board/uio_device.hpp"

#include <filesystem>
#include <limits>
#include <vector>

namespace raymarch::board
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* uio_class = "class/uio";

/// udev may make a link with another name to the device.
std::string kernel_name(const std::string& node)
{
    std::error_code error;
    const fs::path real = fs::canonical(node, error);
    return (error ? fs::path(node) : real).filename().string();
}

} // namespace

Result<drivers::UioDevice> describe_uio(const KernelTree& tree, const std::string& node)
{
    const std::string device = std::string(uio_class) + "/" + kernel_name(node);
    const std::string region = device + "/maps/map0";
    const auto size = tree.hex(region + "/size");
    const auto offset = tree.hex(region + "/offset");
    const auto address = tree.hex(region + "/addr");
    const char* const wrong = !size ? "/size" : !offset ? "/offset" : !address ? "/addr" : nullptr;
    constexpr std::uint64_t most = std::numeric_limits<std::size_t>::max();
    if (wrong != nullptr || *size > most || *offset > most)
        return fail(plain_error(ErrorKind::Unavailable,
                                node + ": " + tree.path(region + (wrong ? wrong : "")) +
                                    " does not describe its registers"));
    return drivers::UioDevice{.node = node,
                              .name = tree.line(device + "/name").value_or(""),
                              .address = *address,
                              .size = static_cast<std::size_t>(*size),
                              .offset = static_cast<std::size_t>(*offset)};
}

Result<drivers::UioDevice> find_uio(const KernelTree& tree, const std::string& name)
{
    std::vector<std::string> found;
    for (const std::string& device : tree.entries(uio_class))
        if (tree.line(std::string(uio_class) + "/" + device + "/name") == name)
            found.push_back(device);
    if (found.size() == 1)
        return describe_uio(tree, tree.beside("dev/" + found.front()));
    if (found.empty())
        return fail(plain_error(ErrorKind::Unavailable, "no UIO device is named " + name + " (" +
                                                            tree.path(uio_class) + "/*/name)"));
    return fail(plain_error(ErrorKind::Config,
                            std::to_string(found.size()) + " UIO devices are named " + name));
}

} // namespace raymarch::board
