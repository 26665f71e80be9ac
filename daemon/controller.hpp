// SPDX-License-Identifier: MIT
/// @file
/// Executes lines: frame or command → state → words → board, and the reply.
///
/// The one place that holds the present state. It knows no descriptor and no clock: the board, the
/// storage and the rest of the service stand behind the seams below, so that a test can play them.
#pragma once

#include "daemon/config.hpp"
#include "daemon/movement.hpp"
#include "daemon/register_path.hpp"
#include "daemon/unfinished.hpp"
#include "protocol/line_reader.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"
#include "protocol/request.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string_view>

namespace raymarch::daemon
{

/// How the register block is.
struct Health
{
    bool fault = true;    ///< it is absent, a word read back wrong, or it says so itself
    bool running = false; ///< it draws, or has drawn since the last look; a plain block, which does
                          ///< not tell: it is there and without fault
};

/// The register block, present or not.
class Board
{
  public:
    virtual ~Board() = default;
    /// To be called again and again: each call is a look.
    [[nodiscard]] virtual Health health() = 0;
    [[nodiscard]] virtual Applied apply(const protocol::Words& words) = 0;
    /// Makes another accelerator the one behind the registers; its words are to be applied next.
    /// False, and nothing has changed, where the block is no emulated one.
    [[nodiscard]] virtual bool use(const protocol::Accelerator& accelerator) = 0;
};

/// The persisted states, one for each accelerator.
class Storage
{
  public:
    using Accelerator = protocol::Accelerator;
    using State = protocol::State;
    virtual ~Storage() = default;
    /// The state has changed; it is to be kept soon.
    virtual void changed(const Accelerator& accelerator, const State& state) = 0;
    /// Keeps it, and puts it aside for load(): that same state when the disk has it, or nothing
    /// when that cannot be done.
    [[nodiscard]] virtual StoredState save(const Accelerator& accelerator, const State& state) = 0;
    /// The state that was put aside last; nothing when there is none.
    [[nodiscard]] virtual StoredState load(const Accelerator& accelerator) = 0;
    /// What was there last.
    [[nodiscard]] virtual std::optional<State> last(const Accelerator& accelerator) = 0;
};

/// What STATUS tells beyond the controller's own counts.
class StatusSource
{
  public:
    virtual ~StatusSource() = default;
    /// Writes ` key=value` words.
    virtual void write_status(protocol::ReplyWriter& reply) = 0;
};

/// What a session lets the lines on it change.
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
    /// Goes on with a line: its reply, or nothing while `rest` is still not empty. Precondition:
    /// `rest` is not empty.
    [[nodiscard]] std::string_view resume(Unfinished& rest, const TurnIsOver& turn_is_over);

    /// Makes `state` the present one without a line: at start, or from a button. False when the
    /// board did not take it; the state is kept all the same, for a board that comes later.
    bool restore(const protocol::State& state);
    /// The board has come (back), with this accelerator: writes the present words again, or, where
    /// it is another accelerator than before, those that it had last.
    void board_is_back(const protocol::Accelerator& accelerator);

    /// Called with the steps a second that ANIMATE asks for; 0: none.
    void on_animate(std::function<void(unsigned)> pace) { pace_ = std::move(pace); }
    /// One step of the animation.
    void animate();

    // What the board's own buttons do. A lock keeps hosts out, not them. What the register block
    // does not take is not done; the block itself reports it.
    void to_defaults();
    void to_next_scene();
    void orbit(Side side);

    /// A switch on the board: while locked, whatever writes is answered ERR LOCKED.
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
    [[nodiscard]] Outcome dispatch(const protocol::Request& request, SessionSettings& session,
                                   Unfinished& rest, const TurnIsOver& turn_is_over);
    [[nodiscard]] Outcome run(const protocol::Request& request, SessionSettings& session,
                              Unfinished& rest, const TurnIsOver& turn_is_over);
    [[nodiscard]] Outcome go_on(Unfinished& rest, const TurnIsOver& turn_is_over);
    /// The reply for an outcome, as far as the policy wants one.
    [[nodiscard]] std::string_view settle(const Outcome& fault, bool writes, bool checksummed);
    [[nodiscard]] Outcome apply(const protocol::State& state);
    /// `before`: the words that `changed=` counts from.
    [[nodiscard]] Outcome apply(const protocol::State& state, const protocol::Words& before);
    /// Makes a state that the board has taken the present one.
    void hold(const protocol::State& state, const protocol::Words& words);
    /// Without a line, and so without a reply and a number. False when the board does not take it.
    bool put(const protocol::State& state);
    [[nodiscard]] Outcome assign(protocol::Text words);
    [[nodiscard]] Outcome get(protocol::Text words);
    [[nodiscard]] Outcome preset(protocol::Text words);
    [[nodiscard]] Outcome switch_accelerator(protocol::Text words);
    [[nodiscard]] Outcome move(const tl::expected<Steps, protocol::Fault>& steps, Unfinished& rest,
                               const TurnIsOver& turn_is_over);
    [[nodiscard]] Outcome move_on(Unfinished& rest, const TurnIsOver& turn_is_over);
    void end_movement(Unfinished& rest);
    [[nodiscard]] Outcome take_stored(Unfinished& rest);
    [[nodiscard]] Outcome may_go_on(const protocol::Accelerator& accelerator) const;
    [[nodiscard]] Outcome animate_at(protocol::Text words);
    [[nodiscard]] Outcome echo(protocol::Text words, SessionSettings& session);
    [[nodiscard]] Outcome group(protocol::Text words, std::string_view& name) const;
    void status();
    void ok();
    /// What this accelerator had last, or its defaults.
    void recall(const protocol::Accelerator& accelerator);

    const protocol::Accelerator* accelerator_;
    Policy policy_;
    Board& board_;
    Storage& storage_;
    StatusSource& status_;
    std::mt19937_64 random_;

    protocol::State state_;
    protocol::Words words_;
    std::uint64_t changes_ = 0;         ///< counts what has made another state the present one
    std::optional<std::size_t> preset_; ///< the one applied last, by its position
    Movement movement_;
    std::function<void(unsigned)> pace_;
    unsigned rate_ = 0; ///< of the animation, steps a second
    bool locked_ = false;
    bool last_refused_ = false;
    std::uint64_t applied_ = 0;
    std::array<std::uint64_t, protocol::error_count> rejected_{};
    std::uint64_t echoed_ = 0; ///< lines that were replies, sent back
    protocol::ReplyWriter reply_;
};

} // namespace raymarch::daemon
