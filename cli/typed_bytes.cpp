// SPDX-License-Identifier: MIT
#include "cli/typed_bytes.hpp"

#include <array>

namespace raymarch::cli
{
namespace
{

/// The byte b becomes the character private_area + b, in the last private use area of Unicode.
constexpr char32_t private_area = 0x10F000;
constexpr std::size_t private_size = 4; ///< the bytes of such a character in UTF-8

/// The first byte of a character tells how many bytes it has.
struct Form
{
    unsigned char mask;  ///< selects the bits that tell the form
    unsigned char value; ///< the value of these bits
    std::size_t size;
    char32_t smallest; ///< a smaller code must use a shorter form
};
constexpr std::array forms = {
    Form{0x80, 0x00, 1, 0},
    Form{0xE0, 0xC0, 2, 0x80},
    Form{0xF0, 0xE0, 3, 0x800},
    Form{0xF8, 0xF0, 4, 0x10000},
};

constexpr unsigned char byte_at(std::string_view bytes, std::size_t at) noexcept
{
    return static_cast<unsigned char>(bytes[at]);
}

constexpr bool is_private(char32_t code) noexcept
{
    return code >= private_area && code <= private_area + 0xFF;
}

/// Returns whether the editor keeps the character. It treats 0x80 to 0x9F as commands.
constexpr bool is_kept(char32_t code) noexcept
{
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code != 0 && code <= 0x10FFFF && !surrogate && !is_private(code) &&
           (code < 0x80 || code > 0x9F);
}

/// Decodes the first character. Its size is 0 if it is incomplete, and its code is 0 if the bytes
/// are not UTF-8.
TypedCharacter decode(std::string_view bytes) noexcept
{
    for (const Form& form : forms) {
        if ((byte_at(bytes, 0) & form.mask) != form.value)
            continue;
        char32_t code = byte_at(bytes, 0) & static_cast<unsigned char>(~form.mask);
        for (std::size_t i = 1; i < form.size; ++i) {
            if (i == bytes.size())
                return {};
            if ((byte_at(bytes, i) & 0xC0) != 0x80)
                return {.code = 0, .size = 1};
            code = code << 6 | (byte_at(bytes, i) & 0x3F);
        }
        return {.code = code >= form.smallest ? code : 0, .size = form.size};
    }
    return {.code = 0, .size = 1};
}

} // namespace

TypedCharacter typed_character(std::string_view bytes, bool complete) noexcept
{
    const TypedCharacter read = decode(bytes);
    if (read.size == 0 ? !complete : is_kept(read.code))
        return read;
    return {.code = private_area + byte_at(bytes, 0), .size = 1};
}

std::string typed_bytes(std::string_view line)
{
    std::string bytes;
    while (!line.empty()) {
        const char32_t code = decode(line).code;
        const std::size_t size = is_private(code) ? private_size : 1;
        bytes += is_private(code) ? static_cast<char>(code - private_area) : line.front();
        line.remove_prefix(size);
    }
    return bytes;
}

} // namespace raymarch::cli
