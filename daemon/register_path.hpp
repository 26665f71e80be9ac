// SPDX-License-Identifier: MIT
/// @file
/// Words to the register block: which registers are touched, in which order, and what is checked.
#pragma once

#include "base/result.hpp"
#include "drivers/ports.hpp"
#include "protocol/registers.hpp"

#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// What became of an update.
enum class Applied : std::uint8_t {
    Written,  ///< the registers hold it
    Deferred, ///< an earlier commit is still pending; retry() brings it, or a newer one
    Failed,   ///< a word read back differently; the registers were set back as far as they let
    Absent,   ///< there is no register block
};

/// The path of one accelerator's words. Borrows the bus.
///
/// A plain block is written word by word. A block with the extended registers runs in shadow mode:
/// words reach the ray units together, at the frame start after COMMIT. While a commit is pending
/// no word is written, because the frame start could fall between two of them.
class RegisterPath
{
  public:
    /// Looks at what is there: ID, then the self-test on SCRATCH, then the kind. `plain` is what a
    /// block without an ID is taken for. Enables the accelerator, in shadow mode. Errors:
    /// Unavailable (the self-test failed, or no description has its kind).
    [[nodiscard]] static Result<RegisterPath> probe(drivers::RegisterBus& bus,
                                                    const protocol::Accelerator& plain);

    /// Writes the words that changed, in ascending order, reads all words back, and commits.
    [[nodiscard]] Applied apply(const protocol::Words& words);

    /// Brings what was deferred, if the pending commit is through; Written when nothing is
    /// deferred.
    [[nodiscard]] Applied retry();
    [[nodiscard]] bool deferred() const noexcept { return deferred_.has_value(); }

    /// Takes back the frame-done flag, so that the interrupt falls.
    void acknowledge_frame();

    [[nodiscard]] const protocol::Accelerator& accelerator() const noexcept
    {
        return *accelerator_;
    }
    [[nodiscard]] bool extended() const noexcept { return extended_; }
    /// STATUS; 0 for a plain block.
    [[nodiscard]] std::uint32_t status() const;
    /// FRAMES; 0 for a plain block.
    [[nodiscard]] std::uint32_t frames() const;

  private:
    RegisterPath(drivers::RegisterBus& bus, const protocol::Accelerator& accelerator, bool extended)
        : bus_(&bus)
        , accelerator_(&accelerator)
        , extended_(extended)
    {}
    /// Frames are drawn, in shadow mode, with an interrupt where there is a line.
    void enable();
    [[nodiscard]] drivers::RegOffset offset(std::size_t index) const noexcept;
    [[nodiscard]] bool reads_back(const protocol::Words& words) const;
    /// The number of words written: those that differ from what the registers are known to hold.
    std::size_t write_changed(const protocol::Words& words);

    drivers::RegisterBus* bus_;
    const protocol::Accelerator* accelerator_;
    bool extended_;
    std::optional<protocol::Words> held_;     ///< what the registers hold, once that is known
    std::optional<protocol::Words> deferred_; ///< the newest state that still has to go out
};

} // namespace raymarch::daemon
