// SPDX-License-Identifier: MIT
/// @file
/// A register window in memory that writes down every access, and can play faults.
#pragma once

#include "drivers/ports.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::test
{

class RecordingBus final : public drivers::RegisterBus
{
  public:
    [[nodiscard]] std::uint32_t read(drivers::RegOffset at) noexcept override
    {
        accesses_.push_back(fmt::format("R {:02X}", at.bytes));
        return memory[at.bytes] & ~stuck_at_zero[at.bytes];
    }
    void write(drivers::RegOffset at, std::uint32_t word) noexcept override
    {
        accesses_.push_back(fmt::format("W {:02X}={:08X}", at.bytes, word));
        memory[at.bytes] = word;
    }
    [[nodiscard]] int interrupt_fd() const noexcept override { return interrupt; }
    void arm_interrupt() noexcept override { accesses_.emplace_back("arm"); }
    [[nodiscard]] Result<std::uint32_t> take_interrupt() override
    {
        std::uint64_t events = 0;
        static_cast<void>(::read(interrupt, &events, sizeof events)); // of an eventfd, if it is one
        if (interrupt_breaks)
            return fail(plain_error(ErrorKind::InputOutput, "the line is broken"));
        return interrupts;
    }
    [[nodiscard]] bool lost() const noexcept override { return is_lost; }

    /// The accesses since the last call, in order: "R 38", "W 34=00000001".
    [[nodiscard]] std::vector<std::string> take_accesses() { return std::exchange(accesses_, {}); }

    std::map<std::uint16_t, std::uint32_t> memory;        ///< what was written, by offset
    std::map<std::uint16_t, std::uint32_t> stuck_at_zero; ///< bits that do not read back
    int interrupt = -1;
    std::uint32_t interrupts = 1;  ///< the device's count of them
    bool interrupt_breaks = false; ///< taking one fails
    bool is_lost = false;

  private:
    std::vector<std::string> accesses_;
};

} // namespace raymarch::test
