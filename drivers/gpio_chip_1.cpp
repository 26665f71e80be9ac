// SPDX-License-Identifier: MIT
/// @file
/// Uses libgpiod 1.6 (Debian 12, Ubuntu 22.04 and 24.04).
#include "drivers/gpio_chip.hpp"

#include <gpiod.hpp>

#include <bitset>
#include <utility>

namespace raymarch::drivers
{
namespace
{

gpiod::chip open_chip(const std::string& path)
{
    return gpiod::chip(path, gpiod::chip::OPEN_BY_PATH);
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
        if (!edge_waits(edge_fd_))
            return std::optional<Edge>();
        return guarded(ErrorKind::InputOutput, name_, [&] {
            const gpiod::line_event event = line_.event_read();
            return std::optional(Edge{.level = event.event_type == gpiod::line_event::RISING_EDGE,
                                      .at = event.timestamp});
        });
    }

  private:
    gpiod::line line_; ///< its destructor releases the line
    std::string name_;
    int edge_fd_;
};

void request(const gpiod::line& line, int type, const LineSpec& spec)
{
    line.request({gpio_consumer, type, flags_of(spec)});
}

} // namespace

std::optional<unsigned> find_named_line(const std::string& chip, const std::string& name)
{
    const gpiod::line line = open_chip(chip).find_line(name);
    return line ? std::optional(line.offset()) : std::nullopt;
}

std::string label_of_chip(const std::string& chip)
{
    return open_chip(chip).label();
}

std::unique_ptr<Pin> request_line(const std::string& chip, unsigned offset, const LineSpec& spec,
                                  LineUse use, const std::string& name)
{
    const gpiod::line line = open_chip(chip).get_line(offset);
    if (use == LineUse::Output) {
        request(line, gpiod::line_request::DIRECTION_OUTPUT, spec);
        return std::make_unique<GpioLine>(line, name, -1);
    }
    try {
        request(line, gpiod::line_request::EVENT_BOTH_EDGES, spec);
        return std::make_unique<GpioLine>(line, name, line.event_get_fd());
    } catch (const std::system_error& error) {
        if (!has_no_interrupt(error))
            throw;
    }
    request(line, gpiod::line_request::DIRECTION_INPUT, spec);
    return std::make_unique<GpioLine>(line, name, -1);
}

} // namespace raymarch::drivers
