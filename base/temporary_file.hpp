// SPDX-License-Identifier: MIT
/// @file
/// Writes a file by way of a temporary file and an atomic rename, so that nobody reads half a file.
#pragma once

#include "base/file_target.hpp"
#include "base/result.hpp"
#include "base/unique_fd.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace raymarch
{

/// Whether the new content must survive a power cut (fsync of file and folder) or may be lost.
enum class Durability : std::uint8_t { Durable, BestEffort };

/// Owns a temporary file with a hidden name in the folder of the final file. The destructor removes
/// it unless commit() renamed it. Several processes may write temporary files for one final name;
/// the last commit() wins.
///
/// If the final name is a symbolic link, the file that it leads to is replaced. The new file has
/// the permissions of the old one (read, write, execute and the access control list, no set-id
/// bits) and, if permitted, its owner and group; it never has more readers. If there was no file,
/// the mode is 0666 less the umask. Hard links to the old file keep the old content.
class TemporaryFile
{
  public:
    /// Makes the temporary file in `folder`, which must be on the same file system. Without
    /// `folder`, or if the final name is a symbolic link, it is made in the folder of the target.
    /// Errors: InputOutput, with the final name, if that is not an ordinary file or may not be
    /// written, or if no file can be made in the folder.
    [[nodiscard]] static Result<TemporaryFile> open(const std::string& final_path,
                                                    const std::string& folder = {});

    TemporaryFile(TemporaryFile&& other) noexcept;
    TemporaryFile& operator=(TemporaryFile&& other) noexcept;
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    /// Returns the temporary path. It has the ending of the final name, because an encoder may open
    /// the file itself and take the format from the ending.
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

    /// Appends bytes. Errors: InputOutput.
    [[nodiscard]] Result<void> write(std::span<const std::uint8_t> bytes);
    /// Closes the descriptor, so that a caller can keep many temporary files. Only commit() with
    /// BestEffort may follow. Errors: InputOutput, if the file system reports a failed write only
    /// now.
    [[nodiscard]] Result<void> close();
    /// Renames the file to its final name. If that fails, the old file stays. Errors: InputOutput.
    [[nodiscard]] Result<void> commit(Durability durability = Durability::BestEffort);

  private:
    TemporaryFile(std::string name, FileTarget target) noexcept;

    std::string name_;   ///< the final name as the caller gave it, for messages
    std::string target_; ///< the final name after symbolic links were followed
    std::string path_;   ///< empty after commit() or a move
    UniqueFd fd_;
};

/// Calls `make` with a new temporary path in the folder of `path` until one is free, at most 100
/// times. `make` returns whether it succeeded; it sets errno to EEXIST if the name is in use.
/// Returns the path. Errors: InputOutput.
[[nodiscard]] Result<std::string>
make_temporary(const std::string& path,
               const std::function<bool(const std::string& temporary)>& make);

} // namespace raymarch
