// SPDX-License-Identifier: MIT
/// @file
/// Reads the arguments of commands: one function for each kind of argument in
/// protocol/commands.hpp.
///
/// A fault has the column where the argument begins and the code Argument. Assignments have codes
/// of their own.
#pragma once

#include "protocol/commands.hpp"
#include "protocol/counted.hpp"
#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"
#include "protocol/text.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tl/expected.hpp>

namespace raymarch::protocol
{

/// What the reader of an argument may look at.
struct ReadingContext
{
    const Accelerator& accelerator;
    const State& present; ///< gives the values that the line does not name
    State& result;        ///< takes the values of assignments; holds a mixture after a fault
};

/// Parameters in the order of the line.
struct KeyList
{
    Counted<ParameterIndex, max_parameters> indices{0};
};

template <class Value>
using Reading = tl::expected<Value, Fault>;

/// Makes the fault for a wrong argument at its column. `allowed` is the sentence of the reply.
[[nodiscard]] Fault argument_fault(Text at, std::string_view allowed) noexcept;

// Each of these reads `text` as the row says. `text` has no blanks at its ends.

/// The value is `context.result`: the present state, changed by the assignments.
[[nodiscard]] Reading<const State*> read_pairs(const ArgumentRow& row, Text text,
                                               const ReadingContext& context) noexcept;
[[nodiscard]] Reading<KeyList> read_keys(const ArgumentRow& row, Text text,
                                         const ReadingContext& context) noexcept;
/// The bounds are compared exactly. The value is the nearest double.
[[nodiscard]] Reading<double> read_number(const ArgumentRow& row, Text text,
                                          const ReadingContext& context) noexcept;
/// The value is the code of the camera's zoom. Precondition: the accelerator has an orbit camera.
[[nodiscard]] Reading<std::int64_t> read_zoom(const ArgumentRow& row, Text text,
                                              const ReadingContext& context) noexcept;
[[nodiscard]] Reading<unsigned> read_count(const ArgumentRow& row, Text text,
                                           const ReadingContext& context) noexcept;
/// The value is the position of the name in the row.
[[nodiscard]] Reading<std::size_t> read_choice(const ArgumentRow& row, Text text,
                                               const ReadingContext& context) noexcept;
/// The value is the group's name as the table spells it.
[[nodiscard]] Reading<std::string_view> read_group(const ArgumentRow& row, Text text,
                                                   const ReadingContext& context) noexcept;
/// The value is the position of the preset in its table.
[[nodiscard]] Reading<std::size_t> read_preset(const ArgumentRow& row, Text text,
                                               const ReadingContext& context) noexcept;
/// The value is never null.
[[nodiscard]] Reading<const Accelerator*> read_accelerator(const ArgumentRow& row, Text text,
                                                           const ReadingContext& context) noexcept;

} // namespace raymarch::protocol
