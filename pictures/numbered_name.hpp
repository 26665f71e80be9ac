// SPDX-License-Identifier: MIT
/// @file
/// The names of the pictures of a sequence.
#pragma once

#include "base/result.hpp"

#include <cstddef>
#include <string>

namespace raymarch::pictures
{

/// `before`, a number of at least `digits` digits with zeros in front, `after`.
struct NumberedName
{
    std::string before;
    std::size_t digits = 1;
    std::string after;

    [[nodiscard]] std::string at(std::size_t number) const;
};

/// `name_%04d.png` has four digits, `name_%d.png` as many as the number needs; a name without a
/// pattern gets `_%04d` before its ending. Numbers with more digits make longer names.
/// The name of the folder is taken as it is. Errors: Usage for two patterns or another use of %.
[[nodiscard]] Result<NumberedName> numbered_name(const std::string& path);

} // namespace raymarch::pictures
