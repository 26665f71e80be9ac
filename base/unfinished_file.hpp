// SPDX-License-Identifier: MIT
/// @file
/// A file that is being written stands beside its final name, under a hidden name of its own, until
/// it is whole: nobody finds half of it, and what is abandoned is gone.
///
/// All that is written as a whole goes this way: pictures, films, captures, the state.
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

/// Owns the hidden file; it goes with its owner unless it was finished. Several may be written for
/// one final name at once, also by several processes: the one that is finished last stays.
///
/// A final name that is a symbolic link stays one, and the file that it leads to is replaced. The
/// new file has the permissions of the old one (read, write, execute and the access list, no
/// set-id bits) and, where this is permitted, its owner and group; it never has more readers. A
/// file that is new has what the process's umask leaves of 0666. Other names of the old file (hard
/// links) keep the old content.
class UnfinishedFile
{
  public:
    /// Errors: InputOutput, naming the final name: it is there and no ordinary file, or must not be
    /// written; its folder is missing or takes no file. Where `hidden_folder` is given, a folder on
    /// the same file system, the file waits in there; but beside its final place if that is behind
    /// a link, which may lead anywhere.
    [[nodiscard]] static Result<UnfinishedFile> open(const std::string& final_path,
                                                     const std::string& hidden_folder = {});

    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;
    ~UnfinishedFile();

    /// The hidden name, with the final one's ending, for an encoder that opens the file by itself.
    [[nodiscard]] const std::string& path() const noexcept { return hidden_; }

    /// Appends. Errors: InputOutput.
    [[nodiscard]] Result<void> write(std::span<const std::uint8_t> bytes);
    /// Closes the descriptor, so that a caller can keep many unfinished files. Only finish() with
    /// BestEffort may follow: nothing can be written or synced any more. Errors: InputOutput, when
    /// the file system reports only now that a write failed.
    [[nodiscard]] Result<void> close();
    /// Puts the file in its place. Errors: InputOutput; what was there before stays.
    [[nodiscard]] Result<void> finish(Durability durability = Durability::BestEffort);

  private:
    UnfinishedFile(std::string name, FileTarget target) noexcept;

    std::string name_;   ///< as the caller knows it, for messages
    std::string target_; ///< behind the links
    std::string hidden_; ///< empty: finished, or moved from
    UniqueFd fd_;
};

/// Makes something under a new hidden name in the folder of `path`. `make` says whether it did, and
/// leaves EEXIST in errno where that name is taken. Errors: InputOutput.
[[nodiscard]] Result<std::string>
make_beside(const std::string& path, const std::function<bool(const std::string& hidden)>& make);

} // namespace raymarch
