// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every key of the STATUS reply. The service writes the reply by it, the tool prints JSON
/// by it, and the page of the protocol lists it.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/reply.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::protocol
{

enum class StatusKey : std::uint8_t {
    Accelerator,
    Serial,
    HangUps,
    Hardware,
    Block,
    ReadbackErrors,
    Frames,
    Fps,
    Interrupts,
    InterruptsMissed,
    Gpio,
    Logic,
    Overlay,
    Clients,
    DroppedReplies,
    Uptime,
    Animate,
    Locked,
    Applied,
    Rejected,
    Echoed,
    RejectedCode,
};

enum class StatusKind : std::uint8_t { Word, Number };

struct StatusRow
{
    StatusKey key;
    std::string_view name;
    StatusKind kind;
    std::string_view value;   ///< the words that there are, or what a number counts; empty: any
    std::string_view present; ///< when the key is in the reply
    std::string_view meaning;
};

/// `StatusRow::present` of a key that each reply has.
inline constexpr std::string_view always_present = "always";

// Laid out by hand: one row a key, in the order of the reply.
// clang-format off
inline constexpr std::array status_rows = {
    StatusRow{StatusKey::Accelerator,      "accelerator",       StatusKind::Word,   "",                        always_present, "the name of the active accelerator"},
    StatusRow{StatusKey::Serial,           "serial",            StatusKind::Word,   "up|down|none",            always_present, "the serial host; down: it is configured and is not there, or the link to the pseudo-terminal is not, and it is being looked for"},
    StatusRow{StatusKey::HangUps,          "hang_ups",          StatusKind::Number, "",                        "serial is up", "how often a host that had spoken left the pseudo-terminal"},
    StatusRow{StatusKey::Hardware,         "hardware",          StatusKind::Word,   "ok|fault|absent",         always_present, "the register block; fault: a word read back wrong, or STATUS of the block says fault; absent: it is not there, or its logic is not configured, and it is being looked for"},
    StatusRow{StatusKey::Block,            "block",             StatusKind::Word,   "extended|plain",          "hardware is not absent", "whether the block has the extended registers"},
    StatusRow{StatusKey::ReadbackErrors,   "readback_errors",   StatusKind::Number, "",                        "hardware is not absent", "updates in which a word read back wrong"},
    StatusRow{StatusKey::Frames,           "frames",            StatusKind::Number, "",                        "block is extended", "FRAMES of the block. An emulated one counts only frames that were drawn to their end, and new words end a slow frame early: under ANIMATE `frames` can stand still and `fps` be 0"},
    StatusRow{StatusKey::Fps,              "fps",               StatusKind::Number, "frames a second",         "block is extended and was watched long enough", "by FRAMES: over the last one to two seconds where interrupts or STATUS come that often, else since the STATUS before this one, whoever asked"},
    StatusRow{StatusKey::Interrupts,       "interrupts",        StatusKind::Number, "",                        "block is extended and has an interrupt line", "interrupts of the block since the service started. The line is armed only while a commit is pending"},
    StatusRow{StatusKey::InterruptsMissed, "interrupts_missed", StatusKind::Number, "",                        "with interrupts", "of these, those that came together with a later one"},
    StatusRow{StatusKey::Gpio,             "gpio",              StatusKind::Word,   "up|partial|down|none",    always_present, "buttons, switches and LEDs; partial and down: some lines or all are missing and are being looked for"},
    StatusRow{StatusKey::Logic,            "logic",             StatusKind::Word,   "",                        always_present, "the state of the FPGA manager with `_` for each blank, such as `operating`, `unknown` or `write_error`; `none`: the kernel has no FPGA manager"},
    StatusRow{StatusKey::Overlay,          "overlay",           StatusKind::Word,   "loaded|absent|failed|unknown", always_present, "the overlay of the device tree; failed: it is there and not applied; unknown: the kernel does not tell, as one without overlays in configfs"},
    StatusRow{StatusKey::Clients,          "clients",           StatusKind::Number, "",                        always_present, "connections to the control socket"},
    StatusRow{StatusKey::DroppedReplies,   "dropped_replies",   StatusKind::Number, "",                        always_present, "replies to all hosts that were dropped since the start, because they were not read"},
    StatusRow{StatusKey::Uptime,           "uptime",            StatusKind::Number, "seconds",                 always_present, "the time since the service started"},
    StatusRow{StatusKey::Animate,          "animate",           StatusKind::Number, "steps a second",          always_present, "the speed of ANIMATE; 0 when it is off"},
    StatusRow{StatusKey::Locked,           "locked",            StatusKind::Word,   "on|off",                  always_present, "whether a switch on the board locks out writes"},
    StatusRow{StatusKey::Applied,          "applied",           StatusKind::Number, "",                        always_present, "states that were applied: the N of the last `seq=N`"},
    StatusRow{StatusKey::Rejected,         "rejected",          StatusKind::Number, "",                        always_present, "lines with a fault, whether the ERR was sent or not"},
    StatusRow{StatusKey::Echoed,           "echoed",            StatusKind::Number, "",                        always_present, "lines that begin like a reply, and were ignored"},
    StatusRow{StatusKey::RejectedCode,     "rejected.CODE",     StatusKind::Number, "",                        "a line was rejected with that code", "of the rejected lines, those with that code"},
};
// clang-format on

namespace detail
{
consteval bool status_rows_in_order()
{
    for (std::size_t i = 0; i < status_rows.size(); ++i)
        if (static_cast<std::size_t>(status_rows[i].key) != i)
            return false;
    return true;
}
static_assert(status_rows_in_order());
} // namespace detail

[[nodiscard]] constexpr const StatusRow& status_row(StatusKey key) noexcept
{
    return status_rows[static_cast<std::size_t>(key)];
}

/// The row of a key as the reply has it: `rejected.SYNTAX` has that of `rejected.CODE`. Returns
/// nullptr for a key of no row, as a newer service may have one.
[[nodiscard]] const StatusRow* find_status_row(std::string_view name) noexcept;

/// A number with one digit after the point.
struct Tenths
{
    std::uint64_t count;
};

/// The values of one reply. They may be put in any order: write() goes by the table. A key that
/// nobody puts is left out.
class StatusValues
{
  public:
    /// Preconditions: the key has not been put before, and its row has such a value.
    void put(StatusKey key, std::string_view word);
    void put(StatusKey key, std::uint64_t number);
    void put(StatusKey key, Tenths number);
    /// Puts `rejected` and `rejected.CODE`. Precondition: neither has been put before.
    void put_rejected(std::span<const std::uint64_t, error_count> counts);

    /// Writes ` KEY=VALUE` for each key that was put.
    void write(ReplyWriter& reply) const noexcept;

  private:
    void put_text(StatusKey key, StatusKind kind, std::string text);

    std::array<std::optional<std::string>, status_rows.size()> texts_;
    std::array<std::uint64_t, error_count> rejected_{};
};

} // namespace raymarch::protocol
