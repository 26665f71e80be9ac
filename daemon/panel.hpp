// SPDX-License-Identifier: MIT
/// @file
/// Buttons, switches and LEDs in the event loop. The panel opens the configured lines, opens
/// missing lines again later, debounces presses and acts on them, and updates the LEDs.
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
    /// The type of drivers::open_gpio_line(). A test gives another function.
    using Opener = std::function<Result<std::unique_ptr<drivers::Pin>>(const drivers::LineSpec&,
                                                                       drivers::LineUse)>;

    /// The chips appear in the folder `devices`.
    Panel(const Gpio& gpio, EventLoop& loop, Controller& controller, Board& board, Opener open,
          std::string devices = "/dev");
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
    /// Turns off the LEDs.
    ~Panel();

    /// Opens all lines. Missing lines are tried again with a back-off, or, if the machine has no
    /// chip, when a chip appears.
    void start();

    void write_status(protocol::StatusValues& status) const;

  private:
    struct Line
    {
        Line(const Action& what, const drivers::LineSpec& where) : action(what), spec(where) {}

        const Action& action;
        const drivers::LineSpec& spec;
        std::unique_ptr<drivers::Pin> pin; ///< null if the line is missing
        bool failed = false;               ///< the pin cannot be used any more
        std::optional<bool> shown;         ///< the last state of an LED
        drivers::Debouncer debouncer{{}, false};
        Source edges;
        Source settle_timer;
        Source repeat_timer;
    };

    void open_missing_lines();
    /// Returns false if the folder cannot be watched.
    [[nodiscard]] bool watch_for_chip();
    [[nodiscard]] Result<void> open(Line& line);
    void watch(Line& line, bool level);
    /// Returns whether there was one.
    bool drop_failed_lines();
    void mark_failed(Line& line, const Error& error);

    void take_edges(Line& line);
    void settle(Line& line);
    void act(Line& line, std::optional<bool> level);
    void repeat(Line& line);

    void tick();
    void sample(Line& line);
    void show(Line& line, const PanelStatus& now);
    [[nodiscard]] PanelStatus status();

    const Gpio& gpio_;
    EventLoop& loop_;
    Controller& controller_;
    Board& board_;
    Opener open_;
    const std::string devices_;
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();

    drivers::Blinker accepted_blinker_;
    Reopener reopener_;
    std::list<Line> lines_;
    Source tick_;
    Source chip_watch_; ///< set only while there is no chip
};

} // namespace raymarch::daemon
