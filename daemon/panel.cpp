// SPDX-License-Identifier: MIT
#include "daemon/panel.hpp"

#include "base/log.hpp"
#include "protocol/views.hpp"

#include <sys/epoll.h>
#include <sys/inotify.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace raymarch::daemon
{
namespace
{

/// LEDs are updated, and inputs without edges are sampled, once in this time.
constexpr std::chrono::milliseconds tick_interval{50};

} // namespace

Panel::Panel(const Gpio& gpio, EventLoop& loop, Controller& controller, Board& board, Opener open,
             std::string devices)
    : gpio_(gpio)
    , loop_(loop)
    , controller_(controller)
    , board_(board)
    , open_(std::move(open))
    , devices_(std::move(devices))
    , reopener_(loop, "buttons, switches and LEDs", [this] { open_missing_lines(); })
    , tick_(loop.add_timer([this] { tick(); }))
{
    for (std::size_t i = 0; gpio.used && i < gpio.lines.size(); ++i)
        if (gpio.lines[i])
            lines_.emplace_back(actions()[i], *gpio.lines[i]);
}

Panel::~Panel()
{
    for (Line& line : lines_)
        if (line.pin && line.action.kind == ActionKind::Led)
            static_cast<void>(line.pin->write(false)); // an error is of no interest any more
}

void Panel::start()
{
    if (!lines_.empty())
        open_missing_lines();
}

// --- finding and losing lines ---

void Panel::open_missing_lines()
{
    if (drop_failed_lines()) // a line that fails again and again must not keep the loop busy
        return reopener_.retry_later();
    std::set<std::string> problems;
    bool no_chip = false;
    bool any_chip = false;
    for (Line& line : lines_) {
        if (line.pin)
            continue;
        if (const auto opened = open(line); !opened) {
            problems.insert(opened.error().message);
            const int number = opened.error().number;
            no_chip = no_chip || number == ENODEV;
            any_chip = any_chip || (number != ENODEV && number != ENOENT); // no such path
            continue;
        }
        reopener_.some_found();
    }
    no_chip = no_chip && !any_chip;
    if (no_chip) { // this machine is probably not a board, so there is no warning
        reopener_.log_new(problems, log::Level::Info, "a chip that appears later is used");
    } else {
        reopener_.log_new(problems);
        chip_watch_.reset();
    }
    if (!problems.empty() && !(no_chip && watch_for_chip()))
        reopener_.retry_later();
    if (std::ranges::any_of(lines_, [](const Line& line) { return line.pin != nullptr; }))
        tick_->arm({});
}

/// Most machines without a chip never get one, so polling would be useless. On a board, a driver or
/// an overlay may add a chip late.
bool Panel::watch_for_chip()
{
    if (chip_watch_)
        return true;
    chip_watch_ = loop_.add_inotify(
        devices_.c_str(), IN_CREATE | IN_MOVED_TO, [this](const inotify_event& event) {
            const std::string_view name(event.len > 0 ? event.name : "");
            if (!name.starts_with("gpiochip") && !name.empty())
                return;
            reopener_.start_again();
        });
    if (loop_.take_problem()) {
        chip_watch_.reset();
        return false;
    }
    reopener_.retry_now(); // a chip may have appeared before the watch
    return true;
}

Result<void> Panel::open(Line& line)
{
    const bool led = line.action.kind == ActionKind::Led;
    auto pin = open_(line.spec, led ? drivers::LineUse::Output : drivers::LineUse::Input);
    if (!pin)
        return fail(pin.error());
    if (led) {
        line.pin = std::move(*pin);
        line.shown.reset();
        return {};
    }
    const auto level = (*pin)->read();
    if (!level)
        return fail(level.error());
    line.pin = std::move(*pin);
    watch(line, *level);
    return {};
}

/// A button that is already held does not count as pressed. A switch acts with its present level.
void Panel::watch(Line& line, bool level)
{
    line.debouncer = drivers::Debouncer(gpio_.debounce, level);
    line.settle_timer = loop_.add_timer([this, &line] { settle(line); });
    line.repeat_timer = loop_.add_timer([this, &line] { repeat(line); });
    if (line.pin->edge_fd() >= 0)
        line.edges = loop_.add_io(line.pin->edge_fd(), EPOLLIN,
                                  [this, &line](std::uint32_t) { take_edges(line); });
    if (const auto problem = loop_.take_problem())
        return mark_failed(line, *problem);
    if (line.action.kind == ActionKind::Switch)
        act(line, level);
}

/// Only marks the line, because this function may run in a handler of the line.
void Panel::mark_failed(Line& line, const Error& error)
{
    if (!std::exchange(line.failed, true))
        log::warning("the line of {} has gone away: {}; it will be looked for", line.action.name,
                     error.message);
    reopener_.retry_now();
}

/// A lost switch keeps its last level; a lost button counts as released.
bool Panel::drop_failed_lines()
{
    bool any = false;
    for (Line& line : lines_) {
        if (!line.failed)
            continue;
        line.edges.reset();
        line.settle_timer.reset();
        line.repeat_timer.reset();
        line.pin.reset();
        line.failed = false;
        reopener_.some_lost();
        any = true;
    }
    return any;
}

// --- buttons and switches ---

void Panel::take_edges(Line& line)
{
    while (!line.failed) {
        const auto edge = line.pin->take_edge();
        if (!edge)
            return mark_failed(line, edge.error());
        if (!*edge)
            break;
        act(line, line.debouncer.edge((*edge)->level, (*edge)->at));
        line.settle_timer->arm(gpio_.debounce);
    }
}

/// The timer may fire before waiting edges were read; they arm it again.
void Panel::settle(Line& line)
{
    if (line.failed)
        return;
    if (const auto waiting = line.pin->take_edge(); waiting && *waiting) {
        act(line, line.debouncer.edge((*waiting)->level, (*waiting)->at));
        line.settle_timer->arm(gpio_.debounce);
        return take_edges(line);
    }
    sample(line);
}

void Panel::sample(Line& line)
{
    const auto level = line.pin->read();
    if (!level)
        return mark_failed(line, level.error());
    act(line, line.debouncer.sample(*level));
}

void Panel::act(Line& line, std::optional<bool> level)
{
    if (!level || line.failed)
        return;
    const auto& behaviour = line.action.behaviour;
    if (const auto* const follow = std::get_if<Follow>(&behaviour))
        (*follow)(controller_, *level);
    if (!*level)
        return;
    if (const auto* const press = std::get_if<Press>(&behaviour))
        (*press)(controller_);
    if (std::holds_alternative<Repeat>(behaviour))
        repeat(line);
}

/// The timer is armed from now and not from when it was due, so a slow step delays the next ones.
void Panel::repeat(Line& line)
{
    const auto* const behaviour = std::get_if<Repeat>(&line.action.behaviour);
    if (behaviour == nullptr || !line.debouncer.level() || line.failed)
        return;
    behaviour->step(controller_);
    line.repeat_timer->arm(std::chrono::milliseconds(1000 / gpio_.*behaviour->rate));
}

// --- LEDs ---

PanelStatus Panel::status()
{
    return {.uptime = std::chrono::duration_cast<std::chrono::milliseconds>(
                std::chrono::steady_clock::now() - started_),
            .accepted = accepted_blinker_.sample(controller_.applied()),
            .refused = controller_.last_refused(),
            .hardware = board_.health(),
            .colour = protocol::colour_bits(controller_.accelerator(), controller_.state())};
}

void Panel::tick()
{
    const PanelStatus now = status();
    bool any = false;
    for (Line& line : lines_) {
        if (!line.pin || line.failed)
            continue;
        any = true;
        if (line.action.kind == ActionKind::Led)
            show(line, now);
        else if (line.pin->edge_fd() < 0)
            sample(line);
    }
    if (any)
        tick_->arm(tick_interval);
}

void Panel::show(Line& line, const PanelStatus& now)
{
    const bool lit = std::get<Show>(line.action.behaviour)(now);
    if (line.shown == lit)
        return;
    if (const auto written = line.pin->write(lit); !written)
        return mark_failed(line, written.error());
    line.shown = lit;
}

void Panel::write_status(protocol::StatusValues& status) const
{
    const auto there = std::ranges::count_if(
        lines_, [](const Line& line) { return line.pin != nullptr && !line.failed; });
    const auto all = static_cast<std::ptrdiff_t>(lines_.size());
    status.put(protocol::StatusKey::Gpio, all == 0       ? "none"
                                          : there == all ? "up"
                                          : there > 0    ? "partial"
                                                         : "down");
}

} // namespace raymarch::daemon
