// SPDX-License-Identifier: MIT
/// @file
/// The registry of models: one line an accelerator, beside protocol/accelerators.hpp.
#pragma once

#include "engine/fast/kernels.hpp"
#include "engine/fractal/controller.hpp"
#include "engine/fractal/fractal.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/marcher/marcher.hpp"
#include "engine/model.hpp"
#include "engine/sphere/sphere.hpp"
#include "engine/whitted/whitted.hpp"
#include "protocol/accelerators.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace raymarch::engine
{

/// A picture that calls the functions of its accelerator's namespace; the headers above declare
/// them. Each accelerator has draw_row and frame_cycles. It may also have finish, frame_rays and
/// frames_of_a_still.
template <class Frame>
class LatchedPicture final : public PictureOf<Frame>
{
    using PictureOf<Frame>::PictureOf;
    using PictureOf<Frame>::frame;

  public:
    void draw(RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) const noexcept override
    {
        draw_row(frame, row, pixels, costs);
    }
    void complete(const Canvas& canvas) const noexcept override
    {
        if constexpr (requires { finish(frame, canvas); })
            finish(frame, canvas);
    }
    std::uint64_t cycles(RowOf last_row, std::span<const PixelCost> costs,
                         unsigned units) const noexcept override
    {
        return frame_cycles(frame, last_row, costs, units);
    }
    std::uint64_t rays(PictureSize size, std::span<const PixelCost> costs) const noexcept override
    {
        std::uint64_t sum = 0;
        if constexpr (requires { frame_rays(frame, size, costs); })
            return frame_rays(frame, size, costs);
        for (const PixelCost& cost : costs)
            sum += cost.rays;
        return sum;
    }
    unsigned frames() const noexcept override
    {
        if constexpr (requires { frames_of_a_still(frame); })
            return frames_of_a_still(frame);
        return 1;
    }
};

/// Implements Model::latch with the function that decodes an accelerator's words.
template <auto decode>
std::unique_ptr<const Picture> latch_by(WordSpan words)
{
    using Frame = decltype(decode(words));
    return std::make_unique<LatchedPicture<Frame>>(decode(words));
}

inline constexpr std::array models = {
    Model{.description = &protocol::marcher::description,
          .steps = "scene queries",
          .latch = latch_by<marcher::latch>,
          .kernels = marcher::fast::kernels},
    Model{.description = &protocol::fractal::description,
          .steps = "scene queries",
          .latch = latch_by<fractal::latch>,
          .kernels = fractal::fast::kernels},
    Model{.description = &protocol::sphere::description,
          .steps = "clock edges (prototype: runs of the ray-sphere unit)",
          .latch = latch_by<sphere::latch>,
          .kernels = sphere::fast::kernels,
          .ordered = true},
    Model{.description = &protocol::mandelbulb::description,
          .steps = "evaluations of the distance",
          .latch = latch_by<mandelbulb::latch>,
          .kernels = mandelbulb::fast::kernels},
    Model{.description = &protocol::whitted::description,
          .steps = "clock cycles of the picture's pixels",
          .latch = latch_by<whitted::latch>,
          .kernels = whitted::fast::kernels},
};

static_assert(protocol::has_all_accelerators(models), "one line for each accelerator");

/// The model of a description. One that is in no registry ends the program, as position_of() says.
[[nodiscard]] constexpr const Model& model_of(const protocol::Accelerator& description) noexcept
{
    return models[protocol::position_of(description)];
}

} // namespace raymarch::engine
