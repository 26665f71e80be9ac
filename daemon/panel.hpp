// SPDX-License-Identifier: MIT
/// @file
/// Buttons, switches and LEDs in the event loop: lines opened as the configuration maps them and
/// looked for again when they are missing, presses debounced and acted on, LEDs kept up to date.
#pragma once

#include "daemon/actions.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/reopener.hpp"
#include "drivers/debouncer.hpp"
#include "drivers/gpio_line.hpp"
#include "drivers/led_patterns.hpp"
#include "drivers/ports.hpp"

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

namespace raymarch::daemon
{

class Panel
{
  public:
    /// drivers::open_gpio_line, or a test's.
    using Opener = std::function<Result<std::unique_ptr<drivers::Pin>>(const drivers::LineSpec&,
                                                                       drivers::LineUse)>;

    /// `devices` is the folder in which the chips appear.
    Panel(const Gpio& gpio, EventLoop& loop, Controller& controller, Board& board, Opener open,
          std::string devices = "/dev");
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
    /// The LEDs go dark.
    ~Panel();

    /// Looks for all lines now; for those that are missing, again and again, or where the machine
    /// has no chip at all, as soon as one appears.
    void start();

    void write_status(protocol::StatusValues& status) const;

  private:
    /// One line that an action is mapped to.
    struct Line
    {
        Line(const Action& what, const drivers::LineSpec& where) : action(what), spec(where) {}

        const Action& action;
        const drivers::LineSpec& spec;
        std::unique_ptr<drivers::Pin> pin; ///< null: it is not there
        bool failed = false;               ///< pin is of no use any more
        std::optional<bool> shown;         ///< of an LED: what it was told last
        drivers::Debouncer debouncer{{}, false};
        Source edges;
        Source settled;
        Source repeat;
    };

    void look_for_lines();
    /// False when that cannot be told; true until look_for_lines() finds a chip.
    [[nodiscard]] bool wait_for_chip();
    [[nodiscard]] Result<void> open(Line& line);
    void watch(Line& line, bool level);
    /// Whether there was one.
    bool drop_failed_lines();
    void lose(Line& line, const Error& error);

    void take_edges(Line& line);
    void settle(Line& line);
    void act(Line& line, std::optional<bool> level);
    void repeat(Line& line);

    void tick();
    void sample(Line& line);
    void show(Line& line, const Glance& now);
    [[nodiscard]] Glance glance();

    const Gpio& gpio_;
    EventLoop& loop_;
    Controller& controller_;
    Board& board_;
    Opener open_;
    const std::string devices_;
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();

    drivers::Blinker accepted_;
    Reopener again_;
    std::list<Line> lines_;
    Source tick_;
    Source arrivals_; ///< of chips; only while there is none
};

} // namespace raymarch::daemon
