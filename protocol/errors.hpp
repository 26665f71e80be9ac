// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every code that an ERR reply can carry, and the fault that leads to one.
#pragma once

#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

enum class ErrorCode : std::uint8_t {
    TooLong,
    BadByte,
    Checksum,
    Syntax,
    UnknownKey,
    DuplicateKey,
    Number,
    Range,
    Object,
    MissingKey,
    Basis,
    UnknownCommand,
    Argument,
    Hardware,
    Locked,
    Busy,
    Storage,
};

struct ErrorRow
{
    ErrorCode code;
    std::string_view name;    ///< the code as the reply has it
    std::string_view meaning; ///< the mistake of the sender, or the failure of the service
};

// Laid out by hand: one row a code.
// clang-format off
inline constexpr std::array errors = {
    ErrorRow{ErrorCode::TooLong,        "TOO_LONG",        "the line is longer than 1024 bytes; it was dropped up to its ending"},
    ErrorRow{ErrorCode::BadByte,        "BAD_BYTE",        "a byte other than 0x20-0x7E and TAB"},
    ErrorRow{ErrorCode::Checksum,       "CHECKSUM",        "the line's *HH is no hex number, or not the XOR of the bytes before the *, or is missing where it is required"},
    ErrorRow{ErrorCode::Syntax,         "SYNTAX",          "not KEY=VALUE pairs joined by commas"},
    ErrorRow{ErrorCode::UnknownKey,     "UNKNOWN_KEY",     "no parameter has this key"},
    ErrorRow{ErrorCode::DuplicateKey,   "DUPLICATE_KEY",   "the key stands twice in the line"},
    ErrorRow{ErrorCode::Number,         "NUMBER",          "not a decimal number of at most 32 characters"},
    ErrorRow{ErrorCode::Range,          "RANGE",           "the number is outside its parameter's range"},
    ErrorRow{ErrorCode::Object,         "OBJECT",          "not one of the names, nor the digit of one"},
    ErrorRow{ErrorCode::MissingKey,     "MISSING_KEY",     "a frame names every parameter; key= lists those that are missing"},
    ErrorRow{ErrorCode::Basis,          "BASIS",           "forward, right and up are not of length 1 and at right angles within 0.01, and basis_check is reject"},
    ErrorRow{ErrorCode::UnknownCommand, "UNKNOWN_COMMAND", "no command has this name"},
    ErrorRow{ErrorCode::Argument,       "ARGUMENT",        "a command's words are wrong or missing"},
    ErrorRow{ErrorCode::Hardware,       "HARDWARE",        "there is no register block, or it read back something else than was written"},
    ErrorRow{ErrorCode::Locked,         "LOCKED",          "writes are locked by a switch on the board"},
    ErrorRow{ErrorCode::Busy,           "BUSY",            "another host has switched the accelerator before WALK, TURN or LOAD was done, or all places for clients are taken"},
    ErrorRow{ErrorCode::Storage,        "STORAGE",         "there is no state file, or it cannot be read or written"},
};
// clang-format on

inline constexpr std::size_t error_count = errors.size();

[[nodiscard]] constexpr const ErrorRow& error_row(ErrorCode code) noexcept
{
    return errors[static_cast<std::size_t>(code)];
}

namespace detail
{
consteval bool error_rows_in_order()
{
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (static_cast<std::size_t>(errors[i].code) != i)
            return false;
    return true;
}
static_assert(error_rows_in_order());
} // namespace detail

struct ArgumentRow; // protocol/commands.hpp

/// The first fault of a line. It holds all that an ERR reply says.
struct Fault
{
    ErrorCode code = ErrorCode::Syntax;
    std::size_t column = 0; ///< counted from 1; 0 if it is not known
    std::optional<ParameterIndex> parameter{};
    std::string_view word{};    ///< an unknown key or command, as written; points into the line
    ParameterSet missing{};     ///< the keys that are missing, for MissingKey
    std::string_view allowed{}; ///< a static sentence in place of the code's own meaning
    const ArgumentRow* argument = nullptr; ///< whose bounds the sentence gives instead
};

} // namespace raymarch::protocol
