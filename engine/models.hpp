// SPDX-License-Identifier: MIT
/// @file
/// The registry of models: one line an accelerator, beside protocol/accelerators.hpp.
#pragma once

#include "engine/fractal/fast/kernels.hpp"
#include "engine/fractal/fractal.hpp"
#include "engine/mandelbulb/fast/kernels.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/marcher/fast/kernels.hpp"
#include "engine/marcher/marcher.hpp"
#include "engine/model.hpp"
#include "engine/sphere/fast/kernels.hpp"
#include "engine/sphere/sphere.hpp"
#include "engine/whitted/fast/kernels.hpp"
#include "engine/whitted/whitted.hpp"
#include "protocol/accelerators.hpp"

#include <array>

namespace raymarch::engine
{

inline constexpr std::array models = {
    Model{.description = &protocol::marcher::description,
          .steps = "scene queries",
          .draw_row = marcher::draw_row,
          .frame_cycles = marcher::frame_cycles,
          .kernels = marcher::fast::kernels},
    Model{.description = &protocol::fractal::description,
          .steps = "scene queries",
          .draw_row = fractal::draw_row,
          .frame_cycles = fractal::frame_cycles,
          .frames_of_a_still = fractal::frames_of_a_still,
          .kernels = fractal::fast::kernels},
    Model{.description = &protocol::sphere::description,
          .steps = "clock edges (prototype: runs of the ray-sphere unit)",
          .draw_row = sphere::draw_row,
          .frame_cycles = sphere::frame_cycles,
          .finish = sphere::finish,
          .kernels = sphere::fast::kernels},
    Model{.description = &protocol::mandelbulb::description,
          .steps = "evaluations of the distance",
          .draw_row = mandelbulb::draw_row,
          .frame_cycles = mandelbulb::frame_cycles,
          .kernels = mandelbulb::fast::kernels},
    Model{.description = &protocol::whitted::description,
          .steps = "clock cycles of the picture's pixels",
          .draw_row = whitted::draw_row,
          .frame_cycles = whitted::frame_cycles,
          .frame_rays = whitted::frame_rays,
          .kernels = whitted::fast::kernels},
};

/// The model of a description that stands in protocol::accelerators.
/// It compares kinds, as g++'s undefined sanitizer takes no comparison of addresses for a constant.
[[nodiscard]] constexpr const Model& model_of(const protocol::Accelerator& description) noexcept
{
    for (const Model& model : models)
        if (model.description->kind == description.kind)
            return model;
    return models[0];
}

} // namespace raymarch::engine
