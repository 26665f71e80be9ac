// SPDX-License-Identifier: MIT
/// @file
/// The only file that knows libgpiod (1.6; its successor has another interface). What it throws
/// ends here.
///
/// Chips are listed from sysfs and opened by their paths: libgpiod's own search reads /dev with
/// 32-bit offsets, which fails where a 32-bit program runs on a 64-bit file system.
#include "drivers/gpio_line.hpp"

#include <gpiod.hpp>
#include <poll.h>

#include <algorithm>
#include <bitset>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* consumer = "raymarchd";
constexpr const char* chips_folder = "/sys/bus/gpio/devices";

std::vector<std::string> chip_paths()
{
    std::vector<std::string> paths;
    std::error_code ignored; // no such folder: no chip
    for (const fs::directory_entry& entry : fs::directory_iterator(chips_folder, ignored))
        paths.push_back("/dev/" + entry.path().filename().string());
    std::ranges::sort(paths);
    return paths;
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

gpiod::chip open_chip(const std::string& path)
{
    return gpiod::chip(path, gpiod::chip::OPEN_BY_PATH);
}

Error missing(std::string message)
{
    return plain_error(ErrorKind::Unavailable, std::move(message));
}

/// The first line for which `look` finds one. A chip that cannot be opened is passed over, and
/// named when no other has the line.
template <typename Look>
Result<gpiod::line> search(const std::string& what, Look look)
{
    const std::vector<std::string> paths = chip_paths();
    if (paths.empty())
        return fail(Error{ErrorKind::Unavailable, ENODEV, "there is no GPIO chip"});
    std::string refused;
    for (const std::string& path : paths) {
        auto line = guarded(ErrorKind::Unavailable, path, [&] { return look(open_chip(path)); });
        if (!line)
            refused = " (" + line.error().message + ")";
        else if (static_cast<bool>(line.value()))
            return line;
    }
    return fail(missing("no GPIO " + what + refused));
}

Result<gpiod::line> find(const LinePlace& place)
{
    if (place.chip.empty())
        return search("line is named " + place.name,
                      [&](const gpiod::chip& chip) { return chip.find_line(place.name); });
    const auto line_of = [&](const gpiod::chip& chip) { return chip.get_line(place.offset); };
    const std::string subject = "GPIO line " + to_string(place);
    if (place.chip.starts_with('/'))
        return guarded(ErrorKind::Unavailable, subject,
                       [&] { return line_of(open_chip(place.chip)); });
    auto of_label = search("chip has the label " + place.chip, [&](const gpiod::chip& chip) {
        return chip.label() == place.chip ? chip.get_line(0) : gpiod::line();
    });
    if (!of_label)
        return of_label;
    return guarded(ErrorKind::Unavailable, subject, [&] { return line_of(of_label->get_chip()); });
}

std::bitset<32> flags_of(const LineSpec& spec)
{
    const std::bitset<32> polarity =
        spec.active_low ? gpiod::line_request::FLAG_ACTIVE_LOW : std::bitset<32>();
    switch (spec.pull) {
    case Pull::AsIs:
        return polarity;
    case Pull::Up:
        return polarity | gpiod::line_request::FLAG_BIAS_PULL_UP;
    case Pull::Down:
        return polarity | gpiod::line_request::FLAG_BIAS_PULL_DOWN;
    case Pull::None:
        return polarity | gpiod::line_request::FLAG_BIAS_DISABLE;
    }
    return polarity;
}

class GpioLine final : public Pin
{
  public:
    GpioLine(gpiod::line line, std::string name, int edge_fd)
        : line_(std::move(line))
        , name_(std::move(name))
        , edge_fd_(edge_fd)
    {}

    [[nodiscard]] Result<bool> read() override
    {
        return guarded(ErrorKind::InputOutput, name_, [&] { return line_.get_value() != 0; });
    }

    [[nodiscard]] Result<void> write(bool on) override
    {
        return guarded(ErrorKind::InputOutput, name_, [&] { line_.set_value(on ? 1 : 0); });
    }

    [[nodiscard]] int edge_fd() const noexcept override { return edge_fd_; }

    [[nodiscard]] Result<std::optional<Edge>> take_edge() override
    {
        pollfd waiting = {.fd = edge_fd_, .events = POLLIN, .revents = 0};
        if (edge_fd_ < 0 || ::poll(&waiting, 1, 0) <= 0) // reading would wait
            return std::optional<Edge>();
        return guarded(ErrorKind::InputOutput, name_, [&] {
            const gpiod::line_event event = line_.event_read();
            return std::optional(Edge{.level = event.event_type == gpiod::line_event::RISING_EDGE,
                                      .at = event.timestamp});
        });
    }

  private:
    gpiod::line line_; ///< releases the line with its chip
    std::string name_;
    int edge_fd_;
};

void request(const gpiod::line& line, int type, const LineSpec& spec)
{
    line.request({consumer, type, flags_of(spec)});
}

std::unique_ptr<Pin> request_input(const gpiod::line& line, const std::string& name,
                                   const LineSpec& spec)
{
    try {
        request(line, gpiod::line_request::EVENT_BOTH_EDGES, spec);
        return std::make_unique<GpioLine>(line, name, line.event_get_fd());
    } catch (const std::system_error& error) {
        if (error.code().value() != ENODEV) // the kernel's word for: no interrupt
            throw;
    }
    request(line, gpiod::line_request::DIRECTION_INPUT, spec);
    return std::make_unique<GpioLine>(line, name, -1);
}

Result<std::unique_ptr<Pin>> open_place(const LinePlace& place, const LineSpec& spec, LineUse use)
{
    const auto line = find(place);
    if (!line)
        return fail(line.error());
    const std::string name = "GPIO line " + to_string(place);
    return guarded(ErrorKind::Unavailable, name, [&]() -> std::unique_ptr<Pin> {
        if (use == LineUse::Input)
            return request_input(*line, name, spec);
        request(*line, gpiod::line_request::DIRECTION_OUTPUT, spec);
        return std::make_unique<GpioLine>(*line, name, -1);
    });
}

} // namespace

Result<std::unique_ptr<Pin>> open_gpio_line(const LineSpec& spec, LineUse use)
{
    Error problem = missing("");
    for (const LinePlace& place : spec.places) {
        auto pin = open_place(place, spec, use);
        if (pin)
            return pin;
        problem.number = pin.error().number;
        problem.message += (problem.message.empty() ? "" : "; ") + pin.error().message;
    }
    return fail(problem);
}

} // namespace raymarch::drivers
