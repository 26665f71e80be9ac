// SPDX-License-Identifier: MIT
/// @file
/// A whole picture, drawn by any number of threads: the same bytes for any number.
#pragma once

#include "engine/model.hpp"

#include <cstdint>
#include <span>
#include <stop_token>

namespace raymarch::engine
{

/// Draws every row of `image`. `threads` from 1; 0 means one for each processor. When a stop is
/// requested the picture is left unfinished, at the latest one row a thread later.
/// Returns the clock cycles of the frame: those of all rows shared out among the ray units.
std::uint64_t draw(const Model& model, std::span<const std::uint32_t> words, Image& image,
                   unsigned threads, const std::stop_token& stop = {});

} // namespace raymarch::engine
