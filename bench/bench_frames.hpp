// SPDX-License-Identifier: MIT
/// @file
/// The frames of frames.txt, as they stand and with their pairs in other orders.
#pragma once

#include <string>
#include <vector>

namespace raymarch::bench
{

/// Many different ones, so that the branch predictor does not learn one line. Without endings.
using Frames = std::vector<std::string>;

/// Those of the file at `path`, in table order; the first is the one of the source's listing. Empty
/// when there are none.
[[nodiscard]] Frames read_frames(const std::string& path);

/// The same frames, each with its pairs in an order of its own, the same in every run.
[[nodiscard]] Frames shuffled(const Frames& frames);

} // namespace raymarch::bench
