// SPDX-License-Identifier: MIT
#include "drivers/device_tree_overlay.hpp"

#include <fmt/format.h>

namespace raymarch::drivers
{
namespace
{

constexpr std::uint32_t tree_magic = 0xD00D'FEED;
constexpr std::size_t tree_header_bytes = 40;

std::string folder_of(const std::string& name)
{
    return std::string(overlays_folder) + "/" + name;
}

std::uint32_t big_endian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(at, 4))
        value = value << 8 | byte;
    return value;
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
    const auto bad = [&](const std::string& what) {
        return fail(plain_error(ErrorKind::BadData, name + ": " + what));
    };
    if (blob.size() < tree_header_bytes || big_endian(blob, 0) != tree_magic)
        return bad("no compiled device tree (dtc -@ -I dts -O dtb makes one)");
    if (const std::uint32_t size = big_endian(blob, 4); size != blob.size())
        return bad(fmt::format("its header says {} bytes, and there are {}", size, blob.size()));
    if (blob.size() > largest_overlay)
        return bad(
            fmt::format("{} bytes; the kernel takes at most {}", blob.size(), largest_overlay));
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

} // namespace raymarch::drivers
