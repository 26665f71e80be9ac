// SPDX-License-Identifier: MIT
#include "daemon/app.hpp"

#include "board/device_tree_overlay.hpp"
#include "board/fpga_manager.hpp"
#include "board/logic_loader.hpp"

#include <systemd/sd-daemon.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <utility>

namespace raymarch::daemon
{
namespace
{

constexpr std::chrono::milliseconds patience_at_the_end{100};

Policy policy_of(const Config& config) noexcept
{
    return {config.basis_check, config.replies, config.require_checksum};
}

std::uint64_t random_seed()
{
    std::random_device device;
    return std::uint64_t{device()} << 32 | device();
}

/// What the FPGA manager says, as one word.
std::string logic_state(const board::KernelTree& tree)
{
    const auto manager = board::find_fpga_manager(tree);
    std::string state = manager ? manager->state : "none";
    std::ranges::replace(state, ' ', '_');
    return state;
}

} // namespace

App::App(Config config, Reload reload, EventLoop& loop)
    : loop_(loop)
    , config_(std::move(config))
    , reload_(std::move(reload))
    , stored_(loop,
              [this] {
                  control_->resume();
                  serial_->resume();
              })
    , store_(config_.state, [this] { stored_.notify(); })
    , animate_timer_(loop.add_timer([this] { animate(); }))
    , hardware_(config_, loop, [this] { controller_.board_is_back(hardware_.accelerator()); })
    , controller_(*config_.accelerator, policy_of(config_), hardware_, store_, *this, random_seed())
    , panel_(std::in_place, config_.gpio, loop, controller_, hardware_, drivers::open_gpio_line)
    , turns_(loop)
    , serial_(std::in_place, config_.serial, loop, turns_, controller_)
    , control_(std::in_place, config_, loop, turns_, controller_)
{
    controller_.on_animate([this](unsigned rate) {
        const bool running = std::exchange(animate_rate_, rate) > 0;
        if (rate > 0 && !running)
            animate_timer_->arm(std::chrono::milliseconds{0});
    });
}

App::~App() = default;

Result<void> App::run()
{
    for (const int number : {SIGTERM, SIGINT})
        signals_.push_back(loop_.add_signal(number, [this] { loop_.quit(); }));
    signals_.push_back(loop_.add_signal(SIGHUP, [this] { reload_config(); }));
    if (const auto problem =
            loop_.take_problem()) // timers and signals are what all else is built on
        return fail(*problem);

    if (auto locked = store_.lock(); !locked)
        return locked;
    // Before the hardware, which asks for the state as soon as it is found.
    store_.read();
    if (const auto state = store_.last(controller_.accelerator()))
        static_cast<void>(controller_.restore(*state)); // the board comes later
    if (auto started = hardware_.start(); !started)
        return started;
    serial_->open();
    panel_->start();
    control_->open();
    if (loop_.feed_watchdog())
        log::info("the watchdog is fed from the event loop");
    sd_notify(0, "READY=1");
    log::notice("ready: {}; registers: {}; serial: {}; control: {}", controller_.accelerator().name,
                hardware_.place(), serial_->place(), control_->place());

    auto result = loop_.run();
    sd_notify(0, "STOPPING=1");
    // What others see ends in any case; what is being drawn is not waited for.
    control_.reset();
    serial_.reset();
    panel_.reset();
    store_.finish();
    drawing_has_ended_ = hardware_.end_drawing(patience_at_the_end);
    return result;
}

/// Armed again from now, not from when it was due: a picture that takes longer than a step slows
/// the animation down and leaves time for the hosts.
void App::animate()
{
    if (animate_rate_ == 0)
        return;
    animate_timer_->arm(std::chrono::milliseconds{1000 / animate_rate_});
    controller_.animate();
}

void App::reload_config()
{
    sd_notifyf(0, "RELOADING=1\nMONOTONIC_USEC=%lld",
               static_cast<long long>(std::chrono::duration_cast<std::chrono::microseconds>(
                                          std::chrono::steady_clock::now().time_since_epoch())
                                          .count()));
    if (const auto fresh = reload_(); fresh) {
        // Devices stay as they were opened: changing those takes a restart.
        config_.basis_check = fresh->basis_check;
        config_.replies = fresh->replies;
        config_.require_checksum = fresh->require_checksum;
        controller_.set_policy(policy_of(config_));
        log::set_level(fresh->log_level);
        log::notice("configuration read again");
    } else {
        log::error("the configuration stays as it was: {}", fresh.error().message);
    }
    sd_notify(0, "READY=1");
}

void App::write_status(protocol::StatusValues& status)
{
    using protocol::StatusKey;
    const auto uptime = std::chrono::duration_cast<std::chrono::seconds>(
        std::chrono::steady_clock::now() - started_);
    const board::KernelTree tree(config_.sysfs_root);

    serial_->write_status(status);
    hardware_.write_status(status);
    panel_->write_status(status);
    status.put(StatusKey::Logic, logic_state(tree));
    status.put(StatusKey::Overlay, to_text(overlay_state(tree, board::overlay_name)));
    status.put(StatusKey::Clients, control_->clients());
    status.put(StatusKey::DroppedReplies, serial_->dropped_replies() + control_->dropped_replies());
    status.put(StatusKey::Uptime, static_cast<std::uint64_t>(uptime.count()));
}

} // namespace raymarch::daemon
