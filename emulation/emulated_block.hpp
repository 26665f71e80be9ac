// SPDX-License-Identifier: MIT
/// @file
/// The register block without a board. The extended registers work as in hardware, and a worker
/// draws what the words say with the engine's model.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"
#include "engine/draw.hpp"
#include "protocol/registers.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace raymarch::emulation
{

/// The registers that the block has.
enum class BlockForm : std::uint8_t {
    Extended, ///< ID, CONTROL, COMMIT … as in docs/registers.md
    Bare,     ///< the parameter words only, as in the source: everything else reads 0
};

struct EmulatedOptions
{
    BlockForm form = BlockForm::Extended;
    engine::PictureSize size{};
    unsigned threads = 1; ///< of the drawing; 0: one for each processor
    /// A frame that would take longer is drawn coarsely first, and ended early for newer words.
    std::optional<std::chrono::milliseconds> patience{};
};

/// The worker calls this after each frame, and with each unfinished picture of a slow frame.
using FrameSink = std::function<void(const engine::Image&)>;

/// Behaves as the hardware does, with one saving: when words have been latched, as many frames are
/// drawn as the picture takes to be complete, and no more. They go into two buffers in turn.
/// FRAMES, STATUS and the interrupt count the frames that were drawn to their end.
/// One thread may use the registers; the worker is another one, which the block starts itself.
class EmulatedBlock final : public drivers::RegisterBus
{
  public:
    /// Errors: Unavailable (no eventfd).
    [[nodiscard]] static Result<std::unique_ptr<EmulatedBlock>>
    open(const engine::Model& model, const EmulatedOptions& options, FrameSink sink);
    /// Waits until the worker has seen that it is to end, which takes part of a frame.
    ~EmulatedBlock() override = default;

    /// Becomes the block of another accelerator at once, as after power-on. The frame that is being
    /// drawn is given up, and the worker begins with the next one when it has seen that.
    void become(const engine::Model& model, engine::PictureSize size);

    /// Ends the drawing, for a process that is about to exit. Waits at most `patience` for the
    /// worker to end, and then as long as it takes for a call of the sink that has begun. Returns
    /// false when the worker has not ended by then.
    [[nodiscard]] bool end_drawing(std::chrono::milliseconds patience);

    [[nodiscard]] std::uint32_t read(drivers::RegOffset at) noexcept override;
    void write(drivers::RegOffset at, std::uint32_t word) noexcept override;
    [[nodiscard]] int interrupt_fd() const noexcept override;
    void arm_interrupt() noexcept override;
    [[nodiscard]] Result<std::uint32_t> take_interrupt() override;
    [[nodiscard]] bool lost() const noexcept override { return false; }

  private:
    EmulatedBlock(const engine::Model& model, const EmulatedOptions& options, FrameSink sink,
                  UniqueFd interrupt);
    void work(const std::stop_token& stop);
    /// Calls the sink, unless `stop` says that nobody wants the picture any more.
    void show(const engine::Image& image, const std::stop_token& stop);
    void draw(engine::Painter& painter, const engine::Drawing& drawing, std::uint32_t number,
              engine::Image& image, const std::stop_token& stop);
    void draw_in_passes(engine::Painter& painter, const engine::Drawing& drawing,
                        std::uint32_t number, engine::Image& image, const std::stop_token& stop);
    void latch_at_frame_start();
    void write_extended(protocol::Register at, std::uint32_t word);
    [[nodiscard]] std::uint32_t read_extended(protocol::Register at) const;
    [[nodiscard]] bool frame_can_start() const;
    void reset();
    void raise_interrupt();

    const EmulatedOptions options_;
    const FrameSink sink_;
    const UniqueFd interrupt_;

    std::mutex mutex_; ///< guards what follows, up to costs_
    std::condition_variable_any wake_;
    const engine::Model* model_;
    engine::PictureSize size_;
    unsigned lives_ = 1;      ///< how many accelerators the block has been
    bool showing_ = false;    ///< the sink has been called and has not returned
    bool ended_ = false;      ///< the worker has returned
    protocol::Words words_{}; ///< as written; in shadow mode not yet seen by the ray units
    bool latch_ = false;      ///< words wait for a frame start
    bool slow_ = false;       ///< the frame that is being drawn ends early for newer words
    std::stop_source frame_;  ///< of the frame that is being drawn
    unsigned owed_ = 0;       ///< frames until the picture of the latched words is complete
    bool armed_ = true;
    std::uint32_t interrupts_ = 0;
    std::uint32_t control_ = 0;
    std::uint32_t status_ = 0;
    std::uint32_t frames_ = 0;
    std::uint32_t cycles_ = 0;
    std::uint32_t scratch_ = 0;

    std::vector<engine::PixelCost> costs_; ///< only the worker uses them
    std::jthread worker_;                  ///< last: it uses all of the above
};

} // namespace raymarch::emulation
