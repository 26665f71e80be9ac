// SPDX-License-Identifier: MIT
/// @file
/// A whole session: the words on the board are always those of the present state and of the
/// accelerator that is there, however the bytes come in pieces.
#include "daemon/session.hpp"
#include "protocol/accelerators.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

using namespace raymarch; // NOLINT(google-build-using-namespace)
using protocol::Accelerator;

namespace
{

struct World final : daemon::Board, daemon::Storage, daemon::StatusSource
{
    protocol::Words words{};
    std::map<const Accelerator*, State> saved;

    daemon::Applied apply(const protocol::Words& to) override
    {
        words = to;
        return daemon::Applied::Written;
    }
    daemon::Health health() override { return {}; }
    bool use(const protocol::Accelerator& /*accelerator*/) override { return true; }
    void changed(const Accelerator& /*accelerator*/, const State& /*state*/) override {}
    daemon::StoredState save(const Accelerator& accelerator, const State& state) override
    {
        saved.insert_or_assign(&accelerator, state);
        return daemon::stored_already(state);
    }
    daemon::StoredState load(const Accelerator& accelerator) override
    {
        return daemon::stored_already(last(accelerator));
    }
    std::optional<State> last(const Accelerator& accelerator) override
    {
        const auto found = saved.find(&accelerator);
        return found == saved.end() ? std::nullopt : std::optional(found->second);
    }
    void write_status(protocol::StatusValues& /*status*/) override {}
};

struct Host
{
    explicit Host(const Accelerator& accelerator)
        : controller(accelerator, {}, world, world, world, 1)
    {
        static_cast<void>(controller.restore(protocol::initial_state(accelerator)));
    }

    void send(std::string_view chunk)
    {
        session.receive(chunk);
        session.output().clear();
        if (protocol::pack(controller.accelerator(), controller.state()) != world.words)
            std::abort();
    }

    World world;
    daemon::Controller controller;
    daemon::Session session{controller};
};

void check(const Accelerator& accelerator, std::string_view bytes)
{
    Host in_chunks(accelerator);
    Host in_bytes(accelerator);
    while (!bytes.empty()) {
        const std::string_view chunk = bytes.substr(0, 64);
        bytes.remove_prefix(chunk.size());
        in_chunks.send(chunk);
        for (std::size_t i = 0; i < chunk.size(); ++i)
            in_bytes.send(chunk.substr(i, 1));
        if (&in_chunks.controller.accelerator() != &in_bytes.controller.accelerator() ||
            in_chunks.world.words != in_bytes.world.words ||
            in_chunks.controller.applied() != in_bytes.controller.applied())
            std::abort();
    }
}

} // namespace

/// The length picks the accelerator that is there at first; a line may take another.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto& accelerators = protocol::accelerators;
    check(*accelerators[size % accelerators.size()], {reinterpret_cast<const char*>(data), size});
    return 0;
}
