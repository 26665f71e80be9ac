// SPDX-License-Identifier: MIT
#include "daemon/reopener.hpp"

#include <utility>

namespace raymarch::daemon
{

Reopener::Reopener(EventLoop& loop, std::string_view what, std::function<void()> look,
                   std::string_view then, Now now)
    : what_(what)
    , then_(then)
    , now_(std::move(now))
    , timer_(loop.add_timer(std::move(look)))
{}

void Reopener::missing(const Error& problem)
{
    tell({problem.message}, log::Level::Warning, then_);
    look_later();
}

void Reopener::found()
{
    told_.clear(); // a later loss is to be logged again
    some_found();
}

void Reopener::lost()
{
    some_lost();
    look_later();
}

void Reopener::tell(std::set<std::string> problems, log::Level level, std::string_view then)
{
    std::string fresh;
    for (const std::string& problem : problems)
        if (!told_.contains(problem))
            fresh += (fresh.empty() ? "" : "; ") + problem;
    told_ = std::move(problems);
    if (!fresh.empty())
        log::line(level, "{}: {}; {}", what_, fresh, then);
}

void Reopener::look_later()
{
    wait_ = back_off_.next();
    timer_->arm(wait_);
}

void Reopener::look_anew()
{
    back_off_.reset();
    look_now();
}

} // namespace raymarch::daemon
