// SPDX-License-Identifier: MIT
#include "board/device_tree_overlay.hpp"

#include "board/flat_tree.hpp"

#include <fmt/format.h>

namespace raymarch::board
{
namespace
{

std::string folder_of(const std::string& name)
{
    return std::string(overlays_folder) + "/" + name;
}

} // namespace

std::string_view to_text(OverlayState state) noexcept
{
    switch (state) {
    case OverlayState::Loaded:
        return "loaded";
    case OverlayState::Absent:
        return "absent";
    case OverlayState::Failed:
        return "failed";
    case OverlayState::Unknown:
        return "unknown";
    }
    return "unknown";
}

OverlayState overlay_state(const KernelTree& tree, const std::string& name)
{
    if (!tree.exists(overlays_folder))
        return OverlayState::Unknown;
    if (!tree.exists(folder_of(name)))
        return OverlayState::Absent;
    return tree.line(folder_of(name) + "/status") == "applied" ? OverlayState::Loaded
                                                               : OverlayState::Failed;
}

Result<void> check_overlay(std::span<const std::uint8_t> blob, const std::string& name)
{
    if (auto begins = check_tree_header(blob, name); !begins)
        return begins;
    if (blob.size() > largest_overlay)
        return fail(plain_error(ErrorKind::BadData,
                                fmt::format("{}: it has {} bytes; the kernel accepts at most {}",
                                            name, blob.size(), largest_overlay)));
    return {};
}

Result<void> apply_overlay(KernelTree& tree, const std::string& name, std::string_view blob)
{
    const std::string folder = folder_of(name);
    if (auto made = tree.make_folder(folder); !made)
        return made;
    auto written = tree.write(folder + "/dtbo", blob);
    if (written && overlay_state(tree, name) == OverlayState::Loaded)
        return {};
    const std::string status = tree.line(folder + "/status").value_or("missing");
    std::string problem =
        written
            ? fmt::format("the kernel did not apply it (status: {}); its log may say why", status)
            : written.error().message;
    if (const auto removed = tree.remove_folder(folder); !removed)
        problem += "; " + removed.error().message;
    return fail(plain_error(ErrorKind::InputOutput, "overlay " + name + ": " + problem));
}

Result<void> remove_overlay(KernelTree& tree, const std::string& name)
{
    return tree.remove_folder(folder_of(name));
}

} // namespace raymarch::board
