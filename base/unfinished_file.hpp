// SPDX-License-Identifier: MIT
/// @file
/// A temporary file that replaces its target as a whole. It has a hidden name in the target's
/// folder until it is complete, so nobody reads half a file, and an abandoned one is removed.
///
/// Pictures, films, captures and the state are written in this way.
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

/// Owns the temporary file, and removes it when destroyed unless finish() was called. Several may
/// be written for one final name at once, by several processes too. The one that is finished last
/// wins.
///
/// A final name that is a symbolic link stays one, and the file that it leads to is replaced. The
/// new file has the permissions of the old one (read, write, execute and the access list, no
/// set-id bits) and, where this is permitted, its owner and group; it never has more readers. A
/// file that did not exist gets mode 0666 less the umask of the process. Other names of the old
/// file (hard links) keep the old content.
class UnfinishedFile
{
  public:
    /// Errors: InputOutput, with the final name, if that is not an ordinary file or may not be
    /// written, or if its folder is missing or does not take files. If `hidden_folder` is given, it
    /// is on the same file system, and the temporary file is made there. If the final name is a
    /// symbolic link, the temporary file is made beside the link's target all the same.
    [[nodiscard]] static Result<UnfinishedFile> open(const std::string& final_path,
                                                     const std::string& hidden_folder = {});

    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;
    ~UnfinishedFile();

    /// The hidden name. It has the final name's ending, for an encoder that opens the file by
    /// itself.
    [[nodiscard]] const std::string& path() const noexcept { return hidden_; }

    /// Appends bytes. Errors: InputOutput.
    [[nodiscard]] Result<void> write(std::span<const std::uint8_t> bytes);
    /// Closes the descriptor, so that a caller can keep many unfinished files. Afterwards nothing
    /// can be written or synced; only finish() with BestEffort may follow. Errors: InputOutput, if
    /// the file system reports a failed write as late as this.
    [[nodiscard]] Result<void> close();
    /// Renames the file to its final name. Errors: InputOutput; the old file then stays.
    [[nodiscard]] Result<void> finish(Durability durability = Durability::BestEffort);

  private:
    UnfinishedFile(std::string name, FileTarget target) noexcept;

    std::string name_;   ///< the final name as the caller gave it, for messages
    std::string target_; ///< the final name after symbolic links were followed
    std::string hidden_; ///< empty after finish() or a move
    UniqueFd fd_;
};

/// Calls `make` with a new hidden name in the folder of `path`, until one of them is free, at most
/// 100 times. `make` returns whether it succeeded, and leaves EEXIST in errno if the name is taken.
/// Errors: InputOutput.
[[nodiscard]] Result<std::string>
make_beside(const std::string& path, const std::function<bool(const std::string& hidden)>& make);

} // namespace raymarch
