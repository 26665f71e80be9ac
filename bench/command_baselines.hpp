// SPDX-License-Identifier: MIT
/// @file
/// The ways of the C and C++ libraries to read a frame, for bench_command_path to compare with.
///
/// Each does what a host of the source would write with it: find the key, read a double, check the
/// range, scale and round to the nearest code. Decimals of up to some fifteen digits come out as
/// the exact way has them; where a longer one falls on a tie, or past the end of a range, they may
/// not.
#pragma once

#include "protocol/parameters.hpp"

#include <string>

namespace raymarch::bench
{

/// Reads the marcher's frame `line`, which a NUL ends, into `state`; false for what is no frame.
using ReadFrame = bool (*)(const std::string& line, protocol::State& state);

/// One call for the whole line, with a format of all keys: the pairs must come in table order.
bool sscanf_in_order(const std::string& line, protocol::State& state);
/// One call for each pair.
bool sscanf_any_order(const std::string& line, protocol::State& state);

/// A loop over the pairs, in any order; the key is looked for first where table order has it.
bool with_from_chars(const std::string& line, protocol::State& state);
bool with_fast_float(const std::string& line, protocol::State& state);

} // namespace raymarch::bench
