// SPDX-License-Identifier: MIT
/// @file
/// Which pixels of a row can show the sphere or the cube: the rays of the others hit nothing, and
/// are not marched where nobody counts their queries. An outline is that of a body around the
/// scene, with a margin that all roundings together are far below; the proof is in docs/engine.md,
/// "Fast kernels".
#pragma once

#include "engine/image.hpp"
#include "engine/marcher/frame.hpp"

#include <array>

namespace raymarch::engine::marcher::fast
{

/// Pixels x from `first` to before `end`.
struct Span
{
    int first;
    int end;
};

/// A scene that fills space has no outline.
struct NoOutline
{
    int width;

    NoOutline(const Frame& /*frame*/, PictureSize size) noexcept : width(size.width) {}
    [[nodiscard]] Span of_row(int /*y*/) const noexcept { return {0, width}; }
    [[nodiscard]] static Coordinate farthest() noexcept { return max_distance; }
};

/// The sphere's: a cone around a ball, cut by the row's line.
class BallOutline
{
  public:
    BallOutline(const Frame& frame, PictureSize size) noexcept;
    [[nodiscard]] Span of_row(int y) const noexcept;

    /// The t beyond which no ray inside the outline hits.
    [[nodiscard]] Coordinate farthest() const noexcept { return farthest_; }
    /// True if up to there all points of these rays are less than 4 units from the middle.
    [[nodiscard]] bool near() const noexcept { return near_; }

  private:
    PictureSize size_;
    bool proved_; ///< else every row is whole
    bool near_ = false;
    Coordinate farthest_ = max_distance;
    double horizon_; ///< eye^2 - radius^2: the square of the way to where the cone touches
    // Products of the eye and the basis, the forward vector times f.
    double eye_right_, eye_up_, eye_forward_;
    double right_right_, right_up_, right_forward_;
    double up_up_, up_forward_, forward_forward_;
};

/// The cube's: the lines between the corners of a box, cut by the row's line.
class BoxOutline
{
  public:
    BoxOutline(const Frame& frame, PictureSize size) noexcept;
    [[nodiscard]] Span of_row(int y) const noexcept;
    [[nodiscard]] static Coordinate farthest() noexcept { return max_distance; }

  private:
    struct Edge
    {
        double bottom, top; ///< v of its ends
        double u, slope;    ///< u at the bottom, and how it grows with v
    };
    PictureSize size_;
    bool proved_;
    std::array<Edge, 12> edges_{};
};

} // namespace raymarch::engine::marcher::fast
