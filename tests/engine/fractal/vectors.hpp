// SPDX-License-Identifier: MIT
/// @file
/// The frames of the hardware, with what they were made from: tests/data/fractal/.
#pragma once

#include "engine/fractal/frame.hpp"
#include "engine/image.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace raymarch::engine::fractal::test
{

inline constexpr PictureSize size{400, 300};

/// The columns of every line behind the first, which names them.
[[nodiscard]] inline std::vector<std::map<std::string, std::string>>
read_table(const std::string& name)
{
    std::istringstream lines(raymarch::test::read_text(RAYMARCH_TEST_DATA "/data/fractal/" + name));
    std::string line;
    std::getline(lines, line);
    std::vector<std::string> names;
    std::istringstream heads(line);
    for (std::string head; heads >> head;)
        names.push_back(head);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(lines, line)) {
        std::istringstream columns(line);
        auto& row = rows.emplace_back();
        for (const std::string& head : names)
            columns >> row[head];
    }
    return rows;
}

[[nodiscard]] inline Number hex_word(const std::string& text)
{
    return word(static_cast<std::int32_t>(std::stoul(text, nullptr, 16)));
}

/// One frame of the hardware.
struct Vector
{
    std::string name;
    Frame frame;
    std::uint32_t number; ///< since reset
    std::uint64_t evaluations;
    std::map<unsigned, std::uint64_t> cycles; ///< by ray units
    std::vector<std::uint32_t> rows;          ///< CRC-32 of their greys
};

/// A frame's name stands for it in the output of GoogleTest.
inline void PrintTo(const Vector& vector, std::ostream* stream)
{
    *stream << vector.name;
}

[[nodiscard]] inline std::vector<Vector> vectors()
{
    std::map<std::string, std::vector<std::uint32_t>> rows;
    std::istringstream lines(
        raymarch::test::read_text(RAYMARCH_TEST_DATA "/data/fractal/rows.tsv"));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#'))
            continue;
        std::istringstream columns(line);
        std::string name;
        columns >> name >> std::hex;
        for (std::uint32_t crc = 0; columns >> crc;)
            rows[name].push_back(crc);
    }
    std::vector<Vector> vectors;
    for (const auto& row : read_table("frames.tsv")) {
        const auto point = [&](const char* x, const char* y, const char* z) {
            return Point{hex_word(row.at(x)), hex_word(row.at(y)), hex_word(row.at(z))};
        };
        Vector vector{.name = row.at("file"),
                      .frame = {.position = point("px", "py", "pz"),
                                .forward = point("dx", "dy", "dz"),
                                .scene = static_cast<Scene>(std::stoi(row.at("scene"))),
                                .dither = row.at("dither") == "1",
                                .texture = row.at("texture") == "1",
                                .checker = row.at("checker") == "1"},
                      .number = static_cast<std::uint32_t>(std::stoul(row.at("frame_index"))),
                      .evaluations = std::stoull(row.at("sdf_evals")),
                      .cycles = {},
                      .rows = rows[row.at("file")]};
        for (const unsigned units : {4U, 8U, 12U}) {
            const std::string& cycles = row.at("cycles_" + std::to_string(units) + "u");
            if (cycles != "-")
                vector.cycles[units] = std::stoull(cycles);
        }
        vectors.push_back(vector);
    }
    return vectors;
}

} // namespace raymarch::engine::fractal::test
