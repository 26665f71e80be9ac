// SPDX-License-Identifier: MIT
/// @file
/// UIO devices as sysfs describes them. Nothing here opens one.
#pragma once

#include "base/result.hpp"
#include "drivers/kernel_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace raymarch::drivers
{

/// One UIO device and its first region, map0.
struct UioDevice
{
    std::string node;          ///< what is opened: `/dev/uio0`
    std::string name;          ///< what the device tree calls it
    std::uint64_t address = 0; ///< of the region, physical
    std::size_t size = 0;      ///< of the region in bytes
    std::size_t offset = 0;    ///< of the region within its first page
};

/// The description of the device behind `node`, `/dev/uioN` or a symbolic link to it. Errors:
/// Unavailable (sysfs does not describe it, or not completely).
[[nodiscard]] Result<UioDevice> describe_uio(const KernelTree& tree, const std::string& node);

/// The device whose name is `name`; its node stands in the `dev` beside the tree's root. Errors:
/// Unavailable when there is none, Config when there are several.
[[nodiscard]] Result<UioDevice> find_uio(const KernelTree& tree, const std::string& name);

} // namespace raymarch::drivers
