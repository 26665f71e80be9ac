// SPDX-License-Identifier: MIT
/// @file
/// Shows a register block in plain memory. Another program, such as a virtual machine, uses the
/// memory as registers.
///
/// Plain memory has no side effects, so step() must be called repeatedly: it does what hardware
/// does within a clock. Three things differ from hardware. Bit 31 of STATUS reads 1, because a
/// write of 1 to "frame done" could not be detected otherwise. Two commits between two steps count
/// as one. After a write to STATUS, "busy" and "commit pending" read 0 until the next step.
#pragma once

#include "drivers/ports.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <span>

namespace raymarch::emulation
{

/// Borrows the memory, which is one register page, and the block, which has the parameter words of
/// `accelerator`. The class is not thread-safe.
class BlockInMemory
{
  public:
    /// Overwrites the memory with the block's registers.
    BlockInMemory(std::span<std::uint32_t> page, drivers::RegisterBus& block,
                  const protocol::Accelerator& accelerator);

    /// Writes to the block what has changed in the memory since the last step, and copies the
    /// block's registers to the memory. Returns whether parameter words changed.
    bool step();

  private:
    [[nodiscard]] bool take_words();
    void take_control();
    void take_status();
    void show();

    std::span<std::uint32_t> page_;
    drivers::RegisterBus& block_;
    const protocol::Accelerator& accelerator_;
    std::uint32_t control_; ///< the last value in the memory
};

} // namespace raymarch::emulation
