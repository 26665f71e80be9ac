// SPDX-License-Identifier: MIT
/// @file
/// How many rays a second the ray tracer follows: by its model, by its kernels, and in scalar
/// floating point. All in turns, in one run; one JSON object a line on standard output.
///
///     bench_whitted [--seconds S] [--settings KEY=VALUE,…]
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engines/whitted_float.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace raymarch::bench
{
namespace
{

using Milliseconds = std::chrono::duration<double, std::milli>;

const engine::Model& model = engine::model_of(protocol::whitted::description);

struct Options
{
    double seconds = 10;
    /// Eight spheres and four planes, three reflections, nine samples a pixel.
    std::string settings = "N=8,LR=3,REFLECTIONS=3,AA=8x";
};

/// One way to draw.
struct Engine
{
    std::string name;
    std::string isa;
    unsigned threads;
    std::function<std::uint64_t()> draw; ///< returns the rays
    std::uint64_t rays = 0;
    std::vector<double> milliseconds{};
};

protocol::Words words_of(const std::string& settings)
{
    protocol::State state = protocol::initial_state(*model.description);
    protocol::ParameterSet given;
    if (protocol::read_assignments(*model.description, {.bytes = settings}, state, given))
        throw CLI::ValidationError("--settings", "'" + settings + "' is not understood");
    return protocol::pack(*model.description, state);
}

void time_all(const Options& options)
{
    const protocol::Words words = words_of(options.settings);
    const engine::PictureSize size = model.description->size;
    engine::Image image(size);
    const std::vector<engine::PixelCost> costs = engine::draw(model, words, image, 2);
    const std::uint64_t rays = model.latch(words)->rays(size, costs);

    std::array<engine::Painter, 2> painters = {engine::Painter(1), engine::Painter(2)};
    const auto painted = [&](const engine::Kernel* kernel, unsigned threads) {
        return [&, kernel, threads] {
            painters[threads - 1].draw({model, words, kernel}, engine::whole(size), {image.rgb});
            return rays;
        };
    };
    std::vector<Engine> all = {
        {"float -O2", "scalar", 1, [&] { return draw_whitted_float(words, size, {image.rgb}); }},
        {"model", "scalar", 1, painted(nullptr, 1)},
    };
    for (const unsigned threads : {1U, 2U})
        for (const engine::IsaRow& row : engine::isa_rows)
            if (const engine::Kernel* const kernel = engine::kernel_of(model, row.isa))
                all.push_back({"kernel", std::string(row.name), threads, painted(kernel, threads)});

    // A slow engine draws once a round, a fast one as often as fits beside it.
    constexpr Milliseconds turn(300);
    constexpr int least_rounds = 3;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
    for (int round = 0; round < least_rounds || Clock::now() < end; ++round)
        for (Engine& by : all)
            for (const auto start = Clock::now(); Clock::now() - start < turn;) {
                const auto begin = Clock::now();
                by.rays = by.draw();
                by.milliseconds.push_back(Milliseconds(Clock::now() - begin).count());
            }

    for (Engine& by : all) {
        std::ranges::sort(by.milliseconds);
        const double median = by.milliseconds[by.milliseconds.size() / 2];
        const nlohmann::ordered_json row = {
            {"engine", by.name},
            {"isa", by.isa},
            {"threads", by.threads},
            {"runs", by.milliseconds.size()},
            {"rays", by.rays},
            {"median_ms", median},
            {"least_ms", by.milliseconds.front()},
            {"rays_per_second", static_cast<double>(by.rays) / median * 1e3},
        };
        fmt::print("{}\n", row.dump());
    }
}

int run(int argc, char** argv)
{
    CLI::App app("times the ray tracer's engines, in turns");
    Options options;
    app.add_option("--seconds", options.seconds, "in all, at least");
    app.add_option("--settings", options.settings, "on top of the initial state");
    CLI11_PARSE(app, argc, argv);
    time_all(options);
    return 0;
}

} // namespace
} // namespace raymarch::bench

int main(int argc, char** argv)
{
    return raymarch::bench::run(argc, argv);
}
