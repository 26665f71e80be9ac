// SPDX-License-Identifier: MIT
/// @file
/// A whole session: every line that is not blank gets exactly one reply, in words that the protocol
/// has, and the words on the board are always those of the present state.
#include "daemon/session.hpp"
#include "protocol/accelerators.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>

namespace
{

using namespace raymarch; // NOLINT(google-build-using-namespace)

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
    bool save(const Accelerator& accelerator, const State& state) override
    {
        saved.insert_or_assign(&accelerator, state);
        return true;
    }
    std::optional<State> load(const Accelerator& accelerator) override
    {
        const auto found = saved.find(&accelerator);
        return found == saved.end() ? std::nullopt : std::optional(found->second);
    }
    std::optional<State> last(const Accelerator& accelerator) override { return load(accelerator); }
    void write_status(protocol::ReplyWriter& /*reply*/) override {}
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto& accelerator = protocol::default_accelerator;
    World world;
    daemon::Controller controller(accelerator, {}, world, world, world, 1);
    static_cast<void>(controller.restore(protocol::initial_state(accelerator)));
    daemon::Session session(controller);
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    while (!bytes.empty()) {
        const std::string_view chunk = bytes.substr(0, 64);
        bytes.remove_prefix(chunk.size());
        session.receive(chunk);
        session.output().clear();
        if (protocol::pack(accelerator, controller.state()) != world.words)
            std::abort();
    }
    return 0;
}
