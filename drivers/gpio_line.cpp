// SPDX-License-Identifier: MIT
/// @file
/// Finds the line that a setting names. The chips are listed from sysfs, because libgpiod reads
/// /dev with 32-bit offsets, which fails if a 32-bit program runs on a 64-bit file system.
#include "drivers/gpio_line.hpp"

#include "drivers/gpio_chip.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* chips_folder = "/sys/bus/gpio/devices";

struct FoundLine
{
    std::string chip; ///< the path of the chip
    unsigned offset = 0;
};

std::vector<std::string> chip_paths()
{
    std::vector<std::string> paths;
    std::error_code ignored; // without the folder there is no chip
    for (const fs::directory_entry& entry : fs::directory_iterator(chips_folder, ignored))
        paths.push_back("/dev/" + entry.path().filename().string());
    std::ranges::sort(paths);
    return paths;
}

Error missing(std::string message)
{
    return plain_error(ErrorKind::Unavailable, std::move(message));
}

/// Returns the first chip for which `offset_in` gives an offset. A chip that cannot be opened is
/// skipped, and named in the error if no other chip has the line.
template <typename OffsetIn>
Result<FoundLine> search(const std::string& what, OffsetIn offset_in)
{
    const std::vector<std::string> paths = chip_paths();
    if (paths.empty())
        return fail(Error{ErrorKind::Unavailable, ENODEV, "there is no GPIO chip"});
    std::string refused;
    for (const std::string& path : paths) {
        const Result<std::optional<unsigned>> offset =
            guarded(ErrorKind::Unavailable, path, [&] { return offset_in(path); });
        if (!offset)
            refused = " (" + offset.error().message + ")";
        else if (*offset)
            return FoundLine{path, **offset};
    }
    return fail(missing("no GPIO " + what + refused));
}

Result<FoundLine> find_place(const LinePlace& place)
{
    if (place.chip.empty())
        return search("line is named " + place.name,
                      [&](const std::string& chip) { return find_named_line(chip, place.name); });
    if (place.chip.starts_with('/'))
        return FoundLine{place.chip, place.offset};
    return search("chip has the label " + place.chip, [&](const std::string& chip) {
        return label_of_chip(chip) == place.chip ? std::optional(place.offset) : std::nullopt;
    });
}

Result<std::unique_ptr<Pin>> open_place(const LinePlace& place, const LineSpec& spec, LineUse use)
{
    const auto line = find_place(place);
    if (!line)
        return fail(line.error());
    const std::string name = "GPIO line " + to_string(place);
    return guarded(ErrorKind::Unavailable, name,
                   [&] { return request_line(line->chip, line->offset, spec, use, name); });
}

} // namespace

Result<std::unique_ptr<Pin>> open_gpio_line(const LineSpec& spec, LineUse use)
{
    Error problem = missing("");
    for (const LinePlace& place : spec.places) {
        auto pin = open_place(place, spec, use);
        if (pin)
            return pin;
        problem.number = pin.error().number;
        problem.message += (problem.message.empty() ? "" : "; ") + pin.error().message;
    }
    return fail(problem);
}

} // namespace raymarch::drivers
