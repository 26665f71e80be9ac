// SPDX-License-Identifier: MIT
#include "daemon/actions.hpp"

#include "drivers/led_patterns.hpp"

#include <algorithm>

namespace raymarch::daemon
{
namespace
{

constexpr std::array<std::string_view, 3> kind_names = {"button", "switch", "LED"};

constexpr Follow lock = [](Controller& controller, bool on) { controller.set_locked(on); };
constexpr Press orbit_left = [](Controller& controller) { controller.orbit(Side::Left); };
constexpr Press orbit_right = [](Controller& controller) { controller.orbit(Side::Right); };

template <std::size_t Channel>
constexpr Show colour = [](const PanelStatus& now) noexcept { return now.colour[Channel]; };
constexpr Show dark = [](const PanelStatus& /*now*/) noexcept { return false; };

using enum ActionKind;

// The table is formatted by hand: each action has one row.
// clang-format off
constexpr std::array table = {
    Action{"reset",        Button, "btn0",   "BTN0",       "resets all parameters to their defaults", Press([](Controller& controller) { controller.to_defaults(); })},
    Action{"next_scene",   Button, "btn1",   "BTN1",       "shows the next scene, or the next preset if the accelerator has only one scene", Press([](Controller& controller) { controller.to_next_scene(); })},
    Action{"orbit_left",   Button, "btn2",   "BTN2",       "turns the camera to the left while it is held, gpio_orbit_rate steps a second", Repeat{&Gpio::orbit_rate, orbit_left}},
    Action{"orbit_right",  Button, "btn3",   "BTN3",       "turns the camera to the right while it is held, gpio_orbit_rate steps a second", Repeat{&Gpio::orbit_rate, orbit_right}},
    Action{"lock",         Switch, "sw0",    "SW0",        "locks the parameters: hosts get ERR LOCKED for lines that would write; they can still read, and the buttons still work", lock},
    Action{"turn",         Switch, "sw1",    "SW1",        "turns the camera by itself, gpio_turn_rate steps a second", Repeat{&Gpio::turn_rate, orbit_right}},
    Action{"heartbeat",    Led,    "led0",   "LD0",        "beats twice a second while the service runs", Show([](const PanelStatus& now) noexcept { return drivers::heartbeat(now.uptime); })},
    Action{"accepted",     Led,    "led1",   "LD1",        "blinks when a frame or another line that writes was accepted", Show([](const PanelStatus& now) noexcept { return now.accepted; })},
    Action{"refused",      Led,    "led2",   "LD2",        "is lit while the last frame was refused, or while the hardware is absent or faulty", Show([](const PanelStatus& now) noexcept { return now.refused || now.hardware.fault; })},
    Action{"running",      Led,    "led3",   "LD3",        "is lit while the accelerator draws, or, if it does not report that, while it is present", Show([](const PanelStatus& now) noexcept { return now.hardware.running; })},
    Action{"colour_red",   Led,    "led4_r", "LD4, red",   "is lit while red of the set colour is in the upper half of its range", colour<0>},
    Action{"colour_green", Led,    "led4_g", "LD4, green", "is lit while green of the set colour is in the upper half of its range", colour<1>},
    Action{"colour_blue",  Led,    "led4_b", "LD4, blue",  "is lit while blue of the set colour is in the upper half of its range", colour<2>},
    Action{"dark_red",     Led,    "led5_r", "LD5, red",   "is never lit", dark},
    Action{"dark_green",   Led,    "led5_g", "LD5, green", "is never lit", dark},
    Action{"dark_blue",    Led,    "led5_b", "LD5, blue",  "is never lit", dark},
};
// clang-format on

static_assert(std::ranges::all_of(table, [](const Action& action) {
    return std::holds_alternative<Show>(action.behaviour) == (action.kind == Led);
}));

} // namespace

std::string_view name_of(ActionKind kind) noexcept
{
    return kind_names[static_cast<std::size_t>(kind)];
}

std::span<const Action> actions() noexcept
{
    return table;
}

} // namespace raymarch::daemon
