// SPDX-License-Identifier: MIT
/// @file
/// A register block shown in plain memory that another program maps as registers: the memory of a
/// virtual machine whose programmable logic is played from outside.
///
/// Plain memory has no side effects, so step() has to be called again and again; what hardware does
/// within a clock happens at the next step. Three things differ from hardware for that reason. Bit
/// 31 of STATUS reads 1: a write of 1 to "frame done" would else leave the word as it is, and
/// nobody would see it. Two commits that come faster than the steps are taken together. And a write
/// of STATUS hides "busy" and "commit pending" until the next step: who acknowledges a frame and
/// asks at once finds no commit pending.
#pragma once

#include "drivers/ports.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <span>

namespace raymarch::emulation
{

/// Borrows the memory, one register page of whole words, and the block, which draws in the words of
/// `accelerator`. Not thread-safe.
class BlockInMemory
{
  public:
    /// Shows the block's registers from now on; what the memory held is forgotten.
    BlockInMemory(std::span<std::uint32_t> page, drivers::RegisterBus& block,
                  const protocol::Accelerator& accelerator);

    /// Gives to the block what has been written to the memory since the last step, and shows what
    /// the block says now. Returns whether parameter words came.
    bool step();

  private:
    [[nodiscard]] bool take_words();
    void take_control();
    void take_status();
    void show();

    std::span<std::uint32_t> page_;
    drivers::RegisterBus& block_;
    const protocol::Accelerator& accelerator_;
    std::uint32_t control_; ///< as last shown
};

} // namespace raymarch::emulation
