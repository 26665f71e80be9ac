// SPDX-License-Identifier: MIT
#include "cli/moves.hpp"

#include "motion/directions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace raymarch::cli
{
namespace
{

constexpr std::string_view turn_prefix = "turn-";
constexpr std::string_view animate = "animate";

/// WALK and TURN share the names of four directions, so those of TURN have a prefix.
std::optional<motion::Input> input_of(std::string_view word)
{
    if (protocol::equal_ignoring_case(word, animate))
        return motion::Input::Animate;
    if (protocol::equal_ignoring_case(word.substr(0, turn_prefix.size()), turn_prefix))
        return motion::turn_input(word.substr(turn_prefix.size()));
    return motion::walk_input(word);
}

} // namespace

Result<motion::Inputs> parse_moves(std::string_view text)
{
    motion::Inputs inputs;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        const std::string_view word = text.substr(0, comma);
        const auto input = input_of(word);
        if (!input)
            return fail(plain_error(
                ErrorKind::Usage,
                fmt::format("--move: there is no movement '{}'; the movements are {}, {}{}, {}",
                            word, fmt::join(protocol::walk_directions, ", "), turn_prefix,
                            fmt::join(protocol::turn_directions, fmt::format(", {}", turn_prefix)),
                            animate)));
        inputs = inputs | *input;
        more = comma != std::string_view::npos;
        text.remove_prefix(more ? comma + 1 : text.size());
    }
    return inputs;
}

} // namespace raymarch::cli
