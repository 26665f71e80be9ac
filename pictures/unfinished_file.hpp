// SPDX-License-Identifier: MIT
/// @file
/// What is being written stands beside its final name, under a hidden name of its own, until it is
/// whole: nobody finds half a film, and what is abandoned is gone.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace raymarch::pictures
{

/// Owns the hidden file or folder; it goes with its owner. It stands in the folder of the final
/// name, so that a rename suffices, and has its ending, by which writers know the format.
class Unfinished
{
  public:
    /// An empty file. Errors: InputOutput, naming the final name.
    [[nodiscard]] static Result<Unfinished> file(const std::string& final_path);
    /// An empty folder.
    [[nodiscard]] static Result<Unfinished> folder(const std::string& final_path);

    Unfinished(Unfinished&&) noexcept = default;
    Unfinished& operator=(Unfinished&& other) noexcept;
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
    ~Unfinished();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

  private:
    explicit Unfinished(std::string path) : path_(std::move(path)) {}

    std::string path_; ///< empty when moved from
};

/// Renames a whole file to its final name, over what has it now.
[[nodiscard]] Result<void> publish(const std::string& from, const std::string& final_path);

/// A file that is written piece by piece; errors name it as `name`.
class OutputFile
{
  public:
    [[nodiscard]] static Result<OutputFile> open(const std::string& path, std::string name);
    [[nodiscard]] Result<void> write(std::span<const std::uint8_t> bytes);
    [[nodiscard]] Result<void> close(); ///< what was held back may fail here

  private:
    struct Close
    {
        void operator()(std::FILE* file) const noexcept
        {
            static_cast<void>(std::fclose(file)); // abandoned: what it says does not matter
        }
    };
    using File = std::unique_ptr<std::FILE, Close>;
    OutputFile(File file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

    File file_;
    std::string name_;
};

} // namespace raymarch::pictures
