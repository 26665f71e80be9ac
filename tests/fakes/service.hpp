// SPDX-License-Identifier: MIT
/// @file
/// The seams of a controller, played: a board that takes words, a storage in memory, a status.
#pragma once

#include "daemon/controller.hpp"
#include "daemon/session.hpp"
#include "protocol/accelerators.hpp"

#include <future>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::test
{

struct FakeBoard final : daemon::Board
{
    [[nodiscard]] daemon::Applied apply(const protocol::Words& fresh) override
    {
        ++calls;
        if (outcome == daemon::Applied::Written || outcome == daemon::Applied::Deferred)
            words = fresh;
        return outcome;
    }
    [[nodiscard]] bool use(const protocol::Accelerator& accelerator) override
    {
        if (emulated)
            used = &accelerator;
        return emulated;
    }
    [[nodiscard]] daemon::Health health() override { return present; }
    daemon::Health present{.fault = false, .running = true};
    bool emulated = false;
    const protocol::Accelerator* used = nullptr; ///< the last that was asked for
    daemon::Applied outcome = daemon::Applied::Written;
    protocol::Words words{}; ///< the newest that were taken
    int calls = 0;
};

struct FakeStorage final : daemon::Storage
{
    void changed(const Accelerator& /*accelerator*/, const State& state) override
    {
        changes.push_back(state);
    }
    [[nodiscard]] daemon::StoredState save(const Accelerator& /*accelerator*/,
                                           const State& state) override
    {
        if (works)
            saved = state;
        return answer();
    }
    [[nodiscard]] daemon::StoredState load(const Accelerator& /*accelerator*/) override
    {
        return answer();
    }
    /// What a slow disk was asked for is there from now on.
    void finish()
    {
        for (auto& promise : waiting)
            promise.set_value(works ? saved : std::nullopt);
        waiting.clear();
    }
    [[nodiscard]] std::optional<State> last(const Accelerator& accelerator) override
    {
        const auto found = lasts.find(&accelerator);
        return found == lasts.end() ? std::nullopt : std::optional(found->second);
    }
    std::map<const Accelerator*, State> lasts;
    bool works = true;
    bool slow = false; ///< nothing is there before finish()
    std::vector<protocol::State> changes;
    std::optional<protocol::State> saved;

  private:
    daemon::StoredState answer()
    {
        daemon::StoredState future = waiting.emplace_back().get_future();
        if (!slow)
            finish();
        return future;
    }
    std::vector<std::promise<std::optional<protocol::State>>> waiting;
};

struct FakeStatus final : daemon::StatusSource
{
    void write_status(protocol::StatusValues& status) override
    {
        status.put(protocol::StatusKey::Serial, "up");
    }
};

/// A controller between fakes, with one session on it.
struct Service
{
    explicit Service(daemon::Policy policy = {},
                     const protocol::Accelerator& accelerator = protocol::default_accelerator)
        : controller(accelerator, policy, board, storage, status, 1)
    {}

    /// What the session answers to `bytes`, line endings included.
    [[nodiscard]] std::string say(std::string_view bytes)
    {
        session.receive(bytes);
        std::string replies(session.output().pending());
        session.output().pop(replies.size());
        return replies;
    }

    FakeBoard board;
    FakeStorage storage;
    FakeStatus status;
    daemon::Controller controller;
    daemon::Session session{controller};
};

/// An ERR up to its sentence.
inline std::string head(const std::string& reply)
{
    return reply.substr(0, reply.find(" : "));
}

} // namespace raymarch::test
