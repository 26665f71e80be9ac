// SPDX-License-Identifier: MIT
#include "bench/command_baselines.hpp"

#include "protocol/accelerators/marcher.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace raymarch::bench
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace)

constexpr auto& table = marcher::parameters;
constexpr std::size_t numbers = marcher::OBJ; // all but the last are

/// A row of the table as a program that computes in double wants it.
struct Row
{
    std::string_view key;
    double min;
    double max;
    double scale;
    double largest;
};

std::array<Row, numbers> make_rows()
{
    std::array<Row, numbers> rows;
    for (std::size_t i = 0; i < numbers; ++i) {
        const double scale = std::ldexp(1.0, table[i].format.fraction_bits);
        rows[i] = {.key = table[i].key,
                   .min = static_cast<double>(table[i].min_scaled) / scale,
                   .max = static_cast<double>(table[i].max_scaled) / scale,
                   .scale = scale,
                   .largest = static_cast<double>(table[i].largest_code)};
    }
    return rows;
}

const std::array<Row, numbers> rows = make_rows();

/// Checked, scaled, to the nearest code with ties to even. Adding 1.5 * 2^52 and taking it away
/// again rounds a double to an integer; std::nearbyint() is a call, without SSE4.1.
bool quantize(std::size_t index, double value, State& state)
{
    const Row& row = rows[index];
    if (!(value >= row.min && value <= row.max))
        return false;
    constexpr double to_integer = 6755399441055744.0;
    const double code = (value * row.scale + to_integer) - to_integer;
    state.codes[index] = static_cast<std::int64_t>(std::min(code, row.largest));
    return true;
}

bool choose(std::string_view name, State& state)
{
    for (std::size_t i = 0; i < marcher::scenes.size(); ++i) {
        if (name != marcher::scenes[i])
            continue;
        state.codes[marcher::OBJ] = static_cast<std::int64_t>(i);
        return true;
    }
    return false;
}

/// Where the key that `rest` begins with stands in the table; its size for none.
std::size_t find_key(std::string_view rest, std::size_t guess)
{
    const auto matches = [&](std::size_t i) {
        const std::string_view key = table[i].key;
        return rest.starts_with(key) && rest.size() > key.size() && rest[key.size()] == '=';
    };
    if (guess < table.size() && matches(guess))
        return guess;
    std::size_t index = 0;
    while (index < table.size() && !matches(index))
        ++index;
    return index;
}

/// The loop over pairs, with `read(first, last, value)` for a number; it returns the number's end,
/// or nullptr.
template <typename Read>
bool read_pairs(const std::string& line, State& state, Read read)
{
    std::string_view rest = line;
    std::uint32_t given = 0;
    for (std::size_t guess = 0;; ++guess) {
        const std::size_t index = find_key(rest, guess);
        if (index == table.size() || (given >> index & 1) != 0)
            return false;
        given |= 1U << index;
        guess = index;
        rest.remove_prefix(table[index].key.size() + 1);
        if (index == marcher::OBJ) {
            const std::size_t end = std::min(rest.find(','), rest.size());
            if (!choose(rest.substr(0, end), state))
                return false;
            rest.remove_prefix(end);
        } else {
            double value = 0;
            const char* const end = read(rest.data(), rest.data() + rest.size(), value);
            if (end == nullptr || !quantize(index, value, state))
                return false;
            rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        }
        if (rest.empty())
            return given == (1U << table.size()) - 1;
        if (rest[0] != ',')
            return false;
        rest.remove_prefix(1);
    }
}

/// "FX=%lf,FY=%lf,…,OBJ=%15[a-z_]%n"
std::string make_format()
{
    std::string format;
    for (std::size_t i = 0; i < numbers; ++i)
        format.append(table[i].key).append("=%lf,");
    return format.append(table[marcher::OBJ].key).append("=%15[a-z_]%n");
}

template <std::size_t... I>
bool scan_all(const std::string& line, State& state, std::index_sequence<I...> /*numbers*/)
{
    static const std::string format = make_format();
    std::array<double, numbers> values{};
    std::array<char, 16> name{};
    int length = 0;
    const int found =
        std::sscanf(line.c_str(), format.c_str(), &values[I]..., name.data(), &length);
    return found == static_cast<int>(table.size()) &&
           static_cast<std::size_t>(length) == line.size() &&
           (quantize(I, values[I], state) && ...) && choose(name.data(), state);
}

} // namespace

bool sscanf_in_order(const std::string& line, State& state)
{
    return scan_all(line, state, std::make_index_sequence<numbers>());
}

bool sscanf_any_order(const std::string& line, State& state)
{
    return read_pairs(line, state, [](const char* first, const char* /*last*/, double& value) {
        int length = 0;
        return std::sscanf(first, "%lf%n", &value, &length) == 1 ? first + length : nullptr;
    });
}

bool with_from_chars(const std::string& line, State& state)
{
    return read_pairs(line, state, [](const char* first, const char* last, double& value) {
        const auto [end, error] = std::from_chars(first, last, value);
        return error == std::errc() ? end : nullptr;
    });
}

bool with_fast_float(const std::string& line, State& state)
{
    return read_pairs(line, state, [](const char* first, const char* last, double& value) {
        const auto [end, error] = fast_float::from_chars(first, last, value);
        return error == std::errc() ? end : nullptr;
    });
}

} // namespace raymarch::bench
