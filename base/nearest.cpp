// SPDX-License-Identifier: MIT
#include "base/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace raymarch
{
namespace
{

constexpr std::size_t max_distance = 2;

constexpr char lower(char c) noexcept
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::size_t edit_distance(std::string_view one, std::string_view other)
{
    // The table holds the distances between all prefixes of both words. Three of its rows are kept.
    std::vector<std::size_t> before(other.size() + 1);
    std::vector<std::size_t> last(other.size() + 1);
    std::vector<std::size_t> row(other.size() + 1);
    const auto same = [&](std::size_t i, std::size_t j) {
        return lower(one[i - 1]) == lower(other[j - 1]);
    };
    for (std::size_t j = 0; j <= other.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= one.size(); ++i) {
        std::swap(before, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= other.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(i, j) ? 0 : 1)});
            if (i > 1 && j > 1 && same(i, j - 1) && same(i - 1, j))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row.back();
}

std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates)
{
    std::optional<std::string_view> found;
    std::size_t least = max_distance + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t shorter = std::min(word.size(), candidate.size());
        if (longer - shorter > max_distance) // this also limits the work for a very long word
            continue;
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least && 3 * distance <= longer) {
            found = candidate;
            least = distance;
        }
    }
    return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates)
{
    const auto meant = nearest(word, candidates);
    return meant ? fmt::format("; did you mean '{}'?", *meant) : std::string();
}

} // namespace raymarch
