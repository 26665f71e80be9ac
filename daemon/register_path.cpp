// SPDX-License-Identifier: MIT
#include "daemon/register_path.hpp"

#include "protocol/accelerators.hpp"

#include <fmt/format.h>

#include <utility>

namespace raymarch::daemon
{
namespace
{

using protocol::Register;
namespace control = protocol::control;
namespace status = protocol::status;

drivers::RegOffset at(Register reg) noexcept
{
    return {static_cast<std::uint16_t>(reg)};
}

/// Tests both levels of every bit.
bool scratch_works(drivers::RegisterBus& bus)
{
    for (const std::uint32_t pattern : {0xA5A5'5A5AU, 0x5A5A'A5A5U}) {
        bus.write(at(Register::Scratch), pattern);
        if (bus.read(at(Register::Scratch)) != pattern)
            return false;
    }
    return true;
}

} // namespace

Result<RegisterPath> RegisterPath::probe(drivers::RegisterBus& bus,
                                         const protocol::Accelerator& plain)
{
    if (bus.read(at(Register::Id)) != protocol::id_value)
        return RegisterPath(bus, plain, false);
    if (!scratch_works(bus))
        return fail(plain_error(ErrorKind::Unavailable,
                                "the register block has an ID, but SCRATCH does not hold what is "
                                "written to it"));
    const std::uint8_t kind = protocol::capability_kind(bus.read(at(Register::Capability)));
    const protocol::Accelerator* const accelerator = protocol::find_accelerator(kind);
    if (accelerator == nullptr)
        return fail(plain_error(ErrorKind::Unavailable,
                                fmt::format("CAPABILITY says accelerator kind {}, which this "
                                            "version does not know",
                                            kind)));
    RegisterPath path(bus, *accelerator, true);
    path.enable();
    return path;
}

void RegisterPath::enable()
{
    const std::uint32_t interrupt = bus_->interrupt_fd() >= 0 ? control::interrupt_enable : 0;
    bus_->write(at(Register::Control), control::enable | control::shadow | interrupt);
}

drivers::RegOffset RegisterPath::offset(std::size_t index) const noexcept
{
    return {static_cast<std::uint16_t>(accelerator_->first_word_offset + 4 * index)};
}

std::size_t RegisterPath::write_changed(const protocol::Words& words)
{
    std::size_t written = 0;
    for (std::size_t i = 0; i < accelerator_->word_count; ++i) {
        if (known_ && (*known_)[i] == words[i])
            continue;
        bus_->write(offset(i), words[i]);
        ++written;
    }
    return written;
}

bool RegisterPath::reads_back(const protocol::Words& words) const
{
    for (std::size_t i = 0; i < accelerator_->word_count; ++i)
        if (bus_->read(offset(i)) != words[i])
            return false;
    return !bus_->lost();
}

Applied RegisterPath::apply(const protocol::Words& words)
{
    if (extended_ && (bus_->read(at(Register::Status)) & status::commit_pending) != 0) {
        deferred_ = words;
        return Applied::Deferred;
    }
    deferred_.reset();
    const std::size_t written = write_changed(words);
    if (!reads_back(words)) {
        // The content of the registers is unknown, so the next update writes every word.
        const std::optional<protocol::Words> before = std::exchange(known_, std::nullopt);
        if (before)
            write_changed(*before);
        if (extended_)
            enable(); // the logic may have been reset
        return Applied::Failed;
    }
    known_ = words;
    if (extended_ && written > 0)
        bus_->write(at(Register::Commit), 1);
    return Applied::Written;
}

Applied RegisterPath::retry()
{
    if (!deferred_)
        return Applied::Written;
    const protocol::Words words = *deferred_;
    return apply(words);
}

void RegisterPath::acknowledge_frame()
{
    if (extended_)
        bus_->write(at(Register::Status), status::frame_done);
}

std::uint32_t RegisterPath::status() const
{
    return extended_ ? bus_->read(at(Register::Status)) : 0;
}

std::uint32_t RegisterPath::frames() const
{
    return extended_ ? bus_->read(at(Register::Frames)) : 0;
}

} // namespace raymarch::daemon
