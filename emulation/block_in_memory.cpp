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

/// This bit of STATUS is clear after the other program has written STATUS.
constexpr std::uint32_t not_written = 1U << 31;

constexpr std::array read_only_registers = {
    Register::Id,     Register::Version, Register::Capability, Register::Geometry,
    Register::Frames, Register::Cycles,  Register::ClockHz};

drivers::RegOffset at(Register reg) noexcept
{
    return {static_cast<std::uint16_t>(reg)};
}

/// Another program uses the page at the same time, so each access is one aligned load or store.
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
    word(page_, at(Register::Status)) = block_.read(at(Register::Status)) | not_written;
    show();
}

bool BlockInMemory::step()
{
    take_control();
    take_status();
    const bool commit = word(page_, at(Register::Commit)).exchange(0) != 0;
    const bool changed = take_words();
    if (commit)
        block_.write(at(Register::Commit), 1);
    show();
    return changed;
}

void BlockInMemory::take_control()
{
    const std::uint32_t control = word(page_, at(Register::Control));
    if (control == control_)
        return;
    block_.write(at(Register::Control), control);
    control_ = block_.read(at(Register::Control)); // soft reset clears itself
    std::uint32_t expected = control;              // the next step takes a newer write
    word(page_, at(Register::Control)).compare_exchange_strong(expected, control_);
}

void BlockInMemory::take_status()
{
    const std::uint32_t status = word(page_, at(Register::Status));
    if ((status & not_written) == 0) {
        block_.write(at(Register::Status), status);
        block_.arm_interrupt();
    }
    // If STATUS was written after the load, the next step takes that write.
    std::uint32_t expected = status;
    word(page_, at(Register::Status))
        .compare_exchange_strong(expected, block_.read(at(Register::Status)) | not_written);
}

bool BlockInMemory::take_words()
{
    bool changed = false;
    for (std::size_t i = 0; i < accelerator_.word_count; ++i) {
        const drivers::RegOffset offset{
            static_cast<std::uint16_t>(accelerator_.first_word_offset + 4 * i)};
        const std::uint32_t value = word(page_, offset);
        if (value == block_.read(offset))
            continue;
        block_.write(offset, value);
        changed = true;
    }
    return changed;
}

void BlockInMemory::show()
{
    for (const Register reg : read_only_registers)
        word(page_, at(reg)) = block_.read(at(reg));
}

} // namespace raymarch::emulation
