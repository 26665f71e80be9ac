// SPDX-License-Identifier: MIT
/// @file
/// The lines of standard input, from a person at a line editor or as plain bytes.
#pragma once

#include "base/result.hpp"
#include "cli/completions.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace raymarch::cli
{

class TypedLines
{
  public:
    TypedLines() = default;
    TypedLines(const TypedLines&) = delete;
    TypedLines& operator=(const TypedLines&) = delete;
    virtual ~TypedLines() = default;

    /// The next line without its LF, all other bytes as they came; nothing at the end, and when
    /// `stop_fd` became readable. Errors: InputOutput.
    [[nodiscard]] virtual Result<std::optional<std::string>> next() = 0;
};

/// Reads bytes as they come, lines of any length. The last line may have no ending. `prompt` is
/// printed before each line.
[[nodiscard]] std::unique_ptr<TypedLines> plain_lines(int stop_fd, std::string prompt);

/// A line editor at the terminal, with completion, and a history that is written to `history` when
/// it ends. The terminal is as before between two lines. nullptr where the locale C.UTF-8 is
/// missing, without which the editor would drop bytes, or where the terminal cannot be set up.
[[nodiscard]] std::unique_ptr<TypedLines>
edited_lines(int stop_fd, std::string prompt, std::string history,
             std::function<Completion(std::string_view before)> complete);

} // namespace raymarch::cli
