// SPDX-License-Identifier: MIT
#include "daemon/endpoint.hpp"

#include <sys/epoll.h>

#include <array>

namespace raymarch::daemon
{
namespace
{

/// Edge-triggered: a pseudo-terminal without a host reports a hang-up all the time.
constexpr std::uint32_t for_reading = EPOLLIN | EPOLLET;
constexpr std::uint32_t for_both = for_reading | EPOLLOUT;

/// A host that sends without a pause gives way to the others after this many bytes.
constexpr std::size_t turn_bytes = 16'384;

} // namespace

Endpoint::Endpoint(EventLoop& loop, std::unique_ptr<drivers::BytePort> port, Controller& controller,
                   std::function<void(Endpoint&)> on_gone)
    : port_(std::move(port))
    , session_(controller)
    , on_gone_(std::move(on_gone))
    , source_(
          loop.add_io(port_->fd(), for_reading, [this](std::uint32_t events) { on_ready(events); }))
{}

void Endpoint::on_ready(std::uint32_t /*events*/)
{
    send(); // room first: what was said earlier goes out before new replies need the queue
    if (receive())
        return;
    const auto on_gone = std::move(on_gone_); // it may destroy this endpoint, and itself with it
    on_gone(*this);
}

bool Endpoint::receive()
{
    std::array<char, 4096> chunk; // NOLINT(*-member-init): read before use
    for (std::size_t taken = 0; taken < turn_bytes;) {
        const drivers::ReadOutcome outcome = port_->read(chunk);
        switch (outcome.status) {
        case drivers::ReadStatus::Data:
            last_heard_ = std::chrono::steady_clock::now();
            session_.receive({chunk.data(), outcome.size});
            send();
            taken += outcome.size;
            continue;
        case drivers::ReadStatus::HungUp:
            session_.hang_up();
            continue; // until it is empty: the next host may have spoken already
        case drivers::ReadStatus::Empty:
            return true;
        case drivers::ReadStatus::Gone:
            return false;
        }
    }
    source_->watch(waits_for_room_ ? for_both : for_reading); // reports again what is left
    return true;
}

void Endpoint::send()
{
    OutputQueue& output = session_.output();
    while (!output.pending().empty()) {
        const std::size_t sent = port_->write(output.pending());
        if (sent == 0)
            break;
        output.pop(sent);
    }
    const bool wait = !output.pending().empty();
    if (wait == waits_for_room_)
        return;
    waits_for_room_ = wait;
    source_->watch(wait ? for_both : for_reading);
}

} // namespace raymarch::daemon
