// SPDX-License-Identifier: MIT
/// @file
/// The function type that tells long work when to stop.
#pragma once

#include <functional>

namespace raymarch::daemon
{

/// Long work calls this function between two steps, and stops when it returns true.
using TurnIsOver = std::function<bool()>;

} // namespace raymarch::daemon
