// SPDX-License-Identifier: MIT
/// @file
/// Emulates the register block without a board. The extended registers work as in hardware, and a
/// worker thread draws the frames with the engine's model.
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
    unsigned threads = 1; ///< threads that draw; 0 means one for each processor
    /// A frame that would take longer is drawn coarsely first, and ended early for new words.
    std::optional<std::chrono::milliseconds> patience{};
};

/// The worker calls this after each frame, and with each unfinished picture of a slow frame.
using FrameSink = std::function<void(const engine::Image&)>;

/// Behaves as the hardware does, except that it stops drawing when the picture of the latched words
/// is complete. The frames go into two buffers in turn. FRAMES, STATUS and the interrupt count
/// completed frames. One thread may use the registers; the block starts the worker thread.
class EmulatedBlock final : public drivers::RegisterBus
{
  public:
    /// Errors: Unavailable (no eventfd can be made).
    [[nodiscard]] static Result<std::unique_ptr<EmulatedBlock>>
    open(const engine::Model& model, const EmulatedOptions& options, FrameSink sink);
    /// Waits until the worker ends, at most for a part of a frame.
    ~EmulatedBlock() override = default;

    /// Becomes the block of another accelerator, as after power-on. The present frame is abandoned.
    void become(const engine::Model& model, engine::PictureSize size);

    /// Ends the drawing before the process exits. Waits at most `patience` for the worker to end,
    /// and then until a started call of the sink has returned. Returns whether the worker has
    /// ended.
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
    /// Calls the sink, unless a stop is requested.
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

    std::mutex mutex_; ///< guards the following members up to scratch_
    std::condition_variable_any wake_;
    const engine::Model* model_;
    engine::PictureSize size_;
    unsigned generation_ = 1;  ///< counts the calls of become()
    bool showing_ = false;     ///< the sink has been called and has not returned
    bool ended_ = false;       ///< the worker has returned
    protocol::Words words_{};  ///< the written words; a frame uses a latched copy
    bool latch_ = false;       ///< the words are to be latched at the next frame start
    bool slow_ = false;        ///< new words end the present frame early
    std::stop_source frame_;   ///< stops the present frame
    unsigned frames_left_ = 0; ///< frames until the picture of the latched words is complete
    bool armed_ = true;
    std::uint32_t interrupts_ = 0;
    std::uint32_t control_ = 0;
    std::uint32_t status_ = 0;
    std::uint32_t frames_ = 0;
    std::uint32_t cycles_ = 0;
    std::uint32_t scratch_ = 0;

    std::vector<engine::PixelCost> costs_; ///< only the worker uses them
    std::jthread worker_;                  ///< declared last: it uses all members above
};

} // namespace raymarch::emulation
