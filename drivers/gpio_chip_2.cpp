// SPDX-License-Identifier: MIT
/// @file
/// Uses libgpiod 2 (Debian 13).
#include "drivers/gpio_chip.hpp"

#include <gpiod.hpp>

#include <chrono>
#include <cstdint>
#include <utility>

namespace raymarch::drivers
{
namespace
{

gpiod::line::bias bias_of(Pull pull) noexcept
{
    switch (pull) {
    case Pull::AsIs:
        return gpiod::line::bias::AS_IS;
    case Pull::Up:
        return gpiod::line::bias::PULL_UP;
    case Pull::Down:
        return gpiod::line::bias::PULL_DOWN;
    case Pull::None:
        return gpiod::line::bias::DISABLED;
    }
    return gpiod::line::bias::AS_IS;
}

gpiod::line_settings settings_of(const LineSpec& spec, LineUse use)
{
    gpiod::line_settings settings;
    settings.set_active_low(spec.active_low);
    settings.set_bias(bias_of(spec.pull));
    settings.set_direction(use == LineUse::Output ? gpiod::line::direction::OUTPUT
                                                  : gpiod::line::direction::INPUT);
    settings.set_output_value(gpiod::line::value::INACTIVE);
    return settings;
}

gpiod::line_request request(gpiod::chip& chip, unsigned offset,
                            const gpiod::line_settings& settings)
{
    return chip.prepare_request()
        .set_consumer(gpio_consumer)
        .add_line_settings(offset, settings)
        .do_request();
}

class GpioLine final : public Pin
{
  public:
    GpioLine(gpiod::line_request request, unsigned offset, std::string name, int edge_fd)
        : request_(std::move(request))
        , offset_(offset)
        , name_(std::move(name))
        , edge_fd_(edge_fd)
        , edges_(1)
    {}

    [[nodiscard]] Result<bool> read() override
    {
        return guarded(ErrorKind::InputOutput, name_,
                       [&] { return request_.get_value(offset_) == gpiod::line::value::ACTIVE; });
    }

    [[nodiscard]] Result<void> write(bool on) override
    {
        return guarded(ErrorKind::InputOutput, name_, [&] {
            request_.set_value(offset_,
                               on ? gpiod::line::value::ACTIVE : gpiod::line::value::INACTIVE);
        });
    }

    [[nodiscard]] int edge_fd() const noexcept override { return edge_fd_; }

    [[nodiscard]] Result<std::optional<Edge>> take_edge() override
    {
        if (!edge_waits(edge_fd_))
            return std::optional<Edge>();
        return guarded(ErrorKind::InputOutput, name_, [&] {
            request_.read_edge_events(edges_, 1);
            const gpiod::edge_event& event = edges_.get_event(0);
            const auto since_boot = static_cast<std::int64_t>(event.timestamp_ns().ns());
            return std::optional(
                Edge{.level = event.type() == gpiod::edge_event::event_type::RISING_EDGE,
                     .at = std::chrono::nanoseconds{since_boot}});
        });
    }

  private:
    gpiod::line_request request_; ///< its destructor releases the line
    unsigned offset_;
    std::string name_;
    int edge_fd_;
    gpiod::edge_event_buffer edges_;
};

} // namespace

std::optional<unsigned> find_named_line(const std::string& chip, const std::string& name)
{
    const int offset = gpiod::chip(chip).get_line_offset_from_name(name);
    return offset >= 0 ? std::optional(static_cast<unsigned>(offset)) : std::nullopt;
}

std::string label_of_chip(const std::string& chip)
{
    return gpiod::chip(chip).get_info().label();
}

std::unique_ptr<Pin> request_line(const std::string& chip, unsigned offset, const LineSpec& spec,
                                  LineUse use, const std::string& name)
{
    gpiod::chip opened(chip);
    gpiod::line_settings settings = settings_of(spec, use);
    if (use == LineUse::Output)
        return std::make_unique<GpioLine>(request(opened, offset, settings), offset, name, -1);
    try {
        settings.set_edge_detection(gpiod::line::edge::BOTH);
        gpiod::line_request with_edges = request(opened, offset, settings);
        const int fd = with_edges.fd();
        return std::make_unique<GpioLine>(std::move(with_edges), offset, name, fd);
    } catch (const std::system_error& error) {
        if (!has_no_interrupt(error))
            throw;
    }
    settings.set_edge_detection(gpiod::line::edge::NONE);
    return std::make_unique<GpioLine>(request(opened, offset, settings), offset, name, -1);
}

} // namespace raymarch::drivers
