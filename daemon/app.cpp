// SPDX-License-Identifier: MIT
#include "daemon/app.hpp"

#include "drivers/device_tree_overlay.hpp"
#include "drivers/fpga_manager.hpp"
#include "drivers/logic_loader.hpp"
#include "drivers/pseudo_terminal.hpp"
#include "drivers/serial_port.hpp"

#include <sys/epoll.h>
#include <systemd/sd-daemon.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <utility>

namespace raymarch::daemon
{
namespace
{

/// The state is written at most this often.
constexpr std::chrono::milliseconds persist_interval{2000};
constexpr std::size_t max_clients = 16;

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
std::string logic_state(const drivers::KernelTree& tree)
{
    const auto manager = drivers::find_fpga_manager(tree);
    std::string state = manager ? manager->state : "none";
    std::ranges::replace(state, ' ', '_');
    return state;
}

using PortResult = Result<std::unique_ptr<drivers::BytePort>>;

struct SerialOpener
{
    PortResult operator()(const NoSerial&) const { return nullptr; }
    PortResult operator()(const SerialDevice& where) const
    {
        return drivers::SerialPort::open(where.path, where.baud);
    }
    PortResult operator()(const PseudoTerminalLink& where) const
    {
        return drivers::PseudoTerminal::open(where.link);
    }
};

} // namespace

App::App(Config config, Reload reload, EventLoop& loop)
    : loop_(loop)
    , config_(std::move(config))
    , reload_(std::move(reload))
    , persist_timer_(loop.add_timer([this] { persist(); }))
    , animate_timer_(loop.add_timer([this] { animate(); }))
    , hardware_(config_, loop, [this] { controller_.board_is_back(hardware_.accelerator()); })
    , controller_(*config_.accelerator, policy_of(config_), hardware_, *this, *this, random_seed())
    , panel_(config_.gpio, loop, controller_, hardware_, drivers::open_gpio_line)
    , retry_serial_(loop.add_timer([this] { open_serial(); }))
    , retry_control_(loop.add_timer([this] { open_control(); }))
{
    controller_.on_animate([this](unsigned rate) {
        const bool running = std::exchange(animate_rate_, rate) > 0;
        if (rate > 0 && !running)
            animate_timer_->arm(std::chrono::milliseconds{0});
    });
    if (!config_.state.empty())
        store_.emplace(config_.state);
}

App::~App() = default;

Result<void> App::run()
{
    for (const int number : {SIGTERM, SIGINT})
        signals_.push_back(loop_.add_signal(number, [this] { loop_.quit(); }));
    signals_.push_back(loop_.add_signal(SIGHUP, [this] { reload_config(); }));

    restore_state(); // before the hardware, which asks for the state as soon as it is found
    hardware_.start();
    open_serial();
    panel_.start();
    open_control();
    if (loop_.feed_watchdog())
        log::info("the watchdog is fed from the event loop");
    sd_notify(0, "READY=1");
    log::notice("ready: {}", config_.accelerator->name);

    auto result = loop_.run();
    sd_notify(0, "STOPPING=1");
    if (store_ && (persist_waits_ || store_->behind()))
        static_cast<void>(store_->write_now(persisted_)); // a failure has been logged
    return result;
}

void App::log_once(std::string& last, const Error& error, const char* what)
{
    if (error.message != last)
        log::warning("{}: {}; it will be tried again", what, error.message);
    last = error.message;
}

// --- the persisted state ---

void App::restore_state()
{
    if (!store_)
        return;
    auto loaded = store_->load();
    if (loaded) {
        persisted_ = *loaded;
    } else if (loaded.error().kind == ErrorKind::Unavailable) {
        log::info("no state from earlier: {}", loaded.error().message);
    } else {
        log::warning("starting from the defaults: {}", loaded.error().message);
    }
    if (const auto state = last(controller_.accelerator()))
        static_cast<void>(controller_.restore(*state)); // the board comes later
}

void App::changed(const Accelerator& accelerator, const State& state)
{
    persisted_.of(accelerator).last = state;
    if (!store_ || persist_waits_)
        return;
    persist_waits_ = true;
    persist_timer_->arm(persist_interval);
}

void App::persist()
{
    persist_waits_ = false;
    if (store_)
        store_->write_later(persisted_);
}

bool App::save(const Accelerator& accelerator, const State& state)
{
    if (!store_)
        return false;
    PersistedStates both = persisted_;
    both.of(accelerator) = {.last = state, .saved = state};
    if (both == persisted_ && !persist_waits_ && !store_->behind() && store_->load())
        return true; // the file holds it
    if (!store_->write_now(both))
        return false;
    persisted_ = both;
    return true;
}

std::optional<protocol::State> App::load(const Accelerator& accelerator)
{
    if (!store_)
        return std::nullopt;
    auto loaded = store_->load();
    if (!loaded)
        return std::nullopt;
    const PersistedState& state = loaded->of(accelerator);
    return state.saved ? state.saved : state.last;
}

std::optional<protocol::State> App::last(const Accelerator& accelerator)
{
    return persisted_.of(accelerator).last;
}

// --- hosts ---

void App::open_serial()
{
    auto port = std::visit(SerialOpener{}, config_.serial);
    if (!port) {
        log_once(serial_problem_, port.error(), "no serial host");
        retry_serial_->arm(serial_back_off_.next());
        return;
    }
    if (*port == nullptr)
        return;
    serial_problem_.clear();
    serial_back_off_.opened();
    serial_.emplace(loop_, std::move(*port), controller_, [this](Endpoint& gone) {
        log::warning("the serial port has gone away; it will be looked for");
        dropped_before_ += gone.session().dropped_replies();
        serial_.reset();
        serial_back_off_.lost();
        retry_serial_->arm(serial_back_off_.next());
    });
}

void App::open_control()
{
    if (config_.control.empty())
        return;
    if (!listener_) {
        auto listener = drivers::SocketListener::open(config_.control);
        if (!listener) {
            log_once(control_problem_, listener.error(), "no control socket");
            retry_control_->arm(control_back_off_.next());
            return;
        }
        listener_.emplace(std::move(*listener));
        control_problem_.clear();
        control_back_off_.reset();
    }
    accept_ = loop_.add_io(listener_->fd(), EPOLLIN, [this](std::uint32_t) { accept_client(); });
}

void App::accept_client()
{
    auto port = listener_->accept();
    if (!port) { // the client waits on, and would wake the loop again and again
        log_once(control_problem_, port.error(), "control socket");
        accept_.reset();
        retry_control_->arm(control_back_off_.next());
        return;
    }
    if (*port == nullptr)
        return;
    if (clients_.size() >= max_clients) {
        log::warning("a client was turned away: there are {} already", max_clients);
        return;
    }
    clients_.emplace_back(loop_, std::move(*port), controller_, [this](Endpoint& gone) {
        dropped_before_ += gone.session().dropped_replies();
        clients_.remove_if([&](const Endpoint& client) { return &client == &gone; });
    });
}

// --- the rest ---

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

void App::write_status(protocol::ReplyWriter& reply)
{
    const bool wants_serial = !std::holds_alternative<NoSerial>(config_.serial);
    std::uint64_t dropped = dropped_before_;
    if (serial_)
        dropped += serial_->session().dropped_replies();
    for (const Endpoint& client : clients_)
        dropped += client.session().dropped_replies();
    const auto uptime = std::chrono::duration_cast<std::chrono::seconds>(
        std::chrono::steady_clock::now() - started_);

    reply << " serial=" << (serial_ ? "up" : wants_serial ? "down" : "none");
    if (serial_)
        reply << " hang_ups=" << serial_->session().hang_ups();
    hardware_.write_status(reply);
    panel_.write_status(reply);
    const drivers::KernelTree tree(config_.sysfs_root);
    reply << " logic=" << logic_state(tree)
          << " overlay=" << to_text(overlay_state(tree, drivers::overlay_name))
          << " clients=" << std::uint64_t{clients_.size()} << " dropped_replies=" << dropped
          << " uptime=" << static_cast<std::uint64_t>(uptime.count());
}

} // namespace raymarch::daemon
