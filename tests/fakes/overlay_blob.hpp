// SPDX-License-Identifier: MIT
/// @file
/// A compiled overlay to order, as dtc makes them.
#pragma once

#include "tests/fakes/bitstreams.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace raymarch::test
{

/// What an overlay says of each of its devices' `interrupts`, in cells.
using OverlayInterrupts = std::vector<std::vector<std::uint32_t>>;

/// A root with a node for each device, and a property besides its interrupts.
[[nodiscard]] inline std::string overlay_blob(const OverlayInterrupts& devices = {{0, 29, 4}})
{
    using namespace std::string_literals;
    const std::string strings = "reg\0interrupts\0"s;
    const auto property = [](std::size_t name, const std::string& value) {
        return big_endian(3, 4) + big_endian(value.size(), 4) + big_endian(name, 4) + value;
    };
    std::string structure = big_endian(1, 4) + "\0\0\0\0"s;
    for (const auto& interrupts : devices) {
        std::string cells;
        for (const std::uint32_t cell : interrupts)
            cells += big_endian(cell, 4);
        structure += big_endian(1, 4) + "node@0\0\0"s + property(0, "odd\0"s) + big_endian(4, 4) +
                     property(4, cells) + big_endian(2, 4);
    }
    structure += big_endian(2, 4) + big_endian(9, 4);
    constexpr std::size_t header = 40;
    constexpr std::size_t reservations = 16;
    const std::size_t structure_at = header + reservations;
    const std::size_t strings_at = structure_at + structure.size();
    std::string blob;
    for (const std::size_t cell :
         {std::size_t{0xD00D'FEED}, strings_at + strings.size(), structure_at, strings_at, header,
          std::size_t{17}, std::size_t{16}, std::size_t{0}, strings.size(), structure.size()})
        blob += big_endian(cell, 4);
    return blob + std::string(reservations, '\0') + structure + strings;
}

} // namespace raymarch::test
