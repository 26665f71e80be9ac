// SPDX-License-Identifier: MIT
/// @file
/// Register words in an ordinary file, which plays a register block.
#pragma once

#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace raymarch::test
{

/// The word at an offset of a file, in the machine's byte order.
inline std::uint32_t word_in(const std::string& path, std::size_t offset)
{
    const std::string bytes = read_text(path);
    std::uint32_t word = 0;
    EXPECT_GE(bytes.size(), offset + sizeof word);
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

} // namespace raymarch::test
