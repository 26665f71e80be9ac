// SPDX-License-Identifier: MIT
/// @file
/// The question that ends a turn, for work that is done in turns.
#pragma once

#include <functional>

namespace raymarch::daemon
{

/// Work that takes long calls this between two pieces, and stops when it returns true.
using TurnIsOver = std::function<bool()>;

} // namespace raymarch::daemon
