// SPDX-License-Identifier: MIT
/// @file
/// Reads tests/data/mandelbulb/*.tsv: a line of names, then a row a line; columns of sixteen digits
/// are hex.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace raymarch::engine::mandelbulb
{

class VectorRow
{
  public:
    VectorRow(const std::vector<std::string>& names, const std::string& line)
    {
        std::istringstream columns(line);
        for (const std::string& name : names)
            columns >> values_[name];
    }
    [[nodiscard]] const std::string& text(const std::string& name) const
    {
        return values_.at(name);
    }
    [[nodiscard]] std::uint64_t word(const std::string& name) const
    {
        return std::stoull(values_.at(name), nullptr, 16);
    }
    [[nodiscard]] std::int64_t raw(const std::string& name) const
    {
        return static_cast<std::int64_t>(word(name));
    }
    [[nodiscard]] int number(const std::string& name) const { return std::stoi(values_.at(name)); }

  private:
    std::map<std::string, std::string> values_;
};

inline std::vector<VectorRow> read_vectors(const std::string& name)
{
    std::ifstream file(RAYMARCH_TEST_DATA "/data/mandelbulb/" + name + ".tsv");
    std::string line;
    std::getline(file, line);
    std::istringstream header(line);
    std::vector<std::string> names;
    for (std::string column; std::getline(header, column, '\t');)
        names.push_back(column);
    std::vector<VectorRow> rows;
    while (std::getline(file, line))
        rows.emplace_back(names, line);
    EXPECT_FALSE(rows.empty()) << name;
    return rows;
}

} // namespace raymarch::engine::mandelbulb
