// SPDX-License-Identifier: MIT
/// @file
/// How fast the marcher is drawn: by the model, by its kernels, and in floating point without the
/// contract of bits. All in turns, in one run; one JSON object a line on standard output.
///
///     bench_engine [--seconds S] [--sizes WxH…] [--views NAME…] [--engines NAME…]
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engines/float_simd.hpp"
#include "engines/student.hpp"
#include "engines/views.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace raymarch::bench
{
namespace
{

using Milliseconds = std::chrono::duration<double, std::milli>;

const engine::Model& model = engine::model_of(protocol::marcher::description);

struct Options
{
    double seconds = 2; ///< for each view and size
    std::vector<std::string> sizes = {"640x480"};
    std::vector<std::string> views;   ///< empty: all
    std::vector<std::string> engines; ///< empty: all
};

bool chosen(const std::vector<std::string>& names, std::string_view name)
{
    return names.empty() || std::ranges::find(names, name) != names.end();
}

/// One way to draw.
struct Engine
{
    std::string name;
    std::string isa;
    const engine::Kernel* kernel; ///< nullptr: the model
    unsigned threads;
    std::vector<double> milliseconds{};
};

constexpr engine::Kernel student_o2 = {engine::Isa::Scalar, draw_student_o2};
constexpr engine::Kernel student_native = {engine::Isa::Scalar, draw_student_native};
constexpr unsigned most_threads = 2;

std::vector<Engine> engines(const Options& options)
{
    std::vector<Engine> all = {
        {"student -O2", "scalar", &student_o2, 1},
        {"student -O3 -march=native", "native", &student_native, 1},
        {"model", "scalar", nullptr, 1},
    };
    for (unsigned threads = 1; threads <= most_threads; ++threads) {
        for (const engine::Kernel& kernel : float_kernels())
            if (kernel.draw != nullptr && engine::supported(kernel.isa))
                all.push_back({"float", std::string(name_of(kernel.isa)), &kernel, threads});
        for (const engine::IsaRow& row : engine::isa_rows)
            if (const engine::Kernel* const kernel = kernel_of(model, row.isa))
                all.push_back({"kernel", std::string(row.name), kernel, threads});
    }
    std::erase_if(all, [&](const Engine& e) { return !chosen(options.engines, e.name); });
    return all;
}

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(*model.description);
    protocol::ParameterSet given;
    if (protocol::read_assignments(*model.description, {.bytes = settings}, state, given))
        std::abort();
    return protocol::pack(*model.description, state);
}

void time_view(const View& view, engine::PictureSize size, const Options& options)
{
    const protocol::Words words = words_of(view.settings);
    engine::Image image(size);
    std::array<engine::Painter, most_threads> painters = {engine::Painter(1), engine::Painter(2)};
    std::vector<Engine> all = engines(options);

    // A slow engine draws once a round, a fast one as often as fits beside it.
    constexpr Milliseconds turn(50);
    constexpr int most_in_a_turn = 20;
    constexpr int least_rounds = 5;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
    for (int round = 0; round < least_rounds || Clock::now() < end; ++round)
        for (Engine& by : all) {
            const auto start = Clock::now();
            for (int i = 0; i < most_in_a_turn && Clock::now() - start < turn; ++i) {
                const auto begin = Clock::now();
                painters[by.threads - 1].draw({model, words, by.kernel}, engine::whole(size),
                                              {image.rgb});
                by.milliseconds.push_back(Milliseconds(Clock::now() - begin).count());
            }
        }

    for (Engine& by : all) {
        std::ranges::sort(by.milliseconds);
        const nlohmann::ordered_json row = {
            {"view", view.name},
            {"width", size.width},
            {"height", size.height},
            {"engine", by.name},
            {"isa", by.isa},
            {"threads", by.threads},
            {"runs", by.milliseconds.size()},
            {"median_ms", by.milliseconds[by.milliseconds.size() / 2]},
            {"least_ms", by.milliseconds.front()},
        };
        fmt::print("{}\n", row.dump());
    }
    std::fflush(stdout);
}

engine::PictureSize size_of(const std::string& text)
{
    engine::PictureSize size{};
    if (std::sscanf(text.c_str(), "%hux%hu", &size.width, &size.height) != 2)
        throw CLI::ValidationError("--sizes", "'" + text + "' is not WxH");
    return size;
}

int run(int argc, char** argv)
{
    CLI::App app("times the marcher's engines, in turns");
    Options options;
    app.add_option("--seconds", options.seconds, "for each view and size");
    app.add_option("--sizes", options.sizes, "of the picture, WxH");
    app.add_option("--views", options.views, "only these");
    app.add_option("--engines", options.engines, "only these: student -O2, model, float, kernel …");
    CLI11_PARSE(app, argc, argv);
    for (const std::string& size : options.sizes)
        for (const View& view : views)
            if (chosen(options.views, view.name))
                time_view(view, size_of(size), options);
    return 0;
}

} // namespace
} // namespace raymarch::bench

int main(int argc, char** argv)
{
    return raymarch::bench::run(argc, argv);
}
