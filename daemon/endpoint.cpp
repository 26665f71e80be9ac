// SPDX-License-Identifier: MIT
#include "daemon/endpoint.hpp"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <span>
#include <utility>

namespace raymarch::daemon
{
namespace
{

/// The events are edge-triggered, because a pseudo-terminal without a host reports a hang-up all
/// the time.
constexpr std::uint32_t for_reading = EPOLLIN | EPOLLET;
constexpr std::uint32_t for_both = for_reading | EPOLLOUT;

/// After this time without progress the host counts as not reading. A tty reports room in pieces of
/// 256 bytes, which take 2.1 s at 1200 baud.
constexpr std::chrono::milliseconds send_timeout{2500};

} // namespace

Endpoint::Endpoint(EventLoop& loop, Turns& turns, Rank rank,
                   std::unique_ptr<drivers::BytePort> port, Controller& controller,
                   std::function<void(Endpoint&)> on_gone)
    : port_(std::move(port))
    , session_(controller)
    , on_gone_(std::move(on_gone))
    , turn_(turns, rank, [this](const TurnIsOver& over) { return take_turn(over); })
    , send_timer_(loop.add_timer([this] { send_timed_out(); }))
    , source_(loop.add_io(port_->fd(), for_reading, [this](std::uint32_t) { turn_.ready(); }))
{}

bool Endpoint::take_turn(const TurnIsOver& turn_is_over)
{
    if (session_.busy())
        read_ahead(); // finds a hang-up, so that the next host does not get the reply
    send();           // makes room in the queue for new replies
    for (;;) {
        switch (session_.step(input_, turn_is_over)) {
        case Step::Done:
            send();
            break;
        case Step::Hungry:
            send(); // an echo does not wait for the end of the line
            if (end_ == End::None ? !read() : !finish_input())
                return false;
            break;
        case Step::Full:
            start_send_timer(); // the last send() left too little room
            return false;
        case Step::Waits:
            read_ahead(); // a UART goes on receiving while a disk works
            return false;
        }
        if (turn_is_over())
            return true;
    }
}

/// Returns whether anything has come. Precondition: there is room in the buffer.
bool Endpoint::read()
{
    if (input_.data() != buffer_.data())
        std::copy(input_.begin(), input_.end(), buffer_.begin());
    const std::span<char> room = std::span(buffer_).subspan(input_.size());
    const drivers::ReadOutcome outcome = port_->read(room);
    input_ = {buffer_.data(), input_.size()};
    switch (outcome.status) {
    case drivers::ReadStatus::Data:
        input_ = {buffer_.data(), input_.size() + outcome.size};
        last_heard_ = std::chrono::steady_clock::now();
        return true;
    case drivers::ReadStatus::HungUp:
        end_ = End::HungUp;
        session_.set_reads(false);
        return true;
    case drivers::ReadStatus::Gone:
        end_ = End::Gone;
        return true;
    case drivers::ReadStatus::Empty:
        return false;
    }
    return false;
}

/// Reads bytes of the next lines while the present line is not done.
void Endpoint::read_ahead()
{
    while (end_ == End::None && input_.size() < buffer_.size() && read()) {
    }
}

bool Endpoint::busy() const
{
    int unread = 0;
    return session_.busy() || !input_.empty() ||
           (::ioctl(port_->fd(), FIONREAD, &unread) == 0 && unread > 0);
}

bool Endpoint::has_gone() const
{
    pollfd port = {.fd = port_->fd(), .events = 0, .revents = 0};
    return ::poll(&port, 1, 0) > 0 && (port.revents & (POLLHUP | POLLERR)) != 0;
}

/// Handles the end of the input after all lines before it. Returns whether there is more to do.
bool Endpoint::finish_input()
{
    if (end_ == End::HungUp) {
        session_.hang_up();
        end_ = End::None; // the next host may have sent something already
        return true;
    }
    if (session_.output().pending().empty())
        leave();
    else
        start_send_timer(); // a host that has closed its sending side may still read
    return false;
}

void Endpoint::send()
{
    if (end_ == End::HungUp)
        return; // the present host has asked nothing
    OutputQueue& output = session_.output();
    while (!output.pending().empty()) {
        const std::size_t sent = port_->write(output.pending());
        if (sent == 0)
            break;
        output.pop(sent);
        progress_ = true;
        last_heard_ = std::chrono::steady_clock::now();
        session_.set_reads(true);
    }
    const bool wait = !output.pending().empty();
    if (wait == waits_for_room_)
        return;
    waits_for_room_ = wait;
    source_->watch(wait ? for_both : for_reading);
}

void Endpoint::start_send_timer()
{
    if (send_timer_runs_)
        return;
    send_timer_runs_ = true;
    progress_ = false;
    send_timer_->arm(send_timeout);
}

void Endpoint::send_timed_out()
{
    send_timer_runs_ = false;
    if (!progress_) {
        session_.set_reads(false);
        if (end_ == End::Gone)
            session_.drop_output();
    }
    turn_.ready();
}

void Endpoint::leave()
{
    const auto on_gone = std::move(on_gone_); // the call may destroy this endpoint
    on_gone(*this);
}

} // namespace raymarch::daemon
