// SPDX-License-Identifier: MIT
#include "emulation/block_in_memory.hpp"

#include "protocol/registers.hpp"

#include <algorithm>
#include <array>
#include <atomic>

namespace raymarch::emulation
{
namespace
{

using protocol::Register;

constexpr std::uint32_t untouched = 1U << 31; ///< of STATUS: gone when somebody has written it

/// What the block alone writes.
constexpr std::array shown = {Register::Id,       Register::Version, Register::Capability,
                              Register::Geometry, Register::Frames,  Register::Cycles,
                              Register::ClockHz};

drivers::RegOffset at(Register reg) noexcept
{
    return {static_cast<std::uint16_t>(reg)};
}

/// The other side is another program, so each access is one aligned load or store, in order.
std::atomic_ref<std::uint32_t> word(std::span<std::uint32_t> page, drivers::RegOffset offset)
{
    return std::atomic_ref(page[offset.bytes / 4]);
}

} // namespace

BlockInMemory::BlockInMemory(std::span<std::uint32_t> page, drivers::RegisterBus& block,
                             const protocol::Accelerator& accelerator)
    : page_(page)
    , block_(block)
    , accelerator_(accelerator)
    , control_(block.read(at(Register::Control)))
{
    std::ranges::fill(page_, 0U);
    word(page_, at(Register::Control)) = control_;
    word(page_, at(Register::Status)) = block_.read(at(Register::Status)) | untouched;
    show();
}

bool BlockInMemory::step()
{
    take_control();
    take_status();
    const bool commit = word(page_, at(Register::Commit)).exchange(0) != 0;
    const bool came = take_words();
    if (commit)
        block_.write(at(Register::Commit), 1);
    show();
    return came;
}

void BlockInMemory::take_control()
{
    const std::uint32_t control = word(page_, at(Register::Control));
    if (control == control_)
        return;
    block_.write(at(Register::Control), control);
    control_ = block_.read(at(Register::Control)); // soft reset clears itself
    std::uint32_t expected = control;              // a newer write stays for the next step
    word(page_, at(Register::Control)).compare_exchange_strong(expected, control_);
}

void BlockInMemory::take_status()
{
    const std::uint32_t status = word(page_, at(Register::Status));
    if ((status & untouched) == 0) {
        block_.write(at(Register::Status), status);
        block_.arm_interrupt();
    }
    // A write that comes between the load and this stays for the next step.
    std::uint32_t expected = status;
    word(page_, at(Register::Status))
        .compare_exchange_strong(expected, block_.read(at(Register::Status)) | untouched);
}

bool BlockInMemory::take_words()
{
    bool came = false;
    for (std::size_t i = 0; i < accelerator_.word_count; ++i) {
        const drivers::RegOffset offset{
            static_cast<std::uint16_t>(accelerator_.first_word_offset + 4 * i)};
        const std::uint32_t value = word(page_, offset);
        if (value == block_.read(offset))
            continue;
        block_.write(offset, value);
        came = true;
    }
    return came;
}

void BlockInMemory::show()
{
    for (const Register reg : shown)
        word(page_, at(reg)) = block_.read(at(reg));
}

} // namespace raymarch::emulation
