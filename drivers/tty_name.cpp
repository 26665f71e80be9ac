// SPDX-License-Identifier: MIT
#include "drivers/tty_name.hpp"

#include "drivers/serial_port.hpp"

#include <algorithm>
#include <charconv>

namespace raymarch::drivers
{
namespace
{

bool is_digit(char c) noexcept
{
    return c >= '0' && c <= '9';
}

bool is_space(char c) noexcept
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

Error refuse(std::string_view text, const std::string& reason)
{
    return plain_error(ErrorKind::Usage,
                       "'" + std::string(text) + "' is not /dev/TTY[@BAUD]: " + reason);
}

/// Returns 0, which is not a baud rate, if the number is too large.
unsigned number(std::string_view digits) noexcept
{
    unsigned value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return parsed.ec == std::errc{} ? value : 0;
}

} // namespace

Result<TtyName> parse_tty_name(std::string_view text)
{
    TtyName name{.path = std::string(text)};
    const std::size_t at = text.rfind('@');
    const bool has_rate =
        at != std::string_view::npos && text.find('/', at) == std::string_view::npos;
    if (has_rate) {
        const std::string_view rate = text.substr(at + 1);
        name.path = text.substr(0, at);
        if (rate.empty())
            return fail(refuse(text, "no baud rate follows the @"));
        if (!std::ranges::all_of(rate, is_digit))
            return fail(
                refuse(text, "'" + std::string(rate) +
                                 "' is not a baud rate; if the last part of the path has an "
                                 "@, add a rate, such as @115200"));
        name.baud = number(rate);
        if (!is_baud_rate(name.baud))
            return fail(plain_error(ErrorKind::Usage, "'" + std::string(rate) +
                                                          "' is not a baud rate; the rates are " +
                                                          baud_rates()));
    }
    if (name.path.empty())
        return fail(refuse(text, "there is no path"));
    if (is_space(name.path.front()) || is_space(name.path.back()))
        return fail(refuse(text, "the path begins or ends with a blank"));
    return name;
}

} // namespace raymarch::drivers
