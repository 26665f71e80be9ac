// SPDX-License-Identifier: MIT
#include "protocol/assignments.hpp"

#include "protocol/quantizer.hpp"

#include <algorithm>

namespace raymarch::protocol
{
namespace
{

/// Keys are letters; where a table has rows ("S2.X"), digits and dots may follow the first letter.
bool is_key(const Accelerator& accelerator, std::string_view key) noexcept
{
    if (key.empty() || !is_letter(key[0]))
        return false;
    if (std::ranges::all_of(key, is_letter))
        return true;
    const bool has_rows =
        std::ranges::any_of(accelerator.parameters, [](const Parameter& parameter) {
            return parameter.key.find('.') != std::string_view::npos;
        });
    return has_rows && std::ranges::all_of(key, [](char c) {
               return is_letter(c) || detail::is_digit(c) || c == '.';
           });
}

/// Whether `text` begins with `key=`, as the table writes it.
bool begins_with_key(std::string_view text, std::string_view key) noexcept
{
    return text.size() > key.size() && text[key.size()] == '=' && text.starts_with(key);
}

/// A pair as hosts mostly write it: the key in upper case, no blanks, a plain number that is in
/// range. Takes it off the front of `rest` up to its comma, or to the end; false, and nothing
/// taken, for any other pair, which is then read by the rules, fault by fault.
bool take_plain_pair(std::span<const Parameter> table, Text& rest, State& state,
                     ParameterSet& given, std::size_t& guess) noexcept
{
    std::size_t index = guess;
    if (index >= table.size() || !begins_with_key(rest.bytes, table[index].key))
        for (index = 0; index < table.size(); ++index)
            if (begins_with_key(rest.bytes, table[index].key))
                break;
    if (index == table.size() || given[index] || table[index].is_choice())
        return false;
    const std::size_t value_at = table[index].key.size() + 1;
    std::int64_t code = 0;
    const std::size_t length = quantize_plain(table[index], rest.bytes.substr(value_at), code);
    const std::size_t end = value_at + length;
    if (length == 0 || (end < rest.bytes.size() && rest.bytes[end] != ','))
        return false;
    state.codes[index] = code;
    given.set(index);
    guess = index + 1;
    rest = rest.from(end);
    return true;
}

tl::expected<std::int64_t, ErrorCode> read_value(const Parameter& parameter,
                                                 std::string_view text) noexcept
{
    if (!parameter.is_choice())
        return quantize(parameter, text);
    if (const auto code = find_choice(parameter, text))
        return *code;
    return tl::unexpected(ErrorCode::Object);
}

} // namespace

std::optional<Fault> read_assignments(const Accelerator& accelerator, Text text, State& state,
                                      ParameterSet& given) noexcept
{
    Text rest = text.trimmed();
    std::size_t guess = 0;
    for (bool more = true; more;) {
        if (take_plain_pair(accelerator.parameters, rest, state, given, guess)) {
            if (rest.empty())
                return std::nullopt;
            rest = rest.from(1); // the comma
            continue;
        }
        const Piece pair = take_until(rest, ',');
        more = pair.found;
        Text value = pair.text;
        const Piece before_equals = take_until(value, '=');
        const Text key = before_equals.text.trimmed();
        value = value.trimmed();

        if (!before_equals.found || !is_key(accelerator, key.bytes))
            return Fault{.code = ErrorCode::Syntax, .column = key.column};
        const auto index = find_parameter(accelerator.parameters, key.bytes, guess);
        if (!index)
            return Fault{.code = ErrorCode::UnknownKey, .column = key.column, .word = key.bytes};
        if (given[*index])
            return Fault{.code = ErrorCode::DuplicateKey, .column = key.column, .parameter = index};

        const auto code = read_value(accelerator.parameters[*index], value.bytes);
        if (!code)
            return Fault{.code = code.error(), .column = value.column, .parameter = index};
        state.codes[*index] = *code;
        given.set(*index);
        guess = *index + 1U;
    }
    return std::nullopt;
}

std::optional<Fault> read_frame(const Accelerator& accelerator, Text text, State& state) noexcept
{
    ParameterSet given;
    if (auto fault = read_assignments(accelerator, text, state, given))
        return fault;
    if (given.count() == accelerator.parameters.size())
        return std::nullopt;
    Fault fault{.code = ErrorCode::MissingKey};
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        fault.missing.set(i, !given[i]);
    return fault;
}

bool basis_is_orthonormal(const Accelerator& accelerator, const State& state) noexcept
{
    if (!accelerator.camera)
        return true;
    const OrbitCamera& camera = *accelerator.camera;
    const auto dot = [&](const auto& a, const auto& b) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += state.codes[a[i]] * state.codes[b[i]];
        return sum;
    };
    // Codes have f fraction bits, their products 2f; 1.01^2 and 0.99^2 in ten-thousandths.
    const int f = accelerator.parameters[camera.forward[0]].format.fraction_bits;
    const std::int64_t one = std::int64_t{1} << (2 * f);
    const auto unit_length = [&](const auto& a) {
        const std::int64_t squared = dot(a, a) * 10'000;
        return squared >= 9801 * one && squared <= 10'201 * one;
    };
    const auto right_angle = [&](const auto& a, const auto& b) {
        const std::int64_t cosine = dot(a, b) * 100;
        return cosine >= -one && cosine <= one;
    };
    return unit_length(camera.forward) && unit_length(camera.right) && unit_length(camera.up) &&
           right_angle(camera.forward, camera.right) && right_angle(camera.forward, camera.up) &&
           right_angle(camera.right, camera.up);
}

} // namespace raymarch::protocol
