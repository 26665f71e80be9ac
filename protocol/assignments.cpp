// SPDX-License-Identifier: MIT
#include "protocol/assignments.hpp"

#include "protocol/plain_number.hpp"
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
    const bool has_rows = std::ranges::any_of(
        accelerator.parameters, [](const Parameter& parameter) { return parameter.is_row(); });
    return has_rows && std::ranges::all_of(key, [](char c) {
               return is_letter(c) || detail::is_digit(c) || c == '.';
           });
}

/// The name of a choice, as the table writes it, at the front of `text`: how long it is, or 0.
std::size_t choose_plain(const Parameter& parameter, std::string_view text,
                         std::int64_t& code) noexcept
{
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        const std::string_view name = parameter.choices[i];
        if (!text.starts_with(name) || (text.size() > name.size() && text[name.size()] != ','))
            continue;
        code = static_cast<std::int64_t>(i);
        return name.size();
    }
    return 0;
}

/// Whether `bytes` begin with `key` and an equals sign. Not starts_with(): for so few bytes, a call
/// of the C library costs more than they do.
bool begins_with_key(std::string_view bytes, std::string_view key) noexcept
{
    if (key.empty() || bytes.size() <= key.size() || bytes[key.size()] != '=')
        return false;
    for (std::size_t i = 0; i < key.size(); ++i)
        if (bytes[i] != key[i])
            return false;
    return true;
}

/// The parameter whose key stands at the front of `bytes`, or the size of the table.
std::size_t plain_key(const Accelerator& accelerator, std::string_view bytes,
                      std::size_t guess) noexcept
{
    const std::span<const Parameter> table = accelerator.parameters;
    if (guess < table.size() && begins_with_key(bytes, table[guess].key))
        return guess;
    std::size_t length = 0;
    while (length < bytes.size() && bytes[length] != '=' && bytes[length] != ',')
        ++length;
    const auto found = accelerator.keys.find(table, bytes.substr(0, length));
    return found && begins_with_key(bytes, table[*found].key) ? *found : table.size();
}

/// The fast path: pairs as hosts mostly write them, which are a key in upper case, a plain number
/// in range or the name of a choice, and no blanks. It takes such pairs off the front of `rest`;
/// the first other pair is left to be read by the rules, fault by fault. Returns whether the text
/// ended with a pair.
bool take_plain_pairs(const Accelerator& accelerator, Text& rest, State& state, ParameterSet& given,
                      std::size_t& guess) noexcept
{
    std::string_view bytes = rest.bytes;
    while (!bytes.empty()) {
        const std::size_t index = plain_key(accelerator, bytes, guess);
        if (index == accelerator.parameters.size() || given[index])
            break;
        const Parameter& parameter = accelerator.parameters[index];
        std::string_view value = bytes;
        value.remove_prefix(parameter.key.size() + 1);
        std::int64_t code = 0;
        const std::size_t length = parameter.is_choice() ? choose_plain(parameter, value, code)
                                                         : quantize_plain(parameter, value, code);
        if (length == 0 || (length < value.size() && value[length] != ','))
            break;
        state.codes[index] = code;
        given.set(index);
        guess = index + 1;
        if (length == value.size())
            return true;
        value.remove_prefix(length + 1);
        bytes = value;
    }
    rest = rest.from(rest.bytes.size() - bytes.size());
    return false;
}

tl::expected<WideCode, ErrorCode> read_value(const Parameter& parameter,
                                             std::string_view text) noexcept
{
    if (parameter.tail_bits > 0)
        return quantize_wide(parameter, text);
    if (!parameter.is_choice())
        return quantize(parameter, text).map([](std::int64_t code) { return WideCode{code, 0}; });
    if (const auto code = find_choice(parameter, text))
        return WideCode{*code, 0};
    return tl::unexpected(ErrorCode::Object);
}

} // namespace

std::optional<Fault> read_assignments(const Accelerator& accelerator, Text text, State& state,
                                      ParameterSet& given) noexcept
{
    Text rest = text.trimmed();
    std::size_t guess = 0;
    for (bool more = true; more;) {
        if (take_plain_pairs(accelerator, rest, state, given, guess))
            return std::nullopt;
        const Piece pair = take_until(rest, ',');
        more = pair.found;
        Text value = pair.text;
        const Piece before_equals = take_until(value, '=');
        const Text key = before_equals.text.trimmed();
        value = value.trimmed();

        if (!before_equals.found || !is_key(accelerator, key.bytes))
            return Fault{.code = ErrorCode::Syntax, .column = key.column};
        const auto index = find_parameter(accelerator, key.bytes, guess);
        if (!index)
            return Fault{.code = ErrorCode::UnknownKey, .column = key.column, .word = key.bytes};
        if (given[*index])
            return Fault{.code = ErrorCode::DuplicateKey, .column = key.column, .parameter = index};

        const auto code = read_value(accelerator.parameters[*index], value.bytes);
        if (!code)
            return Fault{.code = code.error(), .column = value.column, .parameter = index};
        state.codes[*index] = code->upper;
        if (accelerator.parameters[*index].tail_bits > 0)
            state.codes[*index + 1U] = code->tail;
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
    const ParameterSet missing = given.missing_of(accelerator.frame);
    if (!missing.any())
        return std::nullopt;
    return Fault{.code = ErrorCode::MissingKey, .missing = missing};
}

bool basis_is_orthonormal(const Accelerator& accelerator, const State& state) noexcept
{
    if (!accelerator.camera)
        return true;
    const OrbitCamera& camera = *accelerator.camera;
    // The code of a direction has at most 32 bits. The board multiplies two of them by one
    // instruction.
    const auto code = [&](ParameterIndex i) { return static_cast<std::int32_t>(state.codes[i]); };
    const auto dot = [&](const auto& a, const auto& b) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += std::int64_t{code(a[i])} * code(b[i]);
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
