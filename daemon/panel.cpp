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

/// How often LEDs are looked after, and inputs that do not report edges.
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
    , again_(loop, "buttons, switches and LEDs", [this] { look_for_lines(); })
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
            static_cast<void>(line.pin->write(false)); // nobody is left to be told
}

void Panel::start()
{
    if (!lines_.empty())
        look_for_lines();
}

// --- finding and losing lines ---

void Panel::look_for_lines()
{
    if (drop_failed_lines()) // what is found and lost in turns is not to keep the loop busy
        return again_.look_later();
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
        again_.some_found();
    }
    no_chip = no_chip && !any_chip;
    if (no_chip) { // most likely it is no board: that is worth no warning
        again_.tell(problems, log::Level::Info, "one that comes is used");
    } else {
        again_.tell(problems);
        arrivals_.reset();
    }
    if (!problems.empty() && !(no_chip && wait_for_chip()))
        again_.look_later();
    if (std::ranges::any_of(lines_, [](const Line& line) { return line.pin != nullptr; }))
        tick_->arm({});
}

/// Most machines without a chip never get one: looking for it would wake them for nothing. On a
/// board a driver or an overlay may bring it late.
bool Panel::wait_for_chip()
{
    if (arrivals_)
        return true;
    arrivals_ = loop_.add_inotify(devices_.c_str(), IN_CREATE | IN_MOVED_TO,
                                  [this](const inotify_event& event) {
                                      const std::string_view name(event.len > 0 ? event.name : "");
                                      if (!name.starts_with("gpiochip") && !name.empty())
                                          return;
                                      again_.look_anew();
                                  });
    if (loop_.take_problem()) {
        arrivals_.reset();
        return false;
    }
    again_.look_now(); // one may have come since the look
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

/// A button that is held already is not pressed; a switch stands where it stands.
void Panel::watch(Line& line, bool level)
{
    line.debouncer = drivers::Debouncer(gpio_.debounce, level);
    line.settled = loop_.add_timer([this, &line] { settle(line); });
    line.repeat = loop_.add_timer([this, &line] { repeat(line); });
    if (line.pin->edge_fd() >= 0)
        line.edges = loop_.add_io(line.pin->edge_fd(), EPOLLIN,
                                  [this, &line](std::uint32_t) { take_edges(line); });
    if (const auto problem = loop_.take_problem())
        return lose(line, *problem);
    if (line.action.kind == ActionKind::Switch)
        act(line, level);
}

/// Only noted here, because this may run in a handler of the line's own.
void Panel::lose(Line& line, const Error& error)
{
    if (!std::exchange(line.failed, true))
        log::warning("the line of {} has gone away: {}; it will be looked for", line.action.name,
                     error.message);
    again_.look_now();
}

/// A switch stays as it was last seen; a button that is gone is held no more.
bool Panel::drop_failed_lines()
{
    bool any = false;
    for (Line& line : lines_) {
        if (!line.failed)
            continue;
        line.edges.reset();
        line.settled.reset();
        line.repeat.reset();
        line.pin.reset();
        line.failed = false;
        again_.some_lost();
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
            return lose(line, edge.error());
        if (!*edge)
            break;
        act(line, line.debouncer.edge((*edge)->level, (*edge)->at));
        line.settled->arm(gpio_.debounce);
    }
}

/// The timer may come before edges that wait, which arm it again.
void Panel::settle(Line& line)
{
    if (line.failed)
        return;
    if (const auto waiting = line.pin->take_edge(); waiting && *waiting) {
        act(line, line.debouncer.edge((*waiting)->level, (*waiting)->at));
        line.settled->arm(gpio_.debounce);
        return take_edges(line);
    }
    sample(line);
}

/// What the line reads now counts.
void Panel::sample(Line& line)
{
    const auto level = line.pin->read();
    if (!level)
        return lose(line, level.error());
    act(line, line.debouncer.quiet(*level));
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

/// Armed again from now, not from when it was due: what takes longer than a step slows it down.
void Panel::repeat(Line& line)
{
    const auto* const behaviour = std::get_if<Repeat>(&line.action.behaviour);
    if (behaviour == nullptr || !line.debouncer.level() || line.failed)
        return;
    behaviour->step(controller_);
    line.repeat->arm(std::chrono::milliseconds(1000 / gpio_.*behaviour->rate));
}

// --- LEDs ---

Glance Panel::glance()
{
    return {.uptime = std::chrono::duration_cast<std::chrono::milliseconds>(
                std::chrono::steady_clock::now() - started_),
            .accepted = accepted_.look(controller_.applied()),
            .refused = controller_.last_refused(),
            .hardware = board_.health(),
            .colour = protocol::colour_bits(controller_.accelerator(), controller_.state())};
}

void Panel::tick()
{
    const Glance now = glance();
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

void Panel::show(Line& line, const Glance& now)
{
    const bool lit = std::get<Show>(line.action.behaviour)(now);
    if (line.shown == lit)
        return;
    if (const auto written = line.pin->write(lit); !written)
        return lose(line, written.error());
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
