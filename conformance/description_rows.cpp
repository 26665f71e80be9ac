// SPDX-License-Identifier: MIT
#include "conformance/description_rows.hpp"

#include "protocol/assignments.hpp"
#include "protocol/dequantizer.hpp"
#include "protocol/registers.hpp"

#include <algorithm>
#include <string_view>

namespace raymarch::conformance
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): rows about its tables

/// Whether a warning stands behind it is the policy's.
constexpr std::string_view applied = "OK seq=# changed=#...";

class Rows
{
  public:
    explicit Rows(const Accelerator& accelerator)
        : accelerator_(accelerator)
        , state_(initial_state(accelerator))
    {}

    /// The defaults as a frame, and what each key's absence is.
    void frames()
    {
        taken(frame_without(SIZE_MAX), "the defaults as a frame");
        for (std::size_t i = 0; i < accelerator_.parameters.size(); ++i)
            if (accelerator_.frame[i])
                refused(frame_without(i), "ERR MISSING_KEY key=" + key(i), "a key is missing");
    }

    void values()
    {
        for (std::size_t i = 0; i < accelerator_.parameters.size(); ++i) {
            const Parameter& parameter = accelerator_.parameters[i];
            if (parameter.is_tail())
                continue;
            for (const std::string_view choice : parameter.choices)
                value(i, choice);
            if (!parameter.is_choice()) {
                value(i, parameter.min);
                value(i, parameter.max);
            }
            value(i, parameter.initial);
        }
    }

    void faults()
    {
        refused("SET QQQ=0", "ERR UNKNOWN_KEY col=5 key=QQQ", "no such key");
        for (std::size_t i = 0; i < accelerator_.parameters.size(); ++i) {
            const Parameter& parameter = accelerator_.parameters[i];
            if (parameter.is_tail())
                continue;
            const std::string at_value = std::to_string(key(i).size() + 6) + " key=" + key(i);
            if (parameter.is_choice()) {
                refused("SET " + key(i) + "=?", "ERR OBJECT col=" + at_value, "no such choice");
            } else {
                refused("SET " + key(i) + "=1e30", "ERR RANGE col=" + at_value, "out of range");
                refused("SET " + key(i) + "=x", "ERR NUMBER col=" + at_value, "not a number");
            }
            const std::string pair = key(i) + "=" + std::string(parameter.initial);
            refused("SET " + pair + "," + pair,
                    "ERR DUPLICATE_KEY col=" + std::to_string(pair.size() + 6) + " key=" + key(i),
                    "a key stands twice");
        }
    }

    void presets()
    {
        for (const Preset& preset : accelerator_.presets) {
            state_ = initial_state(accelerator_);
            set(preset.settings);
            taken("PRESET " + std::string(preset.name), "a preset");
        }
        state_ = initial_state(accelerator_);
        taken("RESET", "back to the defaults");
    }

    [[nodiscard]] std::vector<Row> take() { return std::move(rows_); }

  private:
    [[nodiscard]] std::string key(std::size_t i) const
    {
        return std::string(accelerator_.parameters[i].key);
    }
    [[nodiscard]] std::string frame_without(std::size_t left_out) const
    {
        std::string text;
        for (std::size_t i = 0; i < accelerator_.parameters.size(); ++i)
            if (accelerator_.frame[i] && i != left_out)
                text += (text.empty() ? "" : ",") + key(i) + "=" +
                        std::string(accelerator_.parameters[i].initial);
        return text;
    }
    void set(std::string_view settings)
    {
        ParameterSet given;
        static_cast<void>(read_assignments(accelerator_, {.bytes = settings}, state_, given));
    }
    void value(std::size_t i, std::string_view text)
    {
        const std::string pair = key(i) + "=" + std::string(text);
        set(pair);
        const Parameter& parameter = accelerator_.parameters[i];
        const std::int64_t tail = parameter.tail_bits > 0 ? state_.codes[i + 1] : 0;
        const std::string shown(to_text(parameter, state_.codes[i], tail).view());
        taken("SET " + pair + "\nGET " + key(i), "a value and its text");
        rows_.back().replies.push_back("OK " + key(i) + "=" + shown);
    }
    /// The line is applied, and leads to the words of state_.
    void taken(const std::string& line, std::string why)
    {
        const Words words = pack(accelerator_, state_);
        rows_.push_back({.send = line + "\n",
                         .replies = {std::string(applied)},
                         .words_check = WordsCheck::Exact,
                         .words = {words.begin(), words.end()},
                         .why = std::move(why)});
    }
    void refused(const std::string& line, std::string reply, std::string why)
    {
        rows_.push_back({.send = line + "\n",
                         .replies = {std::move(reply)},
                         .words_check = WordsCheck::Same,
                         .words = {},
                         .why = std::move(why)});
    }

    const Accelerator& accelerator_;
    State state_; ///< after the rows so far
    std::vector<Row> rows_;
};

} // namespace

std::vector<Row> description_rows(const Accelerator& accelerator)
{
    Rows rows(accelerator);
    rows.frames();
    rows.values();
    rows.faults();
    rows.presets();
    return rows.take();
}

} // namespace raymarch::conformance
