// SPDX-License-Identifier: MIT
/// @file
/// Access to libgpiod. Its versions 1 and 2 have different interfaces: gpio_chip_1.cpp and
/// gpio_chip_2.cpp define the same functions, and CMake takes the file for the installed version.
///
/// The functions throw std::system_error or another std::exception, as libgpiod does. guarded()
/// turns an exception into an Error. A chip is opened by its path.
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

/// The kernel shows this name as the user of a line.
inline constexpr const char* gpio_consumer = "raymarchd";

/// Returns the offset of the line on the chip, or nothing if it has no line of that name.
[[nodiscard]] std::optional<unsigned> find_named_line(const std::string& chip,
                                                      const std::string& name);

[[nodiscard]] std::string label_of_chip(const std::string& chip);

/// Requests the line at `offset` for open_gpio_line(); `name` is for messages.
[[nodiscard]] std::unique_ptr<Pin> request_line(const std::string& chip, unsigned offset,
                                                const LineSpec& spec, LineUse use,
                                                const std::string& name);

/// Returns whether an edge can be read without waiting; false if the line has no edges (fd -1).
[[nodiscard]] inline bool edge_waits(int edge_fd) noexcept
{
    pollfd waiting = {.fd = edge_fd, .events = POLLIN, .revents = 0};
    return edge_fd >= 0 && ::poll(&waiting, 1, 0) > 0;
}

/// Returns whether the kernel refused edges because the line has no interrupt. Such a line is
/// polled.
[[nodiscard]] inline bool has_no_interrupt(const std::system_error& error) noexcept
{
    return error.code().value() == ENODEV || error.code().value() == ENXIO;
}

/// Calls `action` and turns an exception into an Error about `subject`.
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
