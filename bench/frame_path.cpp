// SPDX-License-Identifier: MIT
/// @file
/// Question: what does a frame cost the processor, from its bytes to the register page?
///
/// frame_path.py answers the same for the way of the source's script, with the same frames. Beside
/// the frame: the whole session (basis check, read-back, reply), other orders, chunks and numbers.
#include "bench/bench_frames.hpp"
#include "bench/register_page.hpp"
#include "daemon/register_path.hpp"
#include "daemon/session.hpp"
#include "drivers/mapped_window.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/quantizer.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace
{

using namespace raymarch;           // NOLINT(google-build-using-namespace)
using namespace raymarch::protocol; // NOLINT(google-build-using-namespace)
using namespace raymarch::bench;    // NOLINT(google-build-using-namespace)

const Accelerator& accelerator = marcher::description;
const Parameter& zoom = marcher::parameters[marcher::ZM];

[[noreturn]] void give_up(const std::string& message)
{
    std::cerr << "bench_frame_path: " << message << '\n';
    std::exit(EXIT_FAILURE);
}

/// With their endings.
Frames with_endings(Frames frames)
{
    for (std::string& frame : frames)
        frame += "\r\n";
    return frames;
}

const Frames& mixed_frames()
{
    static const Frames frames = with_endings(read_frames(RAYMARCH_BENCH_FRAMES));
    return frames;
}

/// The one frame of the source's listing, over and over.
Frames first_frame()
{
    return {read_frames(RAYMARCH_BENCH_FRAMES).front() + "\r\n"};
}

/// The same frames, each with its pairs in an order of its own.
Frames shuffled_frames()
{
    return with_endings(shuffled(read_frames(RAYMARCH_BENCH_FRAMES)));
}

/// A register page, mapped as the service maps it.
struct Page
{
    RegisterPage file;
    std::unique_ptr<drivers::MappedWindow> window;
    Page()
    {
        auto opened = drivers::MappedWindow::open_file(file.path, register_page_bytes);
        if (!opened)
            give_up(opened.error().message);
        window = std::move(*opened);
    }
};

void store(drivers::RegisterBus& page, const Words& words)
{
    for (std::size_t i = 0; i < accelerator.word_count; ++i)
        page.write({static_cast<std::uint16_t>(accelerator.first_word_offset + 4 * i)}, words[i]);
}

/// All lines that `bytes` ends, over what `state` holds.
void take(LineReader& reader, std::string_view bytes, State& state, drivers::RegisterBus& page)
{
    while (const auto line = reader.next(bytes)) {
        const Request request = read_request(*line, false);
        if (request.kind != Request::Kind::Frame || read_frame(accelerator, request.text, state))
            give_up("refused: " + std::string(line->bytes));
        store(page, pack(accelerator, state));
    }
}

/// One frame an iteration, in chunks of at most `chunk` bytes.
void run_frames(benchmark::State& state, const Frames& frames, std::size_t chunk)
{
    const Page page;
    LineReader reader;
    State codes(accelerator.parameters.size());
    std::size_t next = 0;
    for ([[maybe_unused]] auto _ : state) {
        std::string_view frame = frames[next];
        benchmark::DoNotOptimize(frame);
        while (!frame.empty()) {
            const std::string_view piece = frame.substr(0, chunk);
            frame.remove_prefix(piece.size());
            take(reader, piece, codes, *page.window);
        }
        benchmark::ClobberMemory();
        next = next + 1 == frames.size() ? 0 : next + 1;
    }
}

/// The registers alone: what of the above is the page's.
void stores(benchmark::State& state)
{
    const Page page;
    Words words = pack(accelerator, initial_state(accelerator));
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(words);
        store(*page.window, words);
    }
}

struct PlainBoard final : daemon::Board
{
    Page page;
    Result<daemon::RegisterPath> path = daemon::RegisterPath::probe(*page.window, accelerator);
    daemon::Applied apply(const Words& words) override { return path->apply(words); }
    daemon::Health health() override { return {}; }
    bool use(const Accelerator&) override { return false; }
};
struct NoStorage final : daemon::Storage
{
    void changed(const Accelerator&, const State&) override {}
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
    void write_status(StatusValues&) override {}
};

/// All that the service does between reading from the port and writing the reply to it.
void session(benchmark::State& state)
{
    PlainBoard board;
    NoStorage storage;
    NoStatus status;
    daemon::Controller controller(accelerator, {}, board, storage, status, 1);
    daemon::Session session(controller);
    const Frames& frames = mixed_frames();
    std::size_t next = 0;
    for ([[maybe_unused]] auto _ : state) {
        std::string_view frame = frames[next];
        benchmark::DoNotOptimize(frame);
        session.receive(frame);
        benchmark::DoNotOptimize(session.output().pending().data());
        benchmark::ClobberMemory();
        session.output().clear();
        next = next + 1 == frames.size() ? 0 : next + 1;
    }
    if (controller.last_refused())
        give_up("the session refused a frame");
}

void number(benchmark::State& state, std::string_view text)
{
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(text);
        auto code = quantize(zoom, text);
        benchmark::DoNotOptimize(code);
    }
}

/// The answer to GET, for the states of the mixed frames.
void get(benchmark::State& state)
{
    std::vector<State> states;
    for (const std::string& frame : mixed_frames()) {
        State& read = states.emplace_back(accelerator.parameters.size());
        const std::string_view text = std::string_view(frame).substr(0, frame.size() - 2);
        if (read_frame(accelerator, {.bytes = text}, read))
            give_up("refused: " + frame);
    }
    ReplyWriter reply;
    std::size_t next = 0;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(states[next]);
        reply.begin(false);
        reply << "OK ";
        write_state(reply, accelerator, states[next]);
        reply.end_line();
        benchmark::DoNotOptimize(reply.text().data());
        benchmark::ClobberMemory();
        next = next + 1 == states.size() ? 0 : next + 1;
    }
}

constexpr std::size_t whole_line = max_line_length;
constexpr std::size_t uart_fifo = 16;
constexpr std::string_view longest_number = "2.718281828459045235360287471352";
static_assert(longest_number.size() == max_number_length);

} // namespace

BENCHMARK_CAPTURE(run_frames, one, first_frame(), whole_line)->Name("frame/one");
BENCHMARK_CAPTURE(run_frames, mixed, mixed_frames(), whole_line)->Name("frame/mixed");
BENCHMARK_CAPTURE(run_frames, any_order, shuffled_frames(), whole_line)->Name("frame/any_order");
BENCHMARK_CAPTURE(run_frames, chunks, mixed_frames(), uart_fifo)->Name("frame/chunks_of_16");
BENCHMARK(stores)->Name("stores");
BENCHMARK(session)->Name("session/mixed");
BENCHMARK_CAPTURE(number, source, "3.00")->Name("number/source");
BENCHMARK_CAPTURE(number, longest, longest_number)->Name("number/longest");
BENCHMARK(get)->Name("get");
BENCHMARK_MAIN();
