// SPDX-License-Identifier: MIT
/// @file
/// What this project needs of libgpiod, whose series 1 and 2 have different interfaces: one file
/// for each of the two has these functions, and CMake takes the one that fits what is installed.
///
/// They throw std::system_error or another std::exception, as libgpiod does; guarded() turns that
/// into an Error. Chips are opened by their paths.
#pragma once

#include "base/result.hpp"
#include "drivers/gpio_line.hpp"
#include "drivers/line_spec.hpp"
#include "drivers/ports.hpp"

#include <poll.h>

#include <cerrno>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>

namespace raymarch::drivers
{

/// The name under which the kernel shows the lines that are in use.
inline constexpr const char* gpio_consumer = "raymarchd";

/// The offset of the chip's line of that name; nothing when it has none.
[[nodiscard]] std::optional<unsigned> find_named_line(const std::string& chip,
                                                      const std::string& name);

[[nodiscard]] std::string label_of_chip(const std::string& chip);

/// Requests the line at `offset` as open_gpio_line() promises; `name` is for messages.
[[nodiscard]] std::unique_ptr<Pin> request_line(const std::string& chip, unsigned offset,
                                                const LineSpec& spec, LineUse use,
                                                const std::string& name);

/// Whether an edge can be taken without waiting; false for a line without edges, whose fd is -1.
[[nodiscard]] inline bool edge_waits(int edge_fd) noexcept
{
    pollfd waiting = {.fd = edge_fd, .events = POLLIN, .revents = 0};
    return edge_fd >= 0 && ::poll(&waiting, 1, 0) > 0;
}

/// Whether the kernel refused edges because the line has no interrupt: such a line is polled.
[[nodiscard]] inline bool has_no_interrupt(const std::system_error& error) noexcept
{
    return error.code().value() == ENODEV || error.code().value() == ENXIO;
}

/// Calls `action`; what it throws is an error of that kind, about `subject`.
template <typename Action>
auto guarded(ErrorKind kind, const std::string& subject, Action action)
    -> Result<decltype(action())>
{
    try {
        if constexpr (std::is_void_v<decltype(action())>) {
            action();
            return {};
        } else {
            return action();
        }
    } catch (const std::system_error& error) {
        const int number = error.code().value();
        return fail(Error{kind, number, subject + ": " + std::generic_category().message(number)});
    } catch (const std::exception& error) { // an offset beyond the chip is std::out_of_range
        return fail(plain_error(kind, subject + ": " + error.what()));
    }
}

} // namespace raymarch::drivers
