// SPDX-License-Identifier: MIT
#include "bench/bench_frames.hpp"

#include "protocol/text.hpp"

#include <algorithm>
#include <fstream>
#include <random>
#include <string_view>

namespace raymarch::bench
{

Frames read_frames(const std::string& path)
{
    Frames frames;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (!line.starts_with('#'))
            frames.push_back(line);
    return frames;
}

Frames shuffled(const Frames& frames)
{
    std::mt19937 random(17); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same order in every run
    Frames result;
    for (const std::string& frame : frames) {
        std::vector<std::string_view> pairs;
        protocol::Text rest{.bytes = frame};
        for (bool more = true; more;) {
            const protocol::Piece pair = protocol::take_until(rest, ',');
            more = pair.found;
            pairs.push_back(pair.text.bytes);
        }
        std::ranges::shuffle(pairs, random);
        std::string& line = result.emplace_back();
        for (const std::string_view pair : pairs)
            line.append(line.empty() ? "" : ",").append(pair);
    }
    return result;
}

} // namespace raymarch::bench
