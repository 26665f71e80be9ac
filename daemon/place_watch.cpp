// SPDX-License-Identifier: MIT
#include "daemon/place_watch.hpp"

#include "base/log.hpp"

#include <sys/inotify.h>

#include <cstdint>
#include <filesystem>
#include <utility>

namespace raymarch::daemon
{

PlaceWatch::PlaceWatch(EventLoop& loop, std::function<void()> look)
    : loop_(loop)
    , look_(loop.add_timer(std::move(look)))
{}

/// The handler only arms a timer: what the timer does may destroy the source, which the source's
/// own handler must not do.
void PlaceWatch::watch(const std::string& path)
{
    const std::filesystem::path place = std::filesystem::absolute(path);
    constexpr std::uint32_t changes = IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                      IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
    watch_ = loop_.add_inotify(
        place.parent_path().c_str(), changes,
        [this, name = place.filename().string()](const inotify_event& event) {
            if (event.len == 0 || name == event.name) // NOLINT(*-array-to-pointer-decay): C's
                look_->arm({});
        });
    if (const auto problem = loop_.take_problem())
        log::info("{}: it will not be noticed when it is removed: {}", path, problem->message);
    look_->arm({}); // something may have changed before the watch began
}

} // namespace raymarch::daemon
