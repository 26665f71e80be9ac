// SPDX-License-Identifier: MIT
#include "protocol/arguments.hpp"

#include "protocol/quantizer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace raymarch::protocol
{
namespace
{

using Triple = std::array<double, 3>;

tl::expected<double, Fault> read_number(Text text, const ArgumentRange& range) noexcept
{
    const auto exact = parse_decimal(text.bytes);
    if (!exact || compare(*exact, *parse_decimal(range.min)) < 0 ||
        compare(*exact, *parse_decimal(range.max)) > 0)
        return tl::unexpected(argument_fault(text, range.allowed));
    std::string_view digits = text.bytes;
    if (digits.starts_with('+')) // the grammar allows a plus sign, from_chars does not
        digits.remove_prefix(1);
    double value = 0; // from_chars leaves this value if the number is too small for a double
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// Rounds to the nearest code and clamps it to the format.
std::int64_t nearest_code(const Parameter& parameter, double value) noexcept
{
    const double code = std::nearbyint(std::ldexp(value, parameter.format.fraction_bits));
    return std::clamp(static_cast<std::int64_t>(code), parameter.format.min_code(),
                      parameter.format.max_code());
}

void set_triple(const Accelerator& accelerator, const std::array<ParameterIndex, 3>& where,
                const Triple& values, State& state) noexcept
{
    for (std::size_t i = 0; i < 3; ++i)
        state.codes[where[i]] = nearest_code(accelerator.parameters[where[i]], values[i]);
}

void set_hue(const Accelerator& accelerator, double hue, State& state) noexcept
{
    const double sextant = std::floor(hue * 6.0);
    const double rising = hue * 6.0 - sextant;
    const double falling = 1.0 - rising;
    const std::array<Triple, 6> wheel = {{{1, rising, 0},
                                          {falling, 1, 0},
                                          {0, 1, rising},
                                          {0, falling, 1},
                                          {rising, 0, 1},
                                          {1, 0, falling}}};
    set_triple(accelerator, accelerator.colour->channels,
               wheel[static_cast<std::size_t>(sextant) % wheel.size()], state);
}

} // namespace

Fault argument_fault(Text at, std::string_view allowed) noexcept
{
    return {.code = ErrorCode::Argument, .column = at.column, .allowed = allowed};
}

void set_orbit(const Accelerator& accelerator, double yaw_degrees, double pitch_degrees,
               State& state) noexcept
{
    constexpr double radians = std::numbers::pi / 180.0;
    const double yaw = std::fmod(yaw_degrees, 360.0) * radians;
    const double pitch = pitch_degrees * radians;
    const Triple forward = {std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                            std::cos(pitch) * std::cos(yaw)};
    const Triple right = {std::cos(yaw), 0.0, -std::sin(yaw)};
    const Triple up = {forward[1] * right[2] - forward[2] * right[1],
                       forward[2] * right[0] - forward[0] * right[2],
                       forward[0] * right[1] - forward[1] * right[0]};
    set_triple(accelerator, accelerator.camera->forward, forward, state);
    set_triple(accelerator, accelerator.camera->right, right, state);
    set_triple(accelerator, accelerator.camera->up, up, state);
}

tl::expected<WordAndCount, Fault> read_word_and_count(Text words, unsigned otherwise, unsigned most,
                                                      std::string_view allowed) noexcept
{
    const std::size_t end = std::min(words.bytes.find_first_of(" \t"), words.bytes.size());
    WordAndCount result{.word = words.first(end), .count = otherwise};
    const Text number = words.from(end).trimmed();
    if (number.empty())
        return result;
    const char* const last = number.bytes.data() + number.bytes.size();
    const auto parsed = std::from_chars(number.bytes.data(), last, result.count);
    if (parsed.ec != std::errc{} || parsed.ptr != last || result.count < 1 || result.count > most)
        return tl::unexpected(argument_fault(number, allowed));
    return result;
}

std::optional<Fault> apply_view(const Accelerator& accelerator, Text words, State& state) noexcept
{
    if (!accelerator.camera)
        return argument_fault(words, "this accelerator has no orbit camera");
    Text rest = words;
    const Text yaw_text = take_until(rest, ',').text.trimmed();
    const Text pitch_text = take_until(rest, ',').text.trimmed();
    const Piece zoom_piece = take_until(rest, ',');
    const Text zoom_text = zoom_piece.text.trimmed();

    const auto yaw = read_number(yaw_text, yaw_range);
    if (!yaw)
        return yaw.error();
    const auto pitch = read_number(pitch_text, pitch_range);
    if (!pitch)
        return pitch.error();
    const ParameterIndex zoom = accelerator.camera->zoom;
    const auto zoom_code = quantize(accelerator.parameters[zoom], zoom_text.bytes);
    if (!zoom_code) {
        Fault fault = argument_fault(zoom_text, {});
        fault.parameter = zoom; // the reply then tells the range of the zoom
        return fault;
    }
    if (zoom_piece.found)
        return argument_fault(rest.trimmed(), "VIEW takes three numbers: yaw,pitch,zoom");
    set_orbit(accelerator, *yaw, *pitch, state);
    state.codes[zoom] = *zoom_code;
    return std::nullopt;
}

std::optional<Fault> apply_hue(const Accelerator& accelerator, Text words, State& state) noexcept
{
    if (!accelerator.colour)
        return argument_fault(words, "this accelerator has no colour to set by hue");
    Text rest = words;
    const Piece piece = take_until(rest, ',');
    const auto hue = read_number(piece.text.trimmed(), hue_range);
    if (!hue)
        return hue.error();
    if (piece.found)
        return argument_fault(rest.trimmed(), "HUE takes one number");
    set_hue(accelerator, *hue, state);
    return std::nullopt;
}

void randomise(const Accelerator& accelerator, std::string_view group, std::mt19937_64& random,
               State& state) noexcept
{
    const auto in_group = [&](std::size_t i) {
        return group.empty() || accelerator.parameters[i].group == group;
    };
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const Parameter& parameter = accelerator.parameters[i];
        // At the upper end of the range only an empty tail is valid, so this end is left out.
        const std::int64_t largest = std::min(
            parameter.max_scaled - (parameter.tail_bits > 0 ? 1 : 0), parameter.largest_code);
        if (in_group(i))
            state.codes[i] = std::uniform_int_distribution(parameter.min_scaled, largest)(random);
    }
    if (accelerator.camera && in_group(accelerator.camera->zoom)) {
        const double yaw = std::uniform_real_distribution(0.0, 360.0)(random);
        // If the sine of the pitch is uniform, the points are uniform on the sphere. The poles
        // are left out.
        const double sine = std::uniform_real_distribution(-0.999, 0.999)(random);
        const double pitch = std::asin(sine) * 180.0 / std::numbers::pi;
        set_orbit(accelerator, yaw, pitch, state);
    }
    if (accelerator.colour && in_group(accelerator.colour->channels[0]))
        set_hue(accelerator, std::uniform_real_distribution(0.0, 1.0)(random), state);
}

void reset(const Accelerator& accelerator, std::string_view group, State& state) noexcept
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        if (group.empty() || accelerator.parameters[i].group == group)
            state.codes[i] = accelerator.parameters[i].initial_code;
}

std::optional<std::string_view> find_group(const Accelerator& accelerator,
                                           std::string_view name) noexcept
{
    for (const Parameter& parameter : accelerator.parameters)
        if (equal_ignoring_case(parameter.group, name))
            return parameter.group;
    return std::nullopt;
}

} // namespace raymarch::protocol
