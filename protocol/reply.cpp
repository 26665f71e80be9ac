// SPDX-License-Identifier: MIT
#include "protocol/reply.hpp"

#include "protocol/checksum.hpp"
#include "protocol/commands.hpp"
#include "protocol/dequantizer.hpp"

#include <algorithm>
#include <charconv>

namespace raymarch::protocol
{
namespace
{

/// A reply repeats an unknown word in upper case, if it is not longer than this.
constexpr std::size_t longest_repeated_word = 32;

/// Finds the last parameter of the table within the table whose keys have this prefix.
const Parameter* last_of_table(const Accelerator& accelerator, std::string_view table) noexcept
{
    const Parameter* last = nullptr;
    for (const Parameter& parameter : accelerator.parameters)
        if (parameter.is_row() && parameter.key.starts_with(table) &&
            detail::is_digit(parameter.key[table.size()]))
            last = &parameter;
    return last;
}

void write_key(ReplyWriter& reply, const Accelerator& accelerator, const Fault& fault) noexcept
{
    if (fault.parameter) {
        reply << " key=" << accelerator.parameters[*fault.parameter].key;
    } else if (fault.code == ErrorCode::MissingKey) {
        std::string_view separator = " key=";
        for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
            if (!fault.missing[i])
                continue;
            reply << separator << accelerator.parameters[i].key;
            separator = ",";
        }
    } else if (!fault.word.empty() && fault.code != ErrorCode::UnknownCommand &&
               fault.word.size() <= longest_repeated_word) {
        reply << " key=";
        for (const char c : fault.word)
            reply << to_upper(c);
    }
}

void write_sentence(ReplyWriter& reply, const Accelerator& accelerator, const Fault& fault) noexcept
{
    if (!fault.allowed.empty()) {
        reply << fault.allowed;
        return;
    }
    if (fault.argument != nullptr) {
        reply << fault.argument->label << " is ";
        write_bounds(*fault.argument, [&](std::string_view text) { reply << text; });
        if (!fault.argument->unit.empty())
            reply << ' ' << fault.argument->unit;
        return;
    }
    const bool about_value = fault.code == ErrorCode::Number || fault.code == ErrorCode::Range ||
                             fault.code == ErrorCode::Object || fault.code == ErrorCode::Argument;
    if (about_value && fault.parameter) {
        const Parameter& parameter = accelerator.parameters[*fault.parameter];
        reply << parameter.key << " is ";
        write_allowed(reply, parameter);
        return;
    }
    reply << error_row(fault.code).meaning;
    if (fault.code == ErrorCode::UnknownKey) {
        reply << "; the keys are";
        write_keys(reply, accelerator);
    } else if (fault.code == ErrorCode::UnknownCommand) {
        reply << "; HELP lists them";
    }
}

} // namespace

void ReplyWriter::begin(bool checksummed) noexcept
{
    size_ = 0;
    line_begin_ = 0;
    checksummed_ = checksummed;
    overflowed_ = false;
}

ReplyWriter& ReplyWriter::operator<<(std::string_view text) noexcept
{
    const std::size_t fits = std::min(text.size(), buffer_.size() - size_);
    std::copy_n(text.data(), fits, buffer_.data() + size_);
    size_ += fits;
    overflowed_ |= fits < text.size();
    return *this;
}

ReplyWriter& ReplyWriter::operator<<(std::uint64_t number) noexcept
{
    std::array<char, 20> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return *this << std::string_view(digits.data(),
                                     static_cast<std::size_t>(end.ptr - digits.data()));
}

ReplyWriter& ReplyWriter::hex(std::uint32_t word) noexcept
{
    std::array<char, 8> digits{};
    for (std::size_t i = digits.size(); i-- > 0; word >>= 4)
        digits[i] = hex_digits[word & 0xF];
    return *this << std::string_view(digits.data(), digits.size());
}

void ReplyWriter::end_line() noexcept
{
    if (checksummed_) {
        const std::uint8_t sum = xor_of(text().substr(line_begin_));
        *this << '*' << hex_digits[sum >> 4] << hex_digits[sum & 0xF];
    }
    *this << "\r\n";
    line_begin_ = size_;
}

void write_fault(ReplyWriter& reply, const Accelerator& accelerator, const Fault& fault) noexcept
{
    reply << "ERR " << error_row(fault.code).name;
    if (fault.column > 0)
        reply << " col=" << std::uint64_t{fault.column};
    write_key(reply, accelerator, fault);
    reply << " : ";
    write_sentence(reply, accelerator, fault);
    reply.end_line();
}

void write_assignment(ReplyWriter& reply, const Accelerator& accelerator, const State& state,
                      std::size_t index) noexcept
{
    const Parameter& parameter = accelerator.parameters[index];
    const std::int64_t tail = parameter.tail_bits > 0 ? state.codes[index + 1] : 0;
    reply << parameter.key << '=' << to_text(parameter, state.codes[index], tail).view();
}

void write_state(ReplyWriter& reply, const Accelerator& accelerator, const State& state) noexcept
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        if (accelerator.parameters[i].is_tail())
            continue;
        if (i > 0)
            reply << ',';
        write_assignment(reply, accelerator, state, i);
    }
}

void write_words(ReplyWriter& reply, const Accelerator& accelerator, const Words& words) noexcept
{
    for (std::size_t i = 0; i < accelerator.word_count; ++i)
        (reply << ' ').hex(words[i]);
}

void write_keys(ReplyWriter& reply, const Accelerator& accelerator) noexcept
{
    // All keys, "S1.X S1.Y … S14.R", would fill a screen. So only the first row of such a table and
    // its last key are listed.
    std::string_view row;   // "S1", "S2": the row that the last key belongs to
    std::string_view table; // "S"
    for (const Parameter& parameter : accelerator.parameters) {
        if (!parameter.is_row()) {
            if (!parameter.is_tail())
                reply << ' ' << parameter.key;
            continue;
        }
        const std::string_view key = parameter.key;
        const std::string_view own_row = key.substr(0, key.find('.'));
        const std::string_view own_table = own_row.substr(0, own_row.find_first_of("0123456789"));
        if (own_table != table)
            row = own_row;
        table = own_table;
        if (own_row == row)
            reply << ' ' << key;
        else if (&parameter == last_of_table(accelerator, own_table))
            reply << " ... " << key;
    }
}

void write_allowed(ReplyWriter& reply, const Parameter& parameter) noexcept
{
    if (!parameter.is_choice()) {
        reply << "a number " << parameter.min << " to " << parameter.max;
        if (!parameter.unit.empty())
            reply << ' ' << parameter.unit;
        return;
    }
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        reply << (i == 0 ? "" : ", ") << parameter.choices[i];
    reply << " or 0 to " << std::uint64_t{parameter.choices.size() - 1};
}

} // namespace raymarch::protocol
