// SPDX-License-Identifier: MIT
#include "daemon/reopener.hpp"

#include <utility>

namespace raymarch::daemon
{

Reopener::Reopener(EventLoop& loop, std::string_view what, std::function<void()> retry,
                   std::string_view outlook, Now now)
    : what_(what)
    , outlook_(outlook)
    , now_(std::move(now))
    , timer_(loop.add_timer(std::move(retry)))
{}

void Reopener::missing(const Error& problem)
{
    log_new({problem.message}, log::Level::Warning, outlook_);
    retry_later();
}

void Reopener::found()
{
    logged_.clear(); // a later loss is logged again
    some_found();
}

void Reopener::lost()
{
    some_lost();
    retry_later();
}

void Reopener::log_new(std::set<std::string> problems, log::Level level, std::string_view outlook)
{
    std::string fresh;
    for (const std::string& problem : problems)
        if (!logged_.contains(problem))
            fresh += (fresh.empty() ? "" : "; ") + problem;
    logged_ = std::move(problems);
    if (!fresh.empty())
        log::line(level, "{}: {}; {}", what_, fresh, outlook);
}

void Reopener::retry_later()
{
    wait_ = back_off_.next();
    timer_->arm(wait_);
}

void Reopener::start_again()
{
    back_off_.reset();
    retry_now();
}

} // namespace raymarch::daemon
