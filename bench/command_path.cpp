// SPDX-License-Identifier: MIT
/// @file
/// Question: what does it cost to turn the text of a frame into its register words, and what does
/// it cost with sscanf, std::from_chars and fast_float?
///
/// Every contestant parses, checks the ranges, quantises and packs with the same pack(); that all
/// get the same words from every frame is asserted before anything is timed. frame_path.py answers
/// the same for Python. From bytes on a port to the register page: frame_path.cpp.
#include "bench/bench_frames.hpp"
#include "bench/command_baselines.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace
{

using namespace raymarch;        // NOLINT(google-build-using-namespace)
using namespace raymarch::bench; // NOLINT(google-build-using-namespace)
using protocol::State;
using protocol::Words;

const protocol::Accelerator& accelerator = protocol::marcher::description;

bool ours(const std::string& line, State& state)
{
    return !protocol::read_frame(accelerator, {.bytes = line}, state);
}

struct Contestant
{
    std::string_view name;
    ReadFrame in_order;
    ReadFrame any_order;
};

constexpr std::array contestants = {
    Contestant{"raymarch", ours, ours},
    Contestant{"sscanf", sscanf_in_order, sscanf_any_order},
    Contestant{"sscanf_by_pair", sscanf_any_order, sscanf_any_order},
    Contestant{"from_chars", with_from_chars, with_from_chars},
    Contestant{"fast_float", with_fast_float, with_fast_float},
};

/// Over what `state` holds, as the service does it.
Words words_of(ReadFrame read, const std::string& line, State& state)
{
    if (!read(line, state)) {
        std::cerr << "bench_command_path: refused: " << line << '\n';
        std::exit(EXIT_FAILURE);
    }
    return pack(accelerator, state);
}

/// Ends the program unless all contestants get the same words from every line.
void compare(const Frames& lines, ReadFrame Contestant::*way)
{
    State state(accelerator.parameters.size());
    for (const std::string& line : lines) {
        const Words words = words_of(contestants[0].*way, line, state);
        for (const Contestant& contestant : contestants) {
            if (words_of(contestant.*way, line, state) == words)
                continue;
            std::cerr << "bench_command_path: " << contestant.name << " has other words for "
                      << line << '\n';
            std::exit(EXIT_FAILURE);
        }
    }
}

/// One line an iteration.
void run(benchmark::State& state, ReadFrame read, const Frames& lines)
{
    State codes(accelerator.parameters.size());
    std::size_t next = 0;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(lines[next].data());
        benchmark::ClobberMemory();
        Words words = words_of(read, lines[next], codes);
        benchmark::DoNotOptimize(words);
        next = next + 1 == lines.size() ? 0 : next + 1;
    }
}

void add(const std::string& row, ReadFrame Contestant::*way, const Frames& lines)
{
    compare(lines, way);
    for (const Contestant& contestant : contestants)
        benchmark::RegisterBenchmark((row + '/' + std::string(contestant.name)).c_str(), run,
                                     contestant.*way, lines);
}

} // namespace

int main(int argc, char** argv)
{
    const Frames frames = read_frames(RAYMARCH_BENCH_FRAMES);
    if (frames.empty()) {
        std::cerr << "bench_command_path: no frames in " RAYMARCH_BENCH_FRAMES "\n";
        return EXIT_FAILURE;
    }
    add("original", &Contestant::in_order, {frames.front()});
    add("original_shuffled", &Contestant::any_order, {shuffled(frames).front()});
    add("mixed", &Contestant::in_order, frames);
    add("mixed_shuffled", &Contestant::any_order, shuffled(frames));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return EXIT_FAILURE;
    benchmark::RunSpecifiedBenchmarks();
    return EXIT_SUCCESS;
}
