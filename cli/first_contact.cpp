// SPDX-License-Identifier: MIT
/// @file
/// The first contact of a Connection brings the line to a known state.
///
/// An LF ends half a line of an earlier host. Then a command follows whose reply is unique: GET
/// with keys in a random order, or with a random word that its ERR repeats. All lines before that
/// reply are dropped. The random order is tried first, because it is not an error and does not
/// change STATUS. It needs the keys, and so the name of the accelerator. All commands carry marks,
/// because the service may have `require_checksum`.
#include "cli/connection.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace raymarch::cli
{
namespace
{

/// The timeout for the reply to a command. A silent far end costs two of them; the rest of
/// reply_timeout is left for the user's line.
constexpr std::chrono::milliseconds silence{1000};
/// The limit for a far end that sends without a pause.
constexpr std::chrono::seconds longest_contact{10};

constexpr std::size_t key_count = 5;
constexpr std::size_t word_length = 16;

std::string random_word()
{
    std::random_device random;
    std::string word;
    while (word.size() < word_length)
        word += static_cast<char>('A' + random() % 26);
    return word;
}

/// Returns keys of the accelerator in random order, joined by commas.
std::string random_keys(const protocol::Accelerator& accelerator)
{
    std::vector<std::string_view> keys;
    for (const protocol::Parameter& parameter : accelerator.parameters)
        if (!parameter.is_tail())
            keys.push_back(parameter.key);
    std::random_device random;
    std::ranges::shuffle(keys, random);
    keys.resize(std::min(keys.size(), key_count));
    return fmt::format("{}", fmt::join(keys, ","));
}

/// Returns the keys of `OK KEY=VALUE,KEY=VALUE`, joined by commas.
std::string keys_of(std::string_view reply)
{
    constexpr std::string_view front = "OK ";
    std::string keys;
    if (!reply.starts_with(front))
        return keys;
    reply.remove_prefix(front.size());
    while (!reply.empty()) {
        const std::string_view pair = reply.substr(0, reply.find(','));
        keys.append(keys.empty() ? "" : ",").append(pair.substr(0, pair.find('=')));
        reply.remove_prefix(std::min(pair.size() + 1, reply.size()));
    }
    return keys;
}

bool repeats(std::string_view reply, std::string_view word)
{
    return is_err(reply) && reply.find(fmt::format(" key={} ", word)) != std::string_view::npos;
}

} // namespace

const protocol::Accelerator* accelerator_of(std::string_view reply)
{
    constexpr std::string_view front = "OK accelerator=";
    if (!reply.starts_with(front))
        return nullptr;
    const std::string_view name = reply.substr(front.size());
    return protocol::find_accelerator(name.substr(0, name.find(' ')));
}

Result<Connection::Found> Connection::probe(std::string_view command, const Accepts& accepts)
{
    if (auto sent = send(with_mark(command) + "\n"); !sent)
        return fail(sent.error());
    bool refused = false;
    while (Clock::now() < contact_ends_) {
        const auto line = receive(silence, contact_ends_);
        if (!line)
            return fail(line.error());
        if (!*line)
            return refused ? Found::Refused : Found::No;
        replied_ |= is_reply(**line);
        if (!has_right_mark(**line))
            continue;
        const std::string_view reply = without_mark(**line);
        if (accepts(reply))
            return Found::Yes;
        refused |= is_err(reply);
        // The reply with the random word may come after other ERR lines. For the other commands an
        // ERR is enough, because another command follows.
        if (refused && word_.empty())
            return Found::Refused;
    }
    return fail(
        plain_error(ErrorKind::InputOutput,
                    "the far end sends without a pause, but does not reply to the commands"));
}

Result<FarEnd> Connection::find_far_end()
{
    const auto named = probe("ACCELERATOR", [this](std::string_view reply) {
        accelerator_ = accelerator_of(reply);
        return accelerator_ != nullptr;
    });
    if (!named)
        return fail(named.error());
    if (*named == Found::Yes) {
        const std::string keys = random_keys(*accelerator_);
        const auto ordered =
            probe("GET " + keys, [&](std::string_view reply) { return keys_of(reply) == keys; });
        if (!ordered)
            return fail(ordered.error());
        if (*ordered == Found::Yes)
            return FarEnd::Speaks;
    }

    word_ = random_word();
    const auto repeated =
        probe("GET " + word_, [this](std::string_view reply) { return repeats(reply, word_); });
    if (!repeated)
        return fail(repeated.error());
    if (*repeated == Found::Refused) // it knows marks, but sends no replies now
        return FarEnd::Speaks;
    if (*repeated == Found::No)
        return replied_ ? FarEnd::Unmarked : FarEnd::Silent;

    const auto alive = probe("PING", [](std::string_view reply) { return reply == "OK"; });
    if (!alive)
        return fail(alive.error());
    return *alive == Found::No ? FarEnd::OnlyErrors : FarEnd::Speaks;
}

Result<void> Connection::synchronise()
{
    received_.clear();
    accelerator_ = nullptr;
    word_.clear();
    replied_ = false;
    contact_ends_ = Clock::now() + longest_contact;
    if (auto sent = send("\n"); !sent)
        return sent;
    const auto found = find_far_end();
    if (!found)
        return fail(found.error());
    far_end_ = *found;
    return {};
}

std::chrono::milliseconds Connection::line_timeout() const noexcept
{
    return far_end_ == FarEnd::Silent ? reply_timeout - 2 * silence : reply_timeout;
}

} // namespace raymarch::cli
