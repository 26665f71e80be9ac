// SPDX-License-Identifier: MIT
#include "daemon/output_queue.hpp"

#include <algorithm>
#include <utility>

namespace raymarch::daemon
{

bool OutputQueue::push(std::string_view bytes) noexcept
{
    if (bytes.size() > room())
        return false;
    std::copy(bytes.begin(), bytes.end(), bytes_.data() + size_);
    size_ += bytes.size();
    return true;
}

bool OutputQueue::push_reply(std::string_view reply) noexcept
{
    if (!push(reply))
        return false;
    ends_[(first_ + replies_) % ends_.size()] = sent_ + static_cast<std::uint32_t>(size_);
    ++replies_;
    return true;
}

void OutputQueue::pop(std::size_t count) noexcept
{
    std::copy(bytes_.data() + count, bytes_.data() + size_, bytes_.data());
    size_ -= count;
    sent_ += static_cast<std::uint32_t>(count);
    // A reply that is not completely sent ends 1 to bytes_.size() bytes after sent_. For a reply
    // that is completely sent, the subtraction wraps to a larger number.
    while (replies_ > 0 && ends_[first_] - sent_ - 1 >= bytes_.size()) {
        first_ = (first_ + 1) % ends_.size();
        --replies_;
    }
}

std::size_t OutputQueue::clear() noexcept
{
    sent_ += static_cast<std::uint32_t>(std::exchange(size_, 0));
    return std::exchange(replies_, 0);
}

} // namespace raymarch::daemon
