// SPDX-License-Identifier: MIT
/// @file
/// `KEY=VALUE,…` to codes: the parameter frame and the words of SET.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"
#include "protocol/text.hpp"

#include <optional>

namespace raymarch::protocol
{

/// Reads pairs from left to right into `state` and marks them in `given`; stops at the first fault.
/// On a fault `state` holds a mixture: the caller works on a copy.
[[nodiscard]] std::optional<Fault> read_assignments(const Accelerator& accelerator, Text text,
                                                    State& state, ParameterSet& given) noexcept;

/// A complete frame: every parameter that is no row of a table, each once; rows may be among them,
/// and keep what `state` has where they are not. The same faults, and MissingKey.
[[nodiscard]] std::optional<Fault> read_frame(const Accelerator& accelerator, Text text,
                                              State& state) noexcept;

/// Whether forward, right and up have length 1 and stand at right angles within 0.01, judged on the
/// codes. True for an accelerator that has no such camera.
[[nodiscard]] bool basis_is_orthonormal(const Accelerator& accelerator,
                                        const State& state) noexcept;

} // namespace raymarch::protocol
