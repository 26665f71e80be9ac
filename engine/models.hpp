// SPDX-License-Identifier: MIT
/// @file
/// The registry of models: one line an accelerator, beside protocol/accelerators.hpp.
#pragma once

#include "engine/fractal/fractal.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/marcher/marcher.hpp"
#include "engine/model.hpp"
#include "engine/sphere/sphere.hpp"
#include "engine/whitted/whitted.hpp"
#include "protocol/accelerators.hpp"

#include <array>

namespace raymarch::engine
{

inline constexpr std::array models = {
    Model{&protocol::marcher::description, marcher::draw_row, marcher::frame_cycles},
    Model{&protocol::fractal::description, fractal::draw_row, fractal::frame_cycles, nullptr,
          fractal::frames_of_a_still},
    Model{&protocol::sphere::description, sphere::draw_row, sphere::frame_cycles, sphere::finish},
    Model{&protocol::mandelbulb::description, mandelbulb::draw_row, mandelbulb::frame_cycles},
    Model{&protocol::whitted::description, whitted::draw_row, whitted::frame_cycles},
};

/// The model of a description that stands in protocol::accelerators.
[[nodiscard]] constexpr const Model& model_of(const protocol::Accelerator& description) noexcept
{
    for (const Model& model : models)
        if (model.description == &description)
            return model;
    return models[0];
}

} // namespace raymarch::engine
