// SPDX-License-Identifier: MIT
/// @file
/// Loads and removes device tree overlays through configfs.
///
/// Vendor kernels have this interface; the mainline kernel does not. An overlay is a folder. Its
/// blob is written at once, and the kernel applies it when the file is closed. Only the file
/// `status` tells the result.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::board
{

inline constexpr const char* overlays_folder = "kernel/config/device-tree/overlays";

/// The kernel accepts at most this many bytes.
inline constexpr std::size_t largest_overlay = 1 << 20;

enum class OverlayState : std::uint8_t {
    Loaded,
    Absent,
    Failed,  ///< the overlay has a folder, but its status is not `applied`
    Unknown, ///< the folder of all overlays does not exist or cannot be read
};
[[nodiscard]] std::string_view to_text(OverlayState state) noexcept;

[[nodiscard]] OverlayState overlay_state(const KernelTree& tree, const std::string& name);

/// Checks that `blob` is a whole compiled device tree that the kernel can load. Errors: BadData.
[[nodiscard]] Result<void> check_overlay(std::span<const std::uint8_t> blob,
                                         const std::string& name);

/// Loads `blob` as the overlay `name`. If the kernel does not apply it, removes it again. Errors:
/// Unavailable, InputOutput.
[[nodiscard]] Result<void> apply_overlay(KernelTree& tree, const std::string& name,
                                         std::string_view blob);

/// Removes the overlay and its devices. Errors: InputOutput.
[[nodiscard]] Result<void> remove_overlay(KernelTree& tree, const std::string& name);

} // namespace raymarch::board
