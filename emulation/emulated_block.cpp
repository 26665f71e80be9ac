// SPDX-License-Identifier: MIT
#include "emulation/emulated_block.hpp"

#include "engine/progressive.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace raymarch::emulation
{
namespace
{

using protocol::Register;
namespace control = protocol::control;
namespace status = protocol::status;

/// Returns the index of the parameter word at `at`, or nothing if another register is there.
std::optional<std::size_t> parameter_word(const protocol::Accelerator& accelerator,
                                          drivers::RegOffset at) noexcept
{
    const int index = (at.bytes - accelerator.first_word_offset) / 4;
    if (at.bytes < accelerator.first_word_offset || index >= accelerator.word_count)
        return std::nullopt;
    return static_cast<std::size_t>(index);
}

} // namespace

Result<std::unique_ptr<EmulatedBlock>>
EmulatedBlock::open(const engine::Model& model, const EmulatedOptions& options, FrameSink sink)
{
    UniqueFd interrupt(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
    if (!interrupt)
        return fail(errno_error(ErrorKind::Unavailable, "make", "an eventfd"));
    return std::unique_ptr<EmulatedBlock>(
        new EmulatedBlock(model, options, std::move(sink), std::move(interrupt)));
}

EmulatedBlock::EmulatedBlock(const engine::Model& model, const EmulatedOptions& options,
                             FrameSink sink, UniqueFd interrupt)
    : options_(options)
    , sink_(std::move(sink))
    , interrupt_(std::move(interrupt))
    , model_(&model)
    , size_(options.size)
    , worker_([this](const std::stop_token& stop) { work(stop); })
{}

void EmulatedBlock::become(const engine::Model& model, engine::PictureSize size)
{
    const std::scoped_lock lock(mutex_);
    model_ = &model;
    size_ = size;
    ++generation_;
    reset();
    status_ = 0;
    control_ = 0;
    scratch_ = 0;
    armed_ = true;
    interrupts_ = 0;
    std::uint64_t unseen = 0;
    [[maybe_unused]] const auto size_read = ::read(interrupt_.get(), &unseen, sizeof unseen);
    frame_.request_stop();
}

bool EmulatedBlock::end_drawing(std::chrono::milliseconds patience)
{
    worker_.request_stop();
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, patience, [this] { return ended_; });
    wake_.wait(lock, [this] { return !showing_; });
    return ended_;
}

std::uint32_t EmulatedBlock::read(drivers::RegOffset at) noexcept
{
    const std::scoped_lock lock(mutex_);
    if (const auto index = parameter_word(*model_->description, at))
        return words_[*index];
    return options_.form == BlockForm::Extended ? read_extended(Register{at.bytes}) : 0;
}

std::uint32_t EmulatedBlock::read_extended(Register at) const
{
    switch (at) {
    case Register::Id:
        return protocol::id_value;
    case Register::Version:
        return protocol::version_value;
    case Register::Capability:
        return protocol::capability_word(*model_->description);
    case Register::Geometry:
        return protocol::geometry_word(size_);
    case Register::Control:
        return control_;
    case Register::Commit:
        return 0;
    case Register::Status:
        return status_ | (latch_ && (control_ & control::shadow) != 0 ? status::commit_pending : 0);
    case Register::Frames:
        return frames_;
    case Register::Cycles:
        return cycles_;
    case Register::ClockHz:
        return model_->description->clock_hz;
    case Register::Scratch:
        return scratch_;
    }
    return 0; // an offset that no register has
}

void EmulatedBlock::write(drivers::RegOffset at, std::uint32_t word) noexcept
{
    const std::scoped_lock lock(mutex_);
    if (const auto index = parameter_word(*model_->description, at)) {
        words_[*index] = word;
        if (options_.form == BlockForm::Bare || (control_ & control::shadow) == 0)
            latch_at_frame_start();
    } else if (options_.form == BlockForm::Extended) {
        write_extended(Register{at.bytes}, word);
    }
    wake_.notify_all();
}

void EmulatedBlock::write_extended(Register at, std::uint32_t word)
{
    switch (at) {
    case Register::Control:
        if ((word & control::soft_reset) != 0)
            reset();
        control_ = word & (control::enable | control::interrupt_enable | control::shadow);
        raise_interrupt();
        return;
    case Register::Commit:
        latch_at_frame_start();
        return;
    case Register::Status:
        if ((word & status::frame_done) != 0)
            status_ &= ~status::frame_done;
        return;
    case Register::Scratch:
        scratch_ = word;
        return;
    case Register::Id:
    case Register::Version:
    case Register::Capability:
    case Register::Geometry:
    case Register::Frames:
    case Register::Cycles:
    case Register::ClockHz:
        return; // read only
    }
}

void EmulatedBlock::reset()
{
    words_ = {};
    latch_ = false;
    frames_left_ = 0;
    status_ &= status::busy; // the present frame is drawn to its end
    frames_ = 0;
    cycles_ = 0;
}

/// The interrupt line is level-triggered: it is raised whenever a frame is done and the interrupt
/// is enabled and armed.
void EmulatedBlock::raise_interrupt()
{
    if (!armed_ || (status_ & status::frame_done) == 0 ||
        (control_ & control::interrupt_enable) == 0)
        return;
    armed_ = false;
    ++interrupts_;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(interrupt_.get(), &one, sizeof one);
}

int EmulatedBlock::interrupt_fd() const noexcept
{
    return options_.form == BlockForm::Extended ? interrupt_.get() : -1;
}

void EmulatedBlock::arm_interrupt() noexcept
{
    const std::scoped_lock lock(mutex_);
    armed_ = true;
    raise_interrupt();
}

Result<std::uint32_t> EmulatedBlock::take_interrupt()
{
    std::uint64_t count = 0;
    if (::read(interrupt_.get(), &count, sizeof count) != static_cast<ssize_t>(sizeof count))
        return fail(errno_error(ErrorKind::InputOutput, "read", "the emulated interrupt"));
    const std::scoped_lock lock(mutex_);
    return interrupts_;
}

bool EmulatedBlock::frame_can_start() const
{
    const bool enabled = options_.form == BlockForm::Bare || (control_ & control::enable) != 0;
    return (latch_ || frames_left_ > 0) && enabled;
}

/// New words end a slow frame when a part of it has been shown.
void EmulatedBlock::latch_at_frame_start()
{
    latch_ = true;
    if (slow_)
        frame_.request_stop();
}

void EmulatedBlock::show(const engine::Image& image, const std::stop_token& stop)
{
    if (!sink_)
        return;
    std::unique_lock lock(mutex_);
    if (stop.stop_requested())
        return;
    showing_ = true;
    lock.unlock();
    sink_(image);
    lock.lock();
    showing_ = false;
    wake_.notify_all();
}

void EmulatedBlock::draw(engine::Painter& painter, const engine::Drawing& drawing,
                         std::uint32_t number, engine::Image& image, const std::stop_token& stop)
{
    using Clock = std::chrono::steady_clock;
    if (options_.patience && drawing.picture->frames() == 1) {
        const auto start = Clock::now();
        painter.draw(drawing, engine::region_of(engine::passes[0], image.size, number),
                     {image.rgb, costs_}, stop);
        if ((Clock::now() - start) * engine::first_pass_share > *options_.patience) {
            draw_in_passes(painter, drawing, number, image, stop);
            return;
        }
    }
    engine::draw_frame(painter, drawing, engine::whole(image.size, number), {image.rgb, costs_},
                       stop);
}

/// Precondition: the first pass has been drawn.
void EmulatedBlock::draw_in_passes(engine::Painter& painter, const engine::Drawing& drawing,
                                   std::uint32_t number, engine::Image& image,
                                   const std::stop_token& stop)
{
    const engine::Canvas canvas{image.rgb, costs_};
    engine::Image shown(image.size);
    for (const engine::Pass& pass : engine::passes) {
        if (&pass != engine::passes.data())
            painter.draw(drawing, engine::region_of(pass, image.size, number), canvas, stop);
        if (stop.stop_requested())
            return;
        if (pass.grid > 1 && sink_) {
            engine::spread(image, pass.grid, shown);
            show(shown, stop);
        }
        const std::scoped_lock lock(mutex_);
        slow_ = true;
        if (latch_)
            frame_.request_stop();
    }
    if (!stop.stop_requested())
        drawing.picture->complete(canvas);
}

void EmulatedBlock::work(const std::stop_token& stop)
{
    engine::Painter painter(options_.threads);
    std::array<engine::Image, 2> buffers;
    protocol::Words latched;
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return frame_can_start(); })) {
        const engine::Model& model = *model_;
        if (latch_) {
            latched = words_;
            frames_left_ = engine::frames_of_a_still(model, latched);
            latch_ = false;
        }
        --frames_left_;
        status_ |= status::busy;
        slow_ = false;
        frame_ = std::stop_source();
        const std::stop_token frame_stop = frame_.get_token();
        const std::stop_callback end(stop, [source = frame_]() mutable { source.request_stop(); });
        const engine::PictureSize size = size_;
        const unsigned generation = generation_;
        const std::uint32_t number = frames_;
        engine::Image& image = buffers[number % buffers.size()];

        lock.unlock();
        if (image.size != size) {
            buffers.fill(engine::Image(size));
            costs_.assign(image.rgb.size() / engine::bytes_per_pixel, {});
        }
        draw(painter, {model, latched, engine::kernel_of(model)}, number, image, frame_stop);
        if (stop.stop_requested())
            break;
        const bool finished = !frame_stop.stop_requested();
        const std::uint64_t cycles = engine::frame_cycles(model, latched, size, number, costs_);
        if (finished)
            show(image, frame_stop);
        lock.lock();

        if (generation != generation_)
            continue; // the frame belongs to the last model
        slow_ = false;
        status_ &= ~status::busy;
        if (!finished)
            continue;
        status_ |= status::frame_done;
        ++frames_;
        cycles_ = static_cast<std::uint32_t>(
            std::min<std::uint64_t>(cycles, std::numeric_limits<std::uint32_t>::max()));
        raise_interrupt();
    }
    if (!lock.owns_lock())
        lock.lock();
    ended_ = true;
    wake_.notify_all();
}

} // namespace raymarch::emulation
