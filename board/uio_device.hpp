// SPDX-License-Identifier: MIT
/// @file
/// UIO devices as sysfs describes them. Nothing here opens one.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"
#include "drivers/mapped_window.hpp"

#include <string>

namespace raymarch::board
{

/// The description of the device behind `node`, `/dev/uioN` or a symbolic link to it. Errors:
/// Unavailable (sysfs does not describe it, or not completely).
[[nodiscard]] Result<drivers::UioDevice> describe_uio(const KernelTree& tree,
                                                      const std::string& node);

/// The device whose name is `name`; its node stands in the `dev` beside the tree's root. Errors:
/// Unavailable when there is none, Config when there are several.
[[nodiscard]] Result<drivers::UioDevice> find_uio(const KernelTree& tree, const std::string& name);

} // namespace raymarch::board
