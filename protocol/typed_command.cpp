// SPDX-License-Identifier: MIT
#include "protocol/typed_command.hpp"

namespace raymarch::protocol
{
namespace
{

/// Whether an argument goes on to the end of the line, blanks included.
constexpr bool takes_the_rest(ArgumentKind kind) noexcept
{
    using enum ArgumentKind;
    return kind == Assignments || kind == Keys || kind == Preset ||
           kind == ArgumentKind::Accelerator || kind == Topic;
}

} // namespace

ArgumentTexts split_arguments(const CommandRow& row, Text words) noexcept
{
    ArgumentTexts texts;
    const std::size_t count = row.argument_count();
    if (count == 0)
        return texts;
    if (row.separator == ',') {
        bool more = false;
        for (std::size_t i = 0; i < count; ++i) {
            const Piece piece = take_until(words, ',');
            texts.each[i] = piece.text.trimmed();
            more = piece.found;
        }
        if (more)
            texts.excess = words.trimmed();
        return texts;
    }
    for (std::size_t i = 0; i < count; ++i) {
        // The last of several arguments takes the rest of the line: what is too much is its fault.
        const ArgumentKind kind = row.arguments[i].kind;
        const bool takes_rest = takes_the_rest(kind) || (i > 0 && i + 1 == count);
        const std::size_t end =
            takes_rest ? words.bytes.size()
                       : std::min(words.bytes.find_first_of(" \t"), words.bytes.size());
        texts.each[i] = words.first(end);
        words = words.from(end).trimmed();
    }
    if (!words.empty())
        texts.excess = words;
    return texts;
}

std::optional<Fault> check_command(const CommandRow& row, Text words,
                                   const Accelerator& accelerator) noexcept
{
    if (words.empty() ? row.needs_argument() : row.argument_count() == 0)
        return argument_fault(words, {});
    if (row.needs == Needs::OrbitCamera && !accelerator.camera)
        return argument_fault(words, "this accelerator has no orbit camera");
    if (row.needs == Needs::Colour && !accelerator.colour)
        return argument_fault(words, "this accelerator has no colour to set by hue");
    return std::nullopt;
}

std::optional<Fault> check_arguments(const CommandRow& row, const ArgumentTexts& texts) noexcept
{
    if (texts.excess)
        return argument_fault(*texts.excess, row.excess);
    for (std::size_t i = 1; i < row.argument_count(); ++i) {
        const ArgumentRow& argument = row.arguments[i];
        if (!argument.only_after.empty() && !texts.each[i].empty() &&
            !equal_ignoring_case(texts.each[i - 1].bytes, argument.only_after))
            return argument_fault(texts.each[i], argument.misplaced);
    }
    return std::nullopt;
}

} // namespace raymarch::protocol
