// SPDX-License-Identifier: MIT
/// @file
/// Writes parameter words to the register block, checks them and commits them.
#pragma once

#include "base/result.hpp"
#include "drivers/ports.hpp"
#include "protocol/registers.hpp"

#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// The result of an update.
enum class Applied : std::uint8_t {
    Written,  ///< the registers hold the words
    Deferred, ///< an earlier commit is still pending; retry() writes the newest words later
    Failed,   ///< a word read back differently; the old words, if known, were written again
    Absent,   ///< there is no register block
};

/// Borrows the bus.
///
/// In a plain block each word takes effect when it is written. A block with the extended registers
/// runs in shadow mode: the ray units get all words together at the frame start after COMMIT. While
/// a commit is pending no word is written, because a frame could start between two words.
class RegisterPath
{
  public:
    /// Reads ID, tests SCRATCH and reads the accelerator's kind. A block without an ID counts as a
    /// plain block of the accelerator `plain`. Enables the accelerator in shadow mode. Errors:
    /// Unavailable (the test failed, or the kind is unknown).
    [[nodiscard]] static Result<RegisterPath> probe(drivers::RegisterBus& bus,
                                                    const protocol::Accelerator& plain);

    /// Writes the words that changed, in ascending order, reads all words back, and commits.
    [[nodiscard]] Applied apply(const protocol::Words& words);

    /// Writes the deferred words if no commit is pending any more. Returns Written if nothing is
    /// deferred.
    [[nodiscard]] Applied retry();
    [[nodiscard]] bool deferred() const noexcept { return deferred_.has_value(); }

    /// Clears the frame-done flag, and with it the interrupt.
    void acknowledge_frame();

    [[nodiscard]] const protocol::Accelerator& accelerator() const noexcept
    {
        return *accelerator_;
    }
    [[nodiscard]] bool extended() const noexcept { return extended_; }
    /// Returns STATUS, or 0 for a plain block.
    [[nodiscard]] std::uint32_t status() const;
    /// Returns FRAMES, or 0 for a plain block.
    [[nodiscard]] std::uint32_t frames() const;

  private:
    RegisterPath(drivers::RegisterBus& bus, const protocol::Accelerator& accelerator, bool extended)
        : bus_(&bus)
        , accelerator_(&accelerator)
        , extended_(extended)
    {}
    /// Enables drawing, shadow mode and, if there is an interrupt line, the interrupt.
    void enable();
    [[nodiscard]] drivers::RegOffset offset(std::size_t index) const noexcept;
    [[nodiscard]] bool reads_back(const protocol::Words& words) const;
    /// Writes the words that differ from the known ones. Returns how many.
    std::size_t write_changed(const protocol::Words& words);

    drivers::RegisterBus* bus_;
    const protocol::Accelerator* accelerator_;
    bool extended_;
    std::optional<protocol::Words> known_;    ///< the words in the registers, if known
    std::optional<protocol::Words> deferred_; ///< the newest words that are still to be written
};

} // namespace raymarch::daemon
