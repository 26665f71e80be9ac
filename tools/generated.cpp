// SPDX-License-Identifier: MIT
#include "tools/generated.hpp"

#include "daemon/actions.hpp"
#include "daemon/config.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/commands.hpp"
#include "protocol/dequantizer.hpp"
#include "protocol/errors.hpp"
#include "protocol/registers.hpp"
#include "protocol/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace raymarch::tools
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): prints its tables

/// A field of a word: bits `first` and up of the parameter of that key.
struct Field
{
    std::string_view key;
    Slice slice;
    bool whole; ///< the parameter stands nowhere else
    int first;
};

std::vector<Field> fields_of_word(const Accelerator& accelerator, std::size_t word)
{
    std::vector<Field> fields;
    std::string_view key;
    for (const Parameter& parameter : accelerator.parameters) {
        if (!parameter.is_tail())
            key = parameter.key;
        const bool whole =
            parameter.slice_count == 1 && parameter.tail_bits == 0 && !parameter.is_tail();
        for (const Slice& slice : parameter.placement())
            if (slice.word == word)
                fields.push_back({key, slice, whole, slice.shift + parameter.tail_bits});
    }
    std::ranges::sort(fields,
                      [](const Field& a, const Field& b) { return a.slice.msb > b.slice.msb; });
    return fields;
}

std::string_view name_of(Register at)
{
    return std::ranges::find(extended_registers, at, &RegisterRow::at)->name;
}

std::string format_name(const Format& format)
{
    const std::string_view sign = format.is_signed ? "signed" : "unsigned";
    if (format.fraction_bits == 0)
        return fmt::format("{}, {}", sign, format.width());
    return fmt::format("Q{}.{} {}, {}", format.integer_bits, format.fraction_bits, sign,
                       format.width());
}

std::string range_of(const Parameter& parameter)
{
    if (!parameter.is_choice())
        return fmt::format("{} .. {}", parameter.min, parameter.max);
    std::string text;
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        text += fmt::format("{}`{}` {}", i == 0 ? "" : ", ", parameter.choices[i], i);
    return text;
}

/// A `|` would end a cell.
std::string cell(std::string_view text)
{
    std::string result;
    for (const char c : text)
        result += c == '|' ? "\\|" : std::string(1, c);
    return result;
}

bool is_of_first_row(const Parameter& parameter)
{
    const std::string_view row = parameter.key.substr(0, parameter.key.find('.'));
    return row.ends_with('1') && !detail::is_digit(row[row.size() - 2]);
}

/// The key, or `S1.X` … `S14.X` for a column of a table within the table.
std::string key_range(const Accelerator& accelerator, const Parameter& parameter)
{
    if (!parameter.is_row())
        return std::string(parameter.key);
    const std::size_t dot = parameter.key.find('.');
    const std::string_view table = parameter.key.substr(0, dot - 1);
    const std::string_view column = parameter.key.substr(dot);
    std::string_view last;
    for (const Parameter& other : accelerator.parameters)
        if (other.key.starts_with(table) && other.key.ends_with(column) &&
            detail::is_digit(other.key[table.size()]))
            last = other.key;
    return fmt::format("{} to {}", parameter.key, last);
}

std::string place_of(const Parameter& parameter)
{
    return format_name(parameter.format) + (parameter.slice_count == 0 ? "; in no register" : "");
}

std::string upper(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), to_upper);
    return result;
}

std::string parameter_words(const Accelerator& accelerator)
{
    std::string page = fmt::format("## Parameter words of `{}`\n\n{}.\n\n"
                                   "| word | offset | fields, MSB to LSB |\n| --- | --- | --- |\n",
                                   accelerator.name, accelerator.summary);
    for (std::size_t word = 0; word < accelerator.word_count; ++word) {
        std::string fields;
        for (const Field& field : fields_of_word(accelerator, word)) {
            const std::string bits =
                field.whole
                    ? ""
                    : fmt::format("{{{}:{}}}", field.first + field.slice.width() - 1, field.first);
            fields += fmt::format("{}{}{}[{}:{}]", fields.empty() ? "" : " ", field.key, bits,
                                  field.slice.msb, field.slice.lsb);
        }
        page += fmt::format("| {} | 0x{:02X} | {} |\n", word,
                            accelerator.first_word_offset + 4 * word, fields);
    }
    const Words defaults = pack(accelerator, initial_state(accelerator));
    std::string words;
    for (std::size_t word = 0; word < accelerator.word_count; ++word)
        words += fmt::format("{}{:08X}", word == 0 ? "" : " ", defaults[word]);
    page +=
        fmt::format("\n`KEY{{b:a}}` are bits b to a of a parameter that spans words. Signed fields "
                    "are two's complement in their width.\nThe words of the defaults:\n\n    {}\n",
                    words);
    return page;
}

} // namespace

std::string registers_page()
{
    std::string page = "<!-- Made by dump_tables from protocol/; ./dev docs writes it again. -->\n"
                       "# The register block\n\n"
                       "One AXI-lite slave of 4 KiB with 32-bit words; a byte offset is 4 times a "
                       "word's index. An\n"
                       "accelerator without the extended registers (ID reads something else) has "
                       "its parameter words\n"
                       "only and is driven as well.\n\n";
    for (const Accelerator* accelerator : accelerators)
        page += parameter_words(*accelerator) + "\n";
    page += "## Extended registers\n\n| word | offset | name | access | |\n| --- | --- | --- | --- "
            "| --- |\n";
    for (const RegisterRow& row : extended_registers)
        page += fmt::format("| {} | 0x{:02X} | {} | {} | {} |\n", static_cast<unsigned>(row.at) / 4,
                            static_cast<unsigned>(row.at), row.name, row.access, cell(row.meaning));
    page +=
        "\nTheir fields; bits that no field has read as 0, and writes to them change nothing. "
        "Access w1c: a write\n"
        "of 1 clears the field; sc: it clears itself. Reset `fixed`: the logic says what it "
        "is.\n\n"
        "| register | bits | field | access | reset | |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const RegisterField& field : register_fields)
        page += fmt::format("| {} | {} | {} | {} | {} | {} |\n", name_of(field.at),
                            field.msb == field.lsb ? fmt::format("{}", field.lsb)
                                                   : fmt::format("{}:{}", field.msb, field.lsb),
                            field.name, field.access, field.reset, cell(field.meaning));
    page += "\nIn shadow mode the parameter words can be written at any time; they reach the ray "
            "units\n"
            "together, at the first frame start after a write to COMMIT. While STATUS says that a "
            "commit is\n"
            "pending the service writes no parameter word, as the frame start could fall between "
            "two of\n"
            "them: the newest state waits.\n\n"
            "The interrupt is level: high while STATUS.FRAME_DONE and CONTROL.INTERRUPT_ENABLE are "
            "set.\n"
            "Through UIO, a read of 4 bytes gives the count, a write of the 32-bit number 1 "
            "unmasks it again.\n";
    return page;
}

std::string parameters_section()
{
    std::string text;
    for (const Accelerator* accelerator : accelerators) {
        text +=
            fmt::format("\nParameters of `{}`:\n\n| key | meaning | unit | range | format, bits | "
                        "group | default |\n| --- | --- | --- | --- | --- | --- | --- |\n",
                        accelerator->name);
        for (const Parameter& parameter : accelerator->parameters) {
            if (parameter.is_tail() || (parameter.is_row() && !is_of_first_row(parameter)))
                continue;
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n",
                                key_range(*accelerator, parameter), cell(parameter.meaning),
                                parameter.unit, range_of(parameter), place_of(parameter),
                                parameter.group, parameter.initial);
        }
    }
    return text + "\n";
}

std::string commands_section()
{
    std::string text = "\n| command | does |\n| --- | --- |\n";
    for (const CommandRow& row : commands) {
        std::string syntax;
        std::string summary;
        write_syntax(row, [&](std::string_view piece) { syntax += piece; });
        write_summary(row, [&](std::string_view piece) { summary += piece; });
        text += fmt::format("| `{}{}{}` | {} |\n", row.name, syntax.empty() ? "" : " ",
                            cell(syntax), summary);
    }
    return text + "\n";
}

std::string errors_section()
{
    std::string text = "\n| code | means |\n| --- | --- |\n";
    for (const ErrorRow& row : errors)
        text += fmt::format("| {} | {} |\n", row.name, cell(row.meaning));
    return text + "\n";
}

std::string presets_section()
{
    std::string text;
    for (const Accelerator* accelerator : accelerators) {
        text += fmt::format("\nPresets of `{}`:\n\n| name | shows |\n| --- | --- |\n",
                            accelerator->name);
        for (const Preset& preset : accelerator->presets)
            text += fmt::format("| `{}` | {} |\n", preset.name, preset.summary);
    }
    return text + "\n";
}

std::string status_section()
{
    std::string text = "\n| key | value | present | meaning |\n| --- | --- | --- | --- |\n";
    for (const StatusRow& row : status_rows) {
        const std::string any = row.kind == StatusKind::Word ? "word" : "number";
        text += fmt::format("| {} | {} | {} | {} |\n", row.name,
                            row.value.empty() ? any : cell(row.value), row.present, row.meaning);
    }
    return text + "\n";
}

std::string settings_file()
{
    std::string text =
        "# raymarchd.toml: every setting with its default. The command line overrides this "
        "file;\n# raymarchd --check-config reports its errors.\n";
    for (const daemon::Setting& setting : daemon::settings()) {
        const bool unquoted = setting.initial == "true" || setting.initial == "false" ||
                              std::ranges::all_of(setting.initial, detail::is_digit);
        text += fmt::format(
            "\n# {}\n# {}\n#{} = {}\n", setting.meaning, setting.value, setting.name,
            unquoted ? std::string(setting.initial) : fmt::format("\"{}\"", setting.initial));
    }
    text +=
        fmt::format("\n# The line of each action of a button, a switch or an LED: none, or\n# {}\n"
                    "#[{}]\n",
                    daemon::line_values, daemon::lines_table);
    for (const daemon::Action& action : daemon::actions())
        text += fmt::format("\n# {}: {}\n#{} = \"{}\"\n", daemon::name_of(action.kind),
                            action.meaning, action.name, action.line);
    return text;
}

std::string actions_table()
{
    std::string text = "\n| action | kind | default line | on a PYNQ-Z1 | effect |\n"
                       "| --- | --- | --- | --- | --- |\n";
    for (const daemon::Action& action : daemon::actions())
        text +=
            fmt::format("| {} | {} | {} | {} | {} |\n", action.name, daemon::name_of(action.kind),
                        action.line, action.place, action.meaning);
    return text + "\n";
}

std::string actions_manual()
{
    std::string text;
    for (const daemon::Action& action : daemon::actions()) {
        std::string sentence(action.meaning);
        sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
        text += fmt::format(".TP\n.BR {} \" (\" {} \"), \" {}\n{}.\n", action.name,
                            daemon::name_of(action.kind), action.line, sentence);
    }
    return text;
}

std::string systemverilog_package()
{
    std::string text =
        "// SPDX-License-Identifier: MIT\n"
        "// Made by dump_tables from protocol/; ./dev docs writes it again.\n"
        "//\n"
        "// A function NAME_KEY gives the code of a parameter. Its argument is all\n"
        "// parameter words of NAME as one vector, with word 0 in bits 31:0. Yosys 0.23\n"
        "// and Verilator 5.006 read this file: they take neither an unpacked argument\n"
        "// nor `return`.\n"
        "package raymarch_registers_pkg;\n"
        "  /* verilator lint_off UNUSEDPARAM */\n"
        "  /* verilator lint_off UNUSEDSIGNAL */\n\n"
        "  // Byte offsets of the extended registers\n";
    for (const RegisterRow& row : extended_registers)
        text += fmt::format("  localparam logic [11:0] {}_OFFSET = 12'h{:03X};\n", row.name,
                            static_cast<unsigned>(row.at));
    text += fmt::format("  localparam logic [31:0] ID_VALUE = 32'h{:08X};\n\n"
                        "  // The highest and the lowest bit of each of their fields\n",
                        id_value);
    for (const RegisterField& field : register_fields)
        text += fmt::format(
            "  localparam int {0}_{1}_MSB = {2};\n  localparam int {0}_{1}_LSB = {3};\n",
            name_of(field.at), field.name, field.msb, field.lsb);
    for (const Accelerator* accelerator : accelerators) {
        const std::string prefix = upper(accelerator->name);
        text += fmt::format("\n  // {}: {}\n", accelerator->name, accelerator->summary);
        text += fmt::format("  localparam int {}_KIND = {};\n", prefix, accelerator->kind);
        text += fmt::format("  localparam int {}_WORDS = {};\n", prefix, accelerator->word_count);
        for (std::size_t i = 0; i < accelerator->parameters.size(); ++i) {
            const Parameter& parameter = accelerator->parameters[i];
            if (parameter.is_tail() || parameter.slice_count == 0)
                continue;
            std::string slices;
            for (std::size_t part = i; part <= i + (parameter.tail_bits > 0 ? 1 : 0); ++part)
                for (const Slice& slice : accelerator->parameters[part].placement())
                    slices += fmt::format("{}words[{}:{}]", slices.empty() ? "" : ", ",
                                          32 * slice.word + slice.msb, 32 * slice.word + slice.lsb);
            std::string name(parameter.key);
            std::ranges::replace(name, '.', '_');
            text +=
                fmt::format("  function automatic logic {0}[{1}:0] {2}_{3}(input logic "
                            "[32*{4}_WORDS-1:0] words);\n"
                            "    {2}_{3} = {{{5}}};\n  endfunction\n",
                            parameter.format.is_signed ? "signed " : "",
                            parameter.format.width() - 1, accelerator->name, name, prefix, slices);
        }
    }
    return text + "\nendpackage\n";
}

} // namespace raymarch::tools
