// SPDX-License-Identifier: MIT
#include "daemon/session.hpp"

#include <algorithm>

namespace raymarch::daemon
{

bool OutputQueue::push(std::string_view bytes) noexcept
{
    if (bytes.size() > bytes_.size() - size_)
        return false;
    std::copy(bytes.begin(), bytes.end(), bytes_.data() + size_);
    size_ += bytes.size();
    return true;
}

void OutputQueue::pop(std::size_t count) noexcept
{
    std::copy(bytes_.data() + count, bytes_.data() + size_, bytes_.data());
    size_ -= count;
}

void Session::receive(std::string_view bytes)
{
    while (!bytes.empty()) {
        if (settings_.echo) {
            receive_typed(bytes);
            continue;
        }
        // ECHO on takes effect with the next line, in the same chunk or not.
        const auto line = reader_.next(bytes);
        if (!line)
            return;
        execute(*line);
    }
}

void Session::receive_typed(std::string_view& bytes)
{
    const protocol::Typed typed = editor_.type(bytes.front());
    bytes.remove_prefix(1);
    output_.push(typed.echo);
    if (!typed.line_ended)
        return;
    const std::string_view line = editor_.line();
    const bool too_long = line.size() > protocol::max_line_length;
    execute({.bytes = too_long ? std::string_view() : line, .too_long = too_long});
}

void Session::execute(const protocol::Line& line)
{
    const std::string_view reply = controller_.execute(line, settings_);
    if (!reply.empty() && !output_.push(reply))
        ++dropped_replies_;
}

void Session::hang_up() noexcept
{
    reader_.reset();
    editor_.reset();
    output_.clear();
    settings_ = {};
    ++hang_ups_;
}

} // namespace raymarch::daemon
