// SPDX-License-Identifier: MIT
/// @file
/// Finds UIO devices in sysfs. Nothing here opens a device.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"
#include "drivers/mapped_window.hpp"

#include <string>

namespace raymarch::board
{

/// Describes the device behind `node`, `/dev/uioN` or a symbolic link to it. Errors: Unavailable
/// (sysfs does not describe it completely).
[[nodiscard]] Result<drivers::UioDevice> describe_uio(const KernelTree& tree,
                                                      const std::string& node);

/// Finds the device `name`; its node is in the folder `dev` beside the tree's root. Errors:
/// Unavailable if there is none, Config if there are several.
[[nodiscard]] Result<drivers::UioDevice> find_uio(const KernelTree& tree, const std::string& name);

} // namespace raymarch::board
