// SPDX-License-Identifier: MIT
#include "engine/draw.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace raymarch::engine
{

std::uint64_t draw(const Model& model, std::span<const std::uint32_t> words, Image& image,
                   unsigned threads, const std::stop_token& stop)
{
    if (threads == 0)
        threads = std::max(1U, std::thread::hardware_concurrency());
    std::atomic<unsigned> next_row = 0;
    std::atomic<std::uint64_t> unit_cycles = 0;

    // Rows differ in cost, so each thread takes the next one that is free.
    const auto work = [&] {
        std::uint64_t cycles = 0;
        for (unsigned y = next_row++; y < image.size.height && !stop.stop_requested();
             y = next_row++)
            cycles +=
                model.draw_row(words, {image.size, static_cast<std::uint16_t>(y)}, image.row(y));
        unit_cycles += cycles;
    };
    {
        std::vector<std::jthread> others;
        for (unsigned i = 1; i < threads; ++i)
            others.emplace_back(work);
        work();
    }
    const std::uint64_t units = model.description->ray_units;
    return (unit_cycles + units - 1) / units;
}

} // namespace raymarch::engine
