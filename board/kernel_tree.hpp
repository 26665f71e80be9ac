// SPDX-License-Identifier: MIT
/// @file
/// sysfs and configfs: small files that the kernel answers. They hang on one root, so that a folder
/// of recorded files stands in for them in a test.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::board
{

/// The tree under `/sys`, or under the folder that plays it. Paths are relative to the root.
/// What changes the tree is virtual: a test's kernel answers it as the real one does.
class KernelTree
{
  public:
    explicit KernelTree(std::string root = "/sys") : root_(std::move(root)) {}
    KernelTree(const KernelTree&) = delete;
    KernelTree& operator=(const KernelTree&) = delete;
    virtual ~KernelTree() = default;

    /// The full name of a file, for messages and for opening it.
    [[nodiscard]] std::string path(std::string_view file) const;
    /// The full name of what stands beside the root: `dev` is /dev where the root is /sys.
    [[nodiscard]] std::string beside(std::string_view folder) const;

    [[nodiscard]] bool exists(std::string_view file) const;
    /// The names in a folder, in order; none where it is missing.
    [[nodiscard]] std::vector<std::string> entries(std::string_view folder) const;
    /// The first line of a file, without its end; nothing where it cannot be read.
    [[nodiscard]] std::optional<std::string> line(std::string_view file) const;
    /// The first line, a number in hexadecimal with or without 0x.
    [[nodiscard]] std::optional<std::uint64_t> hex(std::string_view file) const;

    /// All bytes in one write, as the kernel wants them; what it says at the close counts too.
    /// Errors: Unavailable (cannot be opened), InputOutput.
    [[nodiscard]] virtual Result<void> write(std::string_view file, std::string_view bytes);
    /// Errors: InputOutput.
    [[nodiscard]] virtual Result<void> make_folder(std::string_view folder);
    /// Removes a folder whose files are the kernel's own, as configfs' are. Errors: InputOutput.
    [[nodiscard]] virtual Result<void> remove_folder(std::string_view folder);

  private:
    std::string root_;
};

} // namespace raymarch::board
