// SPDX-License-Identifier: MIT
#include "protocol/argument_values.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/decimal.hpp"
#include "protocol/groups.hpp"
#include "protocol/quantizer.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

namespace raymarch::protocol
{
namespace
{

Fault bounds_fault(Text at, const ArgumentRow& row) noexcept
{
    return {.code = ErrorCode::Argument, .column = at.column, .argument = &row};
}

tl::unexpected<Fault> wrong(Text at, const ArgumentRow& row) noexcept
{
    return tl::unexpected(argument_fault(at, row.wrong));
}

} // namespace

Fault argument_fault(Text at, std::string_view allowed) noexcept
{
    return {.code = ErrorCode::Argument, .column = at.column, .allowed = allowed};
}

Reading<const State*> read_pairs(const ArgumentRow& /*row*/, Text text,
                                 const ReadingContext& context) noexcept
{
    context.result = context.present;
    ParameterSet given;
    if (auto fault = read_assignments(context.accelerator, text, context.result, given))
        return tl::unexpected(*fault);
    return &context.result;
}

Reading<KeyList> read_keys(const ArgumentRow& row, Text text,
                           const ReadingContext& context) noexcept
{
    KeyList keys;
    ParameterSet given;
    for (bool more = true; more;) {
        const Piece piece = take_until(text, ',');
        more = piece.found;
        const Text key = piece.text.trimmed();
        const auto index = find_parameter(context.accelerator, key.bytes);
        if (!index || given[*index]) {
            Fault fault = argument_fault(key, row.wrong);
            if (std::ranges::all_of(key.bytes, is_letter))
                fault.word = key.bytes;
            return tl::unexpected(fault);
        }
        given.set(*index);
        keys.indices.push_back(*index);
    }
    return keys;
}

Reading<double> read_number(const ArgumentRow& row, Text text,
                            const ReadingContext& /*context*/) noexcept
{
    const auto exact = parse_decimal(text.bytes);
    if (!exact || compare(*exact, *parse_decimal(row.min)) < 0 ||
        compare(*exact, *parse_decimal(row.max)) > 0)
        return tl::unexpected(bounds_fault(text, row));
    std::string_view digits = text.bytes;
    if (digits.starts_with('+')) // the grammar allows a plus sign, from_chars does not
        digits.remove_prefix(1);
    double value = 0; // from_chars leaves this value if the number is too small for a double
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

Reading<std::int64_t> read_zoom(const ArgumentRow& /*row*/, Text text,
                                const ReadingContext& context) noexcept
{
    const ParameterIndex zoom = context.accelerator.camera->zoom;
    const auto code = quantize(context.accelerator.parameters[zoom], text.bytes);
    if (code)
        return *code;
    Fault fault = argument_fault(text, {});
    fault.parameter = zoom; // the reply then tells the range of the zoom
    return tl::unexpected(fault);
}

Reading<unsigned> read_count(const ArgumentRow& row, Text text,
                             const ReadingContext& /*context*/) noexcept
{
    const auto whole_number = [](std::string_view digits) -> std::optional<unsigned> {
        unsigned value = 0;
        const char* const end = digits.data() + digits.size();
        const auto parsed = std::from_chars(digits.data(), end, value);
        if (parsed.ec != std::errc{} || parsed.ptr != end)
            return std::nullopt;
        return value;
    };
    const auto count = whole_number(text.bytes);
    if (!count || *count < whole_number(row.min) || *count > whole_number(row.max))
        return tl::unexpected(bounds_fault(text, row));
    return *count;
}

Reading<std::size_t> read_choice(const ArgumentRow& row, Text text,
                                 const ReadingContext& /*context*/) noexcept
{
    for (std::size_t i = 0; i < row.names.size(); ++i)
        if (equal_ignoring_case(row.names[i], text.bytes))
            return i;
    return wrong(text, row);
}

Reading<std::string_view> read_group(const ArgumentRow& row, Text text,
                                     const ReadingContext& context) noexcept
{
    if (const auto group = find_group(context.accelerator, text.bytes))
        return *group;
    return wrong(text, row);
}

Reading<std::size_t> read_preset(const ArgumentRow& row, Text text,
                                 const ReadingContext& context) noexcept
{
    for (std::size_t i = 0; i < context.accelerator.presets.size(); ++i)
        if (equal_ignoring_case(context.accelerator.presets[i].name, text.bytes))
            return i;
    return wrong(text, row);
}

Reading<const Accelerator*> read_accelerator(const ArgumentRow& row, Text text,
                                             const ReadingContext& /*context*/) noexcept
{
    if (const Accelerator* const accelerator = find_accelerator(text.bytes))
        return accelerator;
    return wrong(text, row);
}

} // namespace raymarch::protocol
