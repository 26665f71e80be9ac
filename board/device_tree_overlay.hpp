// SPDX-License-Identifier: MIT
/// @file
/// Device tree overlays through configfs: what is loaded, loading, and taking away.
///
/// The kernel of the board's vendor, and several others, have this; the mainline kernel has not. An
/// overlay is a folder; its blob is written at once, and the kernel applies it when the file is
/// closed, without saying how that went: its `status` does.
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

/// What the kernel's attribute takes.
inline constexpr std::size_t largest_overlay = 1 << 20;

enum class OverlayState : std::uint8_t {
    Loaded,
    Absent,  ///< it is not there
    Failed,  ///< its folder is there, and its status is not that of an applied one
    Unknown, ///< the kernel has no such folder, or does not let us look
};
[[nodiscard]] std::string_view to_text(OverlayState state) noexcept;

[[nodiscard]] OverlayState overlay_state(const KernelTree& tree, const std::string& name);

/// Whether `blob` is a whole compiled device tree that the kernel can take. Errors: BadData.
[[nodiscard]] Result<void> check_overlay(std::span<const std::uint8_t> blob,
                                         const std::string& name);

/// Makes the overlay `name` of `blob`, and sees that it is applied; takes it away again when it is
/// not. Errors: Unavailable, InputOutput.
[[nodiscard]] Result<void> apply_overlay(KernelTree& tree, const std::string& name,
                                         std::string_view blob);

/// Takes the overlay away, and with it its devices. Errors: InputOutput.
[[nodiscard]] Result<void> remove_overlay(KernelTree& tree, const std::string& name);

} // namespace raymarch::board
