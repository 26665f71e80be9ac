// SPDX-License-Identifier: MIT
#include "base/log.hpp"

#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>

namespace raymarch::log
{
namespace
{

struct Name
{
    std::string_view name;
    Level level;
};
constexpr std::array names = {
    Name{"error", Level::Error}, Name{"warning", Level::Warning}, Name{"notice", Level::Notice},
    Name{"info", Level::Info},   Name{"debug", Level::Debug},
};

std::atomic<Level> threshold = Level::Notice;

/// systemd sets JOURNAL_STREAM for services whose standard error goes to the journal.
bool journal_reads() noexcept
{
    static const bool result =
        std::getenv("JOURNAL_STREAM") != nullptr; // NOLINT(concurrency-mt-unsafe)
    return result;
}

iovec piece(std::string_view text) noexcept
{
    return {const_cast<char*>(text.data()), text.size()}; // NOLINT: writev only reads
}

} // namespace

std::optional<Level> level_named(std::string_view name) noexcept
{
    for (const Name& row : names)
        if (row.name == name)
            return row.level;
    return std::nullopt;
}

void set_level(Level level) noexcept
{
    threshold = level;
}

bool enabled(Level level) noexcept
{
    return level <= threshold.load();
}

void write_line(Level level, std::string_view text) noexcept
{
    const std::array<char, 3> priority = {'<', static_cast<char>('0' + static_cast<int>(level)),
                                          '>'};
    std::string_view prefix = "raymarchd: ";
    if (journal_reads())
        prefix = {priority.data(), priority.size()};
    const std::array parts = {piece(prefix), piece(text), piece("\n")};
    // A log line that cannot be written has nowhere to be reported.
    [[maybe_unused]] const auto written = ::writev(STDERR_FILENO, parts.data(), parts.size());
}

} // namespace raymarch::log
