// SPDX-License-Identifier: MIT
/// @file
/// Reads the lines of standard input, with or without a line editor.
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

    /// Returns the next line without its LF. Returns nothing at the end, and if `stop_fd` is
    /// readable. Errors: InputOutput.
    [[nodiscard]] virtual Result<std::optional<std::string>> next() = 0;
};

/// Reads lines of any length without an editor. The last line may have no ending. `prompt` is
/// printed before each line.
[[nodiscard]] std::unique_ptr<TypedLines> plain_lines(int stop_fd, std::string prompt);

/// Reads lines with an editor at the terminal. The history is written to the file `history` at the
/// end. Returns nullptr if the terminal cannot be set up, or if the locale C.UTF-8 is missing, so
/// that the editor would drop bytes.
[[nodiscard]] std::unique_ptr<TypedLines>
edited_lines(int stop_fd, std::string prompt, std::string history,
             std::function<Completion(std::string_view before)> complete);

} // namespace raymarch::cli
