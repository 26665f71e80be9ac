// SPDX-License-Identifier: MIT
/// @file
/// How fast the marcher's engines draw, all in one run, in turns: the model, its kernels, and
/// floating point without the contract. One JSON object a line on standard output.
///
///     bench_engine [--seconds S] [--size WxH] [--view NAME]
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engines/views.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace raymarch::bench
{
namespace
{

using Milliseconds = std::chrono::duration<double, std::milli>;

struct Options
{
    double seconds = 1; ///< for each view and size
    std::vector<std::string> views;
    std::vector<std::string> engines;
};

/// One way to draw, and how long it took each time.
struct Runner
{
    std::string name;
    const engine::Kernel* kernel;
    unsigned threads;
    std::vector<double> times{};
};

std::vector<Runner> runners()
{
    std::vector<Runner> all = {{"reference", nullptr, 1}, {"reference", nullptr, 2}};
    const engine::Model& model = engine::models[0];
    for (const engine::IsaRow& row : engine::isa_rows)
        if (const engine::Kernel* const kernel = engine::kernel_of(model, row.isa))
            for (const unsigned threads : {1U, 2U})
                all.push_back({std::string(row.name), kernel, threads});
    return all;
}

protocol::Words words_of(std::string_view settings)
{
    const protocol::Accelerator& accelerator = protocol::marcher::description;
    protocol::State state = protocol::initial_state(accelerator);
    protocol::ParameterSet given;
    (void)protocol::read_assignments(accelerator, {.bytes = settings}, state, given);
    return protocol::pack(accelerator, state);
}

void time_view(const View& view, engine::PictureSize size, const Options& options)
{
    const protocol::Words words = words_of(view.settings);
    engine::Image image(size);
    engine::Painter painters[2] = {engine::Painter(1), engine::Painter(2)};
    std::vector<Runner> all = runners();
    if (!options.engines.empty())
        std::erase_if(all, [&](const Runner& r) {
            return std::ranges::find(options.engines, r.name) == options.engines.end();
        });
    const auto start = std::chrono::steady_clock::now();
    const std::chrono::duration<double> budget(options.seconds);
    for (int round = 0; round < 3 || std::chrono::steady_clock::now() - start < budget; ++round)
        for (Runner& runner : all) {
            const engine::Drawing drawing{engine::models[0], words, runner.kernel};
            const int repeats = runner.kernel == nullptr ? 1 : 5;
            for (int i = 0; i < repeats; ++i) {
                const auto begin = std::chrono::steady_clock::now();
                painters[runner.threads - 1].draw(drawing, engine::whole(size), {image.rgb});
                runner.times.push_back(
                    Milliseconds(std::chrono::steady_clock::now() - begin).count());
            }
        }
    for (Runner& runner : all) {
        std::ranges::sort(runner.times);
        fmt::print("{{\"view\": \"{}\", \"width\": {}, \"height\": {}, \"engine\": \"{}\", "
                   "\"threads\": {}, \"median_ms\": {:.4f}, \"least_ms\": {:.4f}, \"runs\": {}}}\n",
                   view.name, size.width, size.height, runner.name, runner.threads,
                   runner.times[runner.times.size() / 2], runner.times.front(),
                   runner.times.size());
    }
}

int run(int argc, char** argv)
{
    CLI::App app("times the marcher's engines");
    Options options;
    app.add_option("--seconds", options.seconds, "for each view and size");
    app.add_option("--view", options.views, "only these");
    app.add_option("--engine", options.engines, "only these");
    CLI11_PARSE(app, argc, argv);
    for (const View& view : views)
        if (options.views.empty() ||
            std::ranges::find(options.views, view.name) != options.views.end())
            time_view(view, {640, 480}, options);
    return 0;
}

} // namespace
} // namespace raymarch::bench

int main(int argc, char** argv)
{
    return raymarch::bench::run(argc, argv);
}
