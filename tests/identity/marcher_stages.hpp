// SPDX-License-Identifier: MIT
/// @file
/// The stages of the marcher's kernels one by one, in all instruction sets, on arrays: what
/// marcher_stages_test.cpp holds to the scalar stages.
#pragma once

#include "engine/isa.hpp"
#include "engine/marcher/frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>

namespace raymarch::engine::marcher
{

/// As many numbers as any vector has lanes.
inline constexpr std::size_t batch = 16;
using Batch = std::array<std::int32_t, batch>;
using Squares64 = std::array<std::uint64_t, batch>;

struct PointBatch
{
    Batch x, y, z;
};

struct MantissaBatch
{
    Batch mantissa;
    Batch exponent; ///< floor(log2 S)
};

/// The vector stages of one instruction set.
struct Stages
{
    Isa isa;
    /// Of S up to 2^64; `small`: by the way for S below 2^52.
    void (*inverse_sqrt)(const Squares64& squares, bool small, MantissaBatch& result);
    void (*length)(const Squares64& squares, bool small, Batch& result);
    void (*normalise)(const PointBatch& v, bool small, PointBatch& result);
    /// E + mul(D, t)
    void (*position)(const Point& eye, const PointBatch& direction, const Batch& t,
                     PointBatch& result);
    void (*distance)(Scene scene, const PointBatch& p, Batch& result);
    void (*surface_normal)(Scene scene, const PointBatch& p, PointBatch& result);
    void (*brightness)(const PointBatch& normal, const PointBatch& light, Batch& result);
    void (*shade)(const std::array<std::uint16_t, 3>& colour, const Batch& brightness,
                  Batch& result);
    /// The chosen numbers first, then the others; returns how many are chosen. Only the first
    /// `lanes` of a vector, which is returned in `lanes`.
    std::size_t (*compact)(std::uint32_t chosen, Batch& numbers, std::size_t& lanes);
};

/// The instruction set's name stands for its stages in the output of GoogleTest.
inline void PrintTo(const Stages& stages, std::ostream* stream)
{
    *stream << name_of(stages.isa);
}

} // namespace raymarch::engine::marcher
