// SPDX-License-Identifier: MIT
/// @file
/// Frames through the service's own parts, for a count of the board's instructions.
///
///     board_frames BYTES COUNT
///
/// First each frame of frames.txt, whose words it prints as the registers hold them; then COUNT
/// frames more, in turns, and prints nothing. A frame comes in pieces of at most BYTES.
/// board_frames.py does the same in Python.
#include "bench/bench_frames.hpp"
#include "bench/register_page.hpp"
#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/hardware.hpp"
#include "daemon/session.hpp"
#include "daemon/state_file.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace
{

using namespace raymarch; // NOLINT(google-build-using-namespace)

[[noreturn]] void give_up(const std::string& message)
{
    fmt::print(stderr, "board_frames: {}\n", message);
    std::exit(EXIT_FAILURE);
}

/// At least 1.
template <class Integer>
Integer number(const std::string& text)
{
    Integer value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value == 0)
        give_up(fmt::format("'{}' is no number from 1 to {}", text,
                            std::numeric_limits<Integer>::max()));
    return value;
}

/// Keeps what the service keeps, without the file.
struct Memory final : daemon::Storage
{
    daemon::PersistedStates states;
    void changed(const Accelerator& accelerator, const State& state) override
    {
        states.of(accelerator).last = state;
    }
    daemon::StoredState save(const Accelerator&, const State&) override
    {
        return daemon::stored_already(std::nullopt);
    }
    daemon::StoredState load(const Accelerator&) override
    {
        return daemon::stored_already(std::nullopt);
    }
    std::optional<State> last(const Accelerator&) override { return std::nullopt; }
};
struct NoStatus final : daemon::StatusSource
{
    void write_status(protocol::StatusValues&) override {}
};

/// The service between its ports and its registers, as it comes.
class Service
{
  public:
    Service(daemon::EventLoop& loop, const std::string& registers, std::size_t chunk)
        : config_(with(registers))
        , hardware_(config_, loop, [this] { controller_.board_is_back(hardware_.accelerator()); })
        , controller_(*config_.accelerator,
                      {config_.basis_check, config_.replies, config_.require_checksum}, hardware_,
                      memory_, status_, 1)
        , session_(controller_)
        , chunk_(chunk)
    {
        if (const auto started = hardware_.start(); !started)
            give_up(started.error().message);
    }

    void take(std::string_view frame)
    {
        for (std::size_t at = 0; at < frame.size(); at += chunk_)
            session_.receive(frame.substr(at, chunk_));
        const std::string_view reply = session_.output().pending();
        if (!reply.starts_with("OK "))
            give_up(fmt::format("{}{}", frame, reply));
        session_.output().pop(reply.size());
    }

  private:
    static daemon::Config with(const std::string& registers)
    {
        daemon::Config config = daemon::default_config();
        config.registers = daemon::RegisterFile{registers};
        return config;
    }

    daemon::Config config_;
    Memory memory_;
    NoStatus status_;
    daemon::Hardware hardware_;
    daemon::Controller controller_;
    daemon::Session session_;
    std::size_t chunk_;
};

void print_words(const bench::RegisterPage& page, const protocol::Accelerator& accelerator)
{
    std::vector<std::uint32_t> words(accelerator.word_count);
    const auto bytes = static_cast<ssize_t>(words.size() * sizeof words[0]);
    if (::pread(page.fd.get(), words.data(), static_cast<std::size_t>(bytes),
                accelerator.first_word_offset) != bytes)
        give_up("the register page is too short");
    for (std::size_t i = 0; i < words.size(); ++i)
        fmt::print("{:08X}{}", words[i], i + 1 < words.size() ? ' ' : '\n');
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
        give_up("board_frames BYTES COUNT");
    const auto chunk = number<std::uint16_t>(argv[1]);
    const auto count = number<std::uint32_t>(argv[2]);
    bench::Frames frames = bench::read_frames(RAYMARCH_BENCH_FRAMES);
    if (frames.empty())
        give_up("no frames in " RAYMARCH_BENCH_FRAMES);
    for (std::string& frame : frames)
        frame += "\r\n";

    auto loop = daemon::EventLoop::open();
    if (!loop)
        give_up(loop.error().message);
    const bench::RegisterPage page;
    Service service(*loop, page.path, chunk);
    for (const std::string& frame : frames) {
        service.take(frame);
        print_words(page, protocol::marcher::description);
    }
    static_cast<void>(std::fflush(stdout));
    for (std::uint32_t i = 0; i < count; ++i)
        service.take(frames[i % frames.size()]);
    return EXIT_SUCCESS;
}
