// SPDX-License-Identifier: MIT
/// @file
/// The register block as the service has it: opened from the configuration, looked for again when
/// it is missing or goes away, and kept informed of deferred updates.
#pragma once

#include "board/uio_device.hpp"
#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/frame_rate.hpp"
#include "daemon/interrupt_count.hpp"
#include "daemon/register_path.hpp"
#include "daemon/reopener.hpp"
#include "drivers/ports.hpp"
#include "emulation/emulated_block.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace raymarch::daemon
{

using BusResult = Result<std::unique_ptr<drivers::RegisterBus>>;

/// Opens the registers of a UIO device behind which there is configured logic.
using OpenUio = std::function<BusResult(const drivers::UioDevice&)>;
[[nodiscard]] BusResult open_uio_window(const drivers::UioDevice& device);

class Hardware final : public Board
{
  public:
    /// `on_ready` is called each time a block has been found: its registers await the state.
    Hardware(const Config& config, EventLoop& loop, std::function<void()> on_ready,
             OpenUio open_uio = open_uio_window);

    /// Looks for the block now; when it is not there, again and again. Errors: Unavailable, when
    /// another process has the block: two services on one would be a mistake, and waiting would
    /// hide it. One that is taken by another later is looked for like any that is not there.
    [[nodiscard]] Result<void> start();

    [[nodiscard]] Health health() override;
    [[nodiscard]] Applied apply(const protocol::Words& words) override;
    [[nodiscard]] bool use(const protocol::Accelerator& accelerator) override;

    /// Where the block is, in the notation of the setting `registers`, and whether it is there.
    [[nodiscard]] std::string place() const;

    /// Ends what is being drawn, as EmulatedBlock::end_drawing().
    [[nodiscard]] bool end_drawing(std::chrono::milliseconds patience)
    {
        return emulated_ == nullptr || emulated_->end_drawing(patience);
    }

    /// What the block is; before it is found, what it is taken for.
    [[nodiscard]] const protocol::Accelerator& accelerator() const noexcept
    {
        return path_ ? path_->accelerator() : *wanted_;
    }

    void write_status(protocol::StatusValues& status);

  private:
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<void> probe();
    /// Takes the result of open(). If the block is not there, it is looked for again later, and the
    /// return value is false.
    bool found(const Result<void>& opened);
    void try_to_open();
    void drop_bus();
    void close();
    void on_interrupt();
    void watch_place();
    void look_at_place();
    void retry_deferred();
    void settle(Applied applied);
    void wait_for_frame_start();
    [[nodiscard]] bool at_fault() const;

    const Config& config_;
    EventLoop& loop_;
    std::function<void()> on_ready_;
    OpenUio open_uio_;
    const protocol::Accelerator* wanted_; ///< what an emulated block is, and a plain one taken for
    emulation::EmulatedBlock* emulated_ = nullptr; ///< bus_, where it is one
    std::uint64_t readback_errors_ = 0;
    bool faulty_ = false;

    std::uint32_t frames_seen_ = 0; ///< FRAMES at the last health()
    FrameRate rate_{0};
    InterruptCount interrupts_;

    std::unique_ptr<drivers::RegisterBus> bus_;
    std::optional<RegisterPath> path_; ///< borrows bus_
    Source interrupt_;                 ///< watches bus_
    std::string place_;                ///< of the file or node behind bus_; empty: there is none
    Source watch_;                     ///< of place_
    Source look_;                      ///< something has changed there
    Reopener again_;
    Source retry_deferred_;
};

} // namespace raymarch::daemon
