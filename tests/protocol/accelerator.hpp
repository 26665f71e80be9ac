// SPDX-License-Identifier: MIT
/// @file
/// The description that the tests of the protocol take where any one will do.
#pragma once

#include "protocol/accelerators/marcher.hpp"

namespace raymarch::protocol
{

inline constexpr const Accelerator& accelerator = marcher::description;

} // namespace raymarch::protocol
