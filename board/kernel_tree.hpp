// SPDX-License-Identifier: MIT
/// @file
/// Reads and writes the files of sysfs and configfs. A test gives another root folder.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::board
{

/// The tree under `/sys` or another root. Paths are relative to the root. The functions that change
/// the tree are virtual, so that a test can answer as the kernel does.
class KernelTree
{
  public:
    explicit KernelTree(std::string root = "/sys") : root_(std::move(root)) {}
    KernelTree(const KernelTree&) = delete;
    KernelTree& operator=(const KernelTree&) = delete;
    virtual ~KernelTree() = default;

    /// Returns the full path of a file.
    [[nodiscard]] std::string path(std::string_view file) const;
    /// Returns the path of a folder beside the root: `dev` gives /dev if the root is /sys.
    [[nodiscard]] std::string beside(std::string_view folder) const;

    [[nodiscard]] bool exists(std::string_view file) const;
    /// Returns the sorted names in a folder, or none if it does not exist.
    [[nodiscard]] std::vector<std::string> entries(std::string_view folder) const;
    /// Returns the first line of a file without its LF, or nothing if the file cannot be read.
    [[nodiscard]] std::optional<std::string> line(std::string_view file) const;
    /// Reads the first line as a hexadecimal number with or without 0x.
    [[nodiscard]] std::optional<std::uint64_t> hex(std::string_view file) const;

    /// Writes all bytes with one call, as the kernel requires. An error of close() counts, too.
    /// Errors: Unavailable (the file cannot be opened), InputOutput.
    [[nodiscard]] virtual Result<void> write(std::string_view file, std::string_view bytes);
    /// Errors: InputOutput.
    [[nodiscard]] virtual Result<void> make_folder(std::string_view folder);
    /// Removes a configfs folder; the kernel removes its files. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> remove_folder(std::string_view folder);

  private:
    std::string root_;
};

} // namespace raymarch::board
