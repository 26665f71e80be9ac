// SPDX-License-Identifier: MIT
/// @file
/// The words of a bitstream, and what the configuration logic of the 7 series would make of them.
/// Only the files of the bitstream include it.
#pragma once

#include "board/bitstream.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::board
{

/// Makes the error `NAME: WHAT` of kind BadData.
[[nodiscard]] Error bad_bitstream(const std::string& name, std::string_view what);

/// Reads a big-endian number of `count` bytes. Precondition: they are there.
[[nodiscard]] inline std::uint32_t big_endian(std::span<const std::uint8_t> bytes, std::size_t at,
                                              std::size_t count)
{
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(at, count))
        value = value << 8 | byte;
    return value;
}

/// Configuration words, in either byte order. Borrows their bytes.
class ConfigurationWords
{
  public:
    ConfigurationWords(std::span<const std::uint8_t> data, BitstreamForm form)
        : data_(data)
        , form_(form)
    {}
    [[nodiscard]] std::size_t size() const { return data_.size() / 4; }
    [[nodiscard]] std::uint32_t operator[](std::size_t index) const
    {
        const std::uint32_t word = big_endian(data_, 4 * index, 4);
        return form_ == BitstreamForm::Bit ? word : __builtin_bswap32(word);
    }
    [[nodiscard]] std::optional<std::size_t> find(std::uint32_t wanted) const
    {
        for (std::size_t i = 0; i < size(); ++i)
            if ((*this)[i] == wanted)
                return i;
        return std::nullopt;
    }

  private:
    std::span<const std::uint8_t> data_;
    BitstreamForm form_;
};

/// Finds the sync word, reads from there to the command that ends the configuration, and fills in
/// the rest of `bitstream`.
/// Errors: BadData.
[[nodiscard]] Result<void> read_configuration(const ConfigurationWords& words,
                                              const std::string& name, Bitstream& bitstream);

} // namespace raymarch::board
