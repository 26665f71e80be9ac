// SPDX-License-Identifier: MIT
/// @file
/// Converts the code of a parameter to text: the shortest decimal that quantises back to it.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{

/// A text of at most 32 characters, stored in the object.
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

/// Returns the decimal with the fewest fraction digits that is in the range and quantises back to
/// `code`; of several, the nearest. For a choice it returns the name, or digits if it has no name.
/// A code of the format that lies outside the range is printed as if the range were the whole
/// format. If the row has a tail, `tail` is the code of the next row.
[[nodiscard]] ValueText to_text(const Parameter& parameter, std::int64_t code,
                                std::int64_t tail = 0) noexcept;

} // namespace raymarch::protocol
