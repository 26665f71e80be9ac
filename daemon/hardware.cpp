// SPDX-License-Identifier: MIT
#include "daemon/hardware.hpp"

#include "board/board_tree.hpp"
#include "board/fpga_manager.hpp"
#include "board/kernel_tree.hpp"
#include "board/logic_loader.hpp"
#include "board/uio_device.hpp"
#include "drivers/atomic_file.hpp"
#include "drivers/lock_file.hpp"
#include "drivers/mapped_window.hpp"
#include "engine/models.hpp"
#include "pictures/picture_file.hpp"

#include <sys/epoll.h>

#include <cassert>
#include <system_error>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t window_bytes = protocol::register_page_bytes;
/// Frames that take longer are shown coarse first.
constexpr std::chrono::milliseconds emulation_patience{100};
/// Without an interrupt line a pending commit is looked at this often; a frame takes tens of ms.
constexpr std::chrono::milliseconds deferred_poll{2};

/// Writes each frame to the preview file; called on the emulated block's worker.
emulation::FrameSink preview_to(const std::string& path)
{
    if (path.empty())
        return {};
    return [path, failing = false](const engine::Image& image) mutable {
        const auto bytes = pictures::encode(image, pictures::PictureFormat::Png);
        const auto written =
            bytes ? drivers::replace_file(path, *bytes, drivers::Durability::BestEffort)
                  : Result<void>(fail(bytes.error()));
        if (!written && !failing)
            log::warning("no preview: {}", written.error().message);
        failing = !written;
    };
}

/// A size that was asked for and that this accelerator does not reach is its own size instead: it
/// was asked for another one.
protocol::PictureSize emulated_size(const Config& config, const protocol::Accelerator& accelerator)
{
    const protocol::PictureSize asked = config.emulated.size;
    const bool fits = asked != protocol::PictureSize{} &&
                      asked.width <= accelerator.max_size.width &&
                      asked.height <= accelerator.max_size.height;
    return fits ? asked : accelerator.size;
}

/// Opens what the variant names; one overload each.
struct Opener
{
    const Config& config;
    const board::KernelTree& tree;
    const OpenUio& open_uio;
    const protocol::Accelerator& accelerator;
    emulation::EmulatedBlock*& emulated;
    std::string& place;

    BusResult emulate() const
    {
        emulation::EmulatedOptions options = config.emulated;
        options.size = emulated_size(config, accelerator);
        options.patience = emulation_patience;
        try {
            auto block = emulation::EmulatedBlock::open(engine::model_of(accelerator), options,
                                                        preview_to(config.preview));
            if (block)
                emulated = block->get();
            return block;
        } catch (const std::system_error& error) { // no thread is left for its worker
            return fail(Error{ErrorKind::Unavailable, error.code().value(),
                              std::string("start the emulated accelerator: ") + error.what()});
        }
    }
    /// An access to logic that is not configured, or has no clock, stops the board: the kernel is
    /// asked first.
    BusResult device(const Result<drivers::UioDevice>& device) const
    {
        if (!device)
            return fail(device.error());
        if (auto safe = board::require_operating_logic(tree); !safe)
            return fail(safe.error());
        if (auto runs = board::require_logic_clock(tree); !runs)
            return fail(runs.error());
        place = device->node;
        return open_uio(*device);
    }
    BusResult operator()(const AutoRegisters&) const
    {
        const auto found = board::find_uio(tree, board::overlay_uio_name);
        // Two of them are a mistake, and a board's logic may come later.
        if (found || found.error().kind != ErrorKind::Unavailable || board::is_zynq(tree))
            return device(found);
        log::notice("{}: the accelerator is emulated", found.error().message);
        return emulate();
    }
    BusResult operator()(const UioNode& where) const
    {
        return device(board::describe_uio(tree, where.path));
    }
    BusResult operator()(const UioName& where) const
    {
        return device(board::find_uio(tree, where.name));
    }
    BusResult operator()(const RegisterFile& where) const
    {
        place = where.path;
        return drivers::MappedWindow::open_file(where.path, window_bytes);
    }
    BusResult operator()(const EmulatedRegisters&) const { return emulate(); }
};

} // namespace

BusResult open_uio_window(const drivers::UioDevice& device)
{
    auto window = drivers::MappedWindow::open_uio(device, window_bytes);
    if (window)
        log::info("{}: {} bytes at {:#010x}, {} interrupt", device.node, device.size,
                  device.address, (*window)->interrupt_fd() >= 0 ? "with an" : "without an");
    return window;
}

Hardware::Hardware(const Config& config, EventLoop& loop, std::function<void()> on_ready,
                   OpenUio open_uio)
    : config_(config)
    , loop_(loop)
    , on_ready_(std::move(on_ready))
    , open_uio_(std::move(open_uio))
    , wanted_(config.accelerator)
    , look_(loop.add_timer([this] { look_at_place(); }))
    , again_(
          loop, "no register block", [this] { try_to_open(); }, "it will be looked for again")
    , retry_deferred_(loop.add_timer([this] { retry_deferred(); }))
{}

Result<void> Hardware::start()
{
    auto opened = open();
    if (!opened && drivers::held_by_another(opened.error()))
        return opened;
    if (found(opened))
        on_ready_();
    return {};
}

Result<void> Hardware::open()
{
    const board::KernelTree tree(config_.sysfs_root);
    place_.clear();
    auto bus = std::visit(Opener{config_, tree, open_uio_, *wanted_, emulated_, place_},
                          config_.registers);
    if (!bus)
        return fail(bus.error());
    bus_ = std::move(*bus);
    if (auto probed = probe(); !probed) {
        drop_bus();
        return probed;
    }
    return {};
}

/// Looks at the block on the bus.
Result<void> Hardware::probe()
{
    auto path = RegisterPath::probe(*bus_, *wanted_);
    if (!path)
        return fail(path.error());
    path_ = *path;
    faulty_ = false;
    interrupt_.reset(); // a descriptor can be watched once
    frames_seen_ = path_->frames();
    rate_ = FrameRate(frames_seen_);
    interrupts_.opened();
    if (bus_->interrupt_fd() >= 0)
        interrupt_ =
            loop_.add_io(bus_->interrupt_fd(), EPOLLIN, [this](std::uint32_t) { on_interrupt(); });
    if (const auto problem = loop_.take_problem()) {
        log::info("the registers go on without an interrupt: {}", problem->message);
        interrupt_.reset();
    }
    watch_place();
    return {};
}

/// A block whose file is removed or replaced is noticed also while nobody sends anything. Only
/// noted by the handler: an inotify source must not be destroyed by its own.
void Hardware::watch_place()
{
    if (place_.empty())
        return;
    // Of a device, IN_MODIFY would be each arming of its interrupt.
    const bool file = std::holds_alternative<RegisterFile>(config_.registers);
    const std::uint32_t changes =
        IN_ATTRIB | IN_DELETE_SELF | IN_MOVE_SELF | (file ? IN_MODIFY : 0U);
    watch_ = loop_.add_inotify(place_.c_str(), changes,
                               [this](const inotify_event&) { look_->arm({}); });
    if (const auto problem = loop_.take_problem())
        log::info("{} is looked at only when it is used: {}", place_, problem->message);
}

void Hardware::look_at_place()
{
    if (bus_ && bus_->lost())
        close();
}

bool Hardware::use(const protocol::Accelerator& accelerator)
{
    if (!path_ || !emulated_)
        return false;
    wanted_ = &accelerator;
    emulated_->become(engine::model_of(accelerator), emulated_size(config_, accelerator));
    [[maybe_unused]] const auto probed = probe();
    assert(probed); // the emulated block is what it says it is
    return true;
}

void Hardware::try_to_open()
{
    if (found(open()))
        on_ready_();
}

bool Hardware::found(const Result<void>& opened)
{
    if (!opened) {
        again_.missing(opened.error());
        return false;
    }
    again_.found();
    log::info("registers: {} {}", path_->accelerator().name,
              path_->extended() ? "with extended registers" : "without extended registers");
    return true;
}

std::string Hardware::place() const
{
    if (!path_)
        return to_text(config_.registers) + " (not there yet)";
    if (emulated_ != nullptr)
        return to_text(EmulatedRegisters{});
    if (std::holds_alternative<RegisterFile>(config_.registers))
        return to_text(config_.registers);
    return to_text(UioNode{place_});
}

void Hardware::drop_bus()
{
    watch_.reset();
    interrupt_.reset();
    path_.reset();
    bus_.reset();
    emulated_ = nullptr;
}

void Hardware::close()
{
    log::warning("the register block has gone away; it will be looked for");
    drop_bus();
    again_.lost();
}

Applied Hardware::apply(const protocol::Words& words)
{
    if (!path_)
        return Applied::Absent;
    const Applied applied = path_->apply(words);
    settle(applied);
    return applied;
}

/// What follows from the outcome of an update, asked for just now or brought later.
void Hardware::settle(Applied applied)
{
    // An update that was written has been read back already, and the block was there then.
    if (applied != Applied::Written && bus_ && bus_->lost()) {
        close();
        return;
    }
    if (applied == Applied::Failed) {
        ++readback_errors_;
        if (!faulty_)
            log::error("a register read back something else than was written to it");
    }
    if (applied == Applied::Written || applied == Applied::Failed)
        faulty_ = applied == Applied::Failed;
    if (path_ && path_->deferred())
        wait_for_frame_start();
}

void Hardware::wait_for_frame_start()
{
    if (interrupt_)
        bus_->arm_interrupt();
    // Also where there is an interrupt: its line may be dead.
    retry_deferred_->arm(interrupt_ ? 50 * deferred_poll : deferred_poll);
}

/// The interrupt is armed again only while something waits for a frame start: an accelerator that
/// draws the same picture over and over does not wake the processor.
void Hardware::on_interrupt()
{
    const auto count = bus_->take_interrupt();
    if (!count) {
        log::warning("{}", count.error().message);
        close();
        return;
    }
    interrupts_.take(*count);
    path_->acknowledge_frame();
    rate_.sample(path_->frames());
    retry_deferred();
}

void Hardware::retry_deferred()
{
    if (path_ && path_->deferred())
        settle(path_->retry());
}

/// Of a block that is there.
bool Hardware::at_fault() const
{
    return faulty_ || (path_->status() & protocol::status::fault) != 0;
}

Health Hardware::health()
{
    if (!path_)
        return {.fault = true, .running = false};
    const bool fault = at_fault();
    const bool busy = (path_->status() & protocol::status::busy) != 0;
    const std::uint32_t frames = path_->frames();
    const bool drew = std::exchange(frames_seen_, frames) != frames;
    if (bus_->lost()) { // the looks themselves found out
        close();
        return {.fault = true, .running = false};
    }
    return {.fault = fault, .running = path_->extended() ? busy || drew : !fault};
}

void Hardware::write_status(protocol::StatusValues& status)
{
    using protocol::StatusKey;
    if (!path_) {
        status.put(StatusKey::Hardware, "absent");
        return;
    }
    status.put(StatusKey::Hardware, at_fault() ? "fault" : "ok");
    status.put(StatusKey::Block, path_->extended() ? "extended" : "plain");
    status.put(StatusKey::ReadbackErrors, readback_errors_);
    if (!path_->extended())
        return;

    const std::uint32_t frames = path_->frames();
    status.put(StatusKey::Frames, frames);
    rate_.sample(frames);
    if (const auto tenths = rate_.tenths_per_second())
        status.put(StatusKey::Fps, protocol::Tenths{*tenths});
    if (!interrupt_)
        return;
    status.put(StatusKey::Interrupts, interrupts_.taken());
    status.put(StatusKey::InterruptsMissed, interrupts_.missed());
}

} // namespace raymarch::daemon
