// SPDX-License-Identifier: MIT
#include "daemon/output_queue.hpp"

#include <algorithm>

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

void OutputQueue::pop(std::size_t count) noexcept
{
    const std::string_view sent = pending().substr(0, count);
    const std::size_t end = sent.rfind('\n');
    const std::string_view cut = end == std::string_view::npos ? sent : sent.substr(end + 1);
    if (end != std::string_view::npos || cut_line_ == 0)
        cut_line_ = cut.empty() ? '\0' : cut.front();
    std::copy(bytes_.data() + count, bytes_.data() + size_, bytes_.data());
    size_ -= count;
}

/// The last line of each reply begins with OK or ERR.
std::size_t OutputQueue::clear() noexcept
{
    std::size_t replies = cut_line_ == 'O' || cut_line_ == 'E' ? 1 : 0;
    std::string_view rest = pending();
    if (cut_line_ != 0)
        rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
    while (!rest.empty()) {
        replies += rest.starts_with("OK") || rest.starts_with("ERR") ? 1 : 0;
        rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
    }
    size_ = 0;
    cut_line_ = 0;
    return replies;
}

} // namespace raymarch::daemon
