// SPDX-License-Identifier: MIT
#include "daemon/state_file.hpp"

#include "base/crc32.hpp"
#include "protocol/assignments.hpp"
#include "protocol/reply.hpp"

#include <fmt/format.h>

namespace raymarch::daemon
{
namespace
{

constexpr std::string_view header = "raymarch-state 1\n";
constexpr std::string_view check = "crc32 ";

void append_line(std::string& text, std::string_view name, const protocol::Accelerator& accelerator,
                 const std::optional<protocol::State>& state)
{
    if (!state)
        return;
    protocol::ReplyWriter values;
    protocol::write_state(values, accelerator, *state);
    text += fmt::format("{} {} {}\n", name, accelerator.name, values.text());
}

std::string_view take_line(std::string_view& text)
{
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
}

std::string_view take_word(std::string_view& line)
{
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(word.size() + 1, line.size()));
    return word;
}

} // namespace

std::string format_state_file(const PersistedStates& states)
{
    std::string text(header);
    for (std::size_t i = 0; i < states.states.size(); ++i) {
        append_line(text, "last", *protocol::accelerators[i], states.states[i].last);
        append_line(text, "saved", *protocol::accelerators[i], states.states[i].saved);
    }
    text += states.others;
    text += fmt::format("{}{:08X}\n", check, crc32(text));
    return text;
}

Result<PersistedStates> parse_state_file(std::string_view text)
{
    const auto bad = [](std::string_view what) {
        return fail(plain_error(ErrorKind::BadData, std::string(what)));
    };
    const std::size_t check_at = text.rfind(check);
    if (!text.starts_with(header) || check_at == std::string_view::npos)
        return bad("it is not a state file of this version");
    if (text.substr(check_at) != fmt::format("{}{:08X}\n", check, crc32(text.substr(0, check_at))))
        return bad("its checksum is wrong");

    PersistedStates states;
    std::string_view rest = text.substr(header.size(), check_at - header.size());
    while (!rest.empty()) {
        const std::string_view whole_line = take_line(rest);
        std::string_view line = whole_line;
        const std::string_view name = take_word(line);
        if (name != "last" && name != "saved")
            return bad("a line in it is neither last nor saved");
        const protocol::Accelerator* const accelerator =
            protocol::find_accelerator(take_word(line));
        if (accelerator == nullptr) {
            states.others.append(whole_line).push_back('\n');
            continue;
        }
        protocol::State values = protocol::initial_state(*accelerator);
        if (protocol::read_frame(*accelerator, {.bytes = line}, values))
            return bad("a state in it is not a frame");
        PersistedState& state = states.of(*accelerator);
        (name == "saved" ? state.saved : state.last) = values;
    }
    return states;
}

} // namespace raymarch::daemon
