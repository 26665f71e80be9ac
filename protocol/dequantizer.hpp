// SPDX-License-Identifier: MIT
/// @file
/// The code of a parameter to text: the shortest decimal that quantises back to it.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{

/// Text of at most 32 characters, kept inside.
class ValueText
{
  public:
    [[nodiscard]] std::string_view view() const noexcept { return {bytes_.data(), size_}; }

  private:
    friend ValueText to_text(const Parameter&, std::int64_t, std::int64_t) noexcept;
    void append(char c) noexcept
    {
        if (size_ < bytes_.size())
            bytes_[size_++] = c;
    }
    std::array<char, max_number_length> bytes_{};
    std::size_t size_ = 0;
};

/// The decimal with the fewest fraction digits that lies in the range and quantises back to `code`,
/// and of those the nearest to it; for a choice its name, or its digits if it has none.
/// A code of the format that lies outside the range is printed as if the range were the whole
/// format. `tail` is the code of the row behind one that has a tail.
[[nodiscard]] ValueText to_text(const Parameter& parameter, std::int64_t code,
                                std::int64_t tail = 0) noexcept;

} // namespace raymarch::protocol
