// SPDX-License-Identifier: MIT
/// @file
/// Executes lines: frame or command → state → words → board, and the reply.
///
/// The controller alone holds the present state. It knows no descriptor and no clock: the board,
/// the storage and the rest of the service are behind the interfaces below, so that a test can
/// replace them.
#pragma once

#include "daemon/config.hpp"
#include "daemon/movement.hpp"
#include "daemon/register_path.hpp"
#include "daemon/unfinished.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/reply.hpp"
#include "protocol/status.hpp"
#include "protocol/typed_request.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string_view>
#include <utility>

namespace raymarch::daemon
{

/// The condition of the register block.
struct Health
{
    /// Whether the block is absent, a word of it read back wrong, or it reports a fault itself.
    bool fault = true;
    /// Whether the block draws, or has drawn since the last call of Board::health(). A plain block
    /// does not tell that; it counts as running when it is there and has no fault.
    bool running = false;
};

/// The register block, present or not.
class Board
{
  public:
    virtual ~Board() = default;
    /// Looks at the block. It is to be called regularly, as `running` goes by the last call.
    [[nodiscard]] virtual Health health() = 0;
    [[nodiscard]] virtual Applied apply(const protocol::Words& words) = 0;
    /// Makes another accelerator the one behind the registers; its words are to be applied next.
    /// Returns false, and changes nothing, where the block is no emulated one.
    [[nodiscard]] virtual bool use(const protocol::Accelerator& accelerator) = 0;
};

/// The persisted states, one for each accelerator.
class Storage
{
  public:
    using Accelerator = protocol::Accelerator;
    using State = protocol::State;
    virtual ~Storage() = default;
    /// Tells that the state has changed. It is to be stored soon, as the one that last() returns.
    virtual void changed(const Accelerator& accelerator, const State& state) = 0;
    /// Stores the state as the one that load() gives. The result is that same state when the disk
    /// has it, or nothing when it cannot be stored.
    [[nodiscard]] virtual StoredState save(const Accelerator& accelerator, const State& state) = 0;
    /// Gives the state that was saved last; nothing when there is none.
    [[nodiscard]] virtual StoredState load(const Accelerator& accelerator) = 0;
    /// Returns the last state that the accelerator had, saved or not; nothing when none is known.
    [[nodiscard]] virtual std::optional<State> last(const Accelerator& accelerator) = 0;
};

/// The part of STATUS that the controller does not know itself.
class StatusSource
{
  public:
    virtual ~StatusSource() = default;
    virtual void write_status(protocol::StatusValues& status) = 0;
};

/// The settings of a session that its own lines can change.
struct SessionSettings
{
    bool echo = false;
};

struct Policy
{
    BasisCheck basis_check = BasisCheck::Warn;
    Replies replies = Replies::All;
    bool require_checksum = false;
};

class Controller
{
  public:
    Controller(const protocol::Accelerator& accelerator, Policy policy, Board& board,
               Storage& storage, StatusSource& status, std::uint64_t random_seed);

    /// Executes one line. The reply, which may be empty, is valid until the next call. When `rest`
    /// is not empty afterwards, the reply comes from resume().
    [[nodiscard]] std::string_view execute(const protocol::Line& line, SessionSettings& session,
                                           Unfinished& rest, const TurnIsOver& turn_is_over);
    /// Goes on with a line. Returns its reply, or nothing while `rest` is still not empty.
    /// Precondition: `rest` is not empty.
    [[nodiscard]] std::string_view resume(Unfinished& rest, const TurnIsOver& turn_is_over);

    /// Makes `state` the present one without a line: at the start, when the board comes back, and
    /// after a change of the accelerator. Returns false when the board did not take it. The state
    /// is kept all the same, for a board that comes later.
    bool restore(const protocol::State& state);
    /// Tells that the board is there, or there again, with this accelerator. Writes the present
    /// words again. Where the accelerator is another one than before, writes its own last words.
    void board_is_back(const protocol::Accelerator& accelerator);

    /// `pace` is called with the steps a second that ANIMATE asks for; 0 means none.
    void on_animate(std::function<void(unsigned)> pace) { pace_ = std::move(pace); }
    /// Makes one step of the animation.
    void animate();

    // The board's own buttons call these. A lock keeps out hosts, but no buttons. Nothing changes
    // when the register block does not take the words; the block itself reports that.
    void to_defaults();
    void to_next_scene();
    void orbit(Side side);

    /// A switch on the board sets this. While locked, every line that writes gets ERR LOCKED.
    void set_locked(bool locked) noexcept { locked_ = locked; }

    void set_policy(const Policy& policy) noexcept { policy_ = policy; }
    [[nodiscard]] const protocol::State& state() const noexcept { return state_; }
    [[nodiscard]] const protocol::Accelerator& accelerator() const noexcept
    {
        return *accelerator_;
    }
    [[nodiscard]] std::uint64_t applied() const noexcept { return applied_; }
    /// Whether the last line that was to change the registers, or could not be read, was refused.
    [[nodiscard]] bool last_refused() const noexcept { return last_refused_; }

  private:
    using Outcome = std::optional<protocol::Fault>;
    template <protocol::CommandName name>
    using Command = protocol::Command<name>;
    /// Holds what a command may need besides its arguments.
    struct Call
    {
        SessionSettings& session;
        Unfinished& rest;
        const TurnIsOver& turn_is_over;
    };
    /// Where a state comes from that is to become the present one.
    enum class Source : std::uint8_t { Change, Storage };

    [[nodiscard]] Outcome dispatch(const protocol::TypedRequest& request, const Call& call);
    /// Writes a state to the board and makes it the present one. Returns how many words differ from
    /// `before`, or nothing when the board does not take them. Then a change has not happened; a
    /// state from the storage becomes the present one all the same.
    std::optional<std::uint64_t> write_state(const protocol::State& state,
                                             const protocol::Words& before,
                                             Source source = Source::Change);
    /// Writes the state that a line asks for. `changed=` in the reply counts the words that differ
    /// from `before`.
    [[nodiscard]] Outcome apply(const protocol::State& state, const protocol::Words& before);
    /// Returns the reply for an outcome, or an empty one where the policy wants none.
    [[nodiscard]] std::string_view settle(const Outcome& fault, bool writes, bool checksummed);
    [[nodiscard]] Outcome go_on(Unfinished& rest, const TurnIsOver& turn_is_over);
    [[nodiscard]] Outcome move(const Steps& steps, const Call& call);
    [[nodiscard]] Outcome move_on(Unfinished& rest, const TurnIsOver& turn_is_over);
    void end_movement(Unfinished& rest);
    [[nodiscard]] Outcome take_stored(Unfinished& rest);
    [[nodiscard]] Outcome may_go_on(const protocol::Accelerator& accelerator) const;
    [[nodiscard]] Outcome ok();
    /// Makes this accelerator the present one, with its last state, or its defaults without one.
    void recall(const protocol::Accelerator& accelerator);

    // One overload for each row of protocol/commands.hpp: daemon/commands.cpp.
    [[nodiscard]] Outcome run(const Command<"SET">& set, const Call& call);
    [[nodiscard]] Outcome run(const Command<"VIEW">& view, const Call& call);
    [[nodiscard]] Outcome run(const Command<"HUE">& hue, const Call& call);
    [[nodiscard]] Outcome run(const Command<"GET">& get, const Call& call);
    [[nodiscard]] Outcome run(const Command<"REGS">& regs, const Call& call);
    [[nodiscard]] Outcome run(const Command<"RESET">& reset, const Call& call);
    [[nodiscard]] Outcome run(const Command<"RANDOM">& random, const Call& call);
    [[nodiscard]] Outcome run(const Command<"STATUS">& status, const Call& call);
    [[nodiscard]] Outcome run(const Command<"PRESET">& preset, const Call& call);
    [[nodiscard]] Outcome run(const Command<"SAVE">& save, const Call& call);
    [[nodiscard]] Outcome run(const Command<"LOAD">& load, const Call& call);
    [[nodiscard]] Outcome run(const Command<"ACCELERATOR">& accelerator, const Call& call);
    [[nodiscard]] Outcome run(const Command<"WALK">& walk, const Call& call);
    [[nodiscard]] Outcome run(const Command<"TURN">& turn, const Call& call);
    [[nodiscard]] Outcome run(const Command<"ANIMATE">& animate, const Call& call);
    [[nodiscard]] Outcome run(const Command<"ECHO">& echo, const Call& call);
    [[nodiscard]] Outcome run(const Command<"VERSION">& version, const Call& call);
    [[nodiscard]] Outcome run(const Command<"PING">& ping, const Call& call);
    [[nodiscard]] Outcome run(const Command<"HELP">& help, const Call& call);

    const protocol::Accelerator* accelerator_;
    Policy policy_;
    Board& board_;
    Storage& storage_;
    StatusSource& status_;
    std::mt19937_64 random_;

    protocol::State state_;
    protocol::State read_; ///< the state that the present line asks for
    protocol::Words words_;
    std::uint64_t changes_ = 0;         ///< counts how often the present state was replaced
    std::optional<std::size_t> preset_; ///< the position of the preset that was applied last
    Movement movement_;
    std::function<void(unsigned)> pace_;
    unsigned rate_ = 0; ///< steps a second of the animation
    bool locked_ = false;
    bool last_refused_ = false;
    std::uint64_t applied_ = 0;
    std::array<std::uint64_t, protocol::error_count> rejected_{};
    std::uint64_t echoed_ = 0; ///< lines that were replies, sent back
    protocol::ReplyWriter reply_;
};

} // namespace raymarch::daemon
