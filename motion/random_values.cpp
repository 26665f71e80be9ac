// SPDX-License-Identifier: MIT
#include "motion/random_values.hpp"

#include "motion/colour.hpp"
#include "motion/orbit_camera.hpp"
#include "protocol/groups.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace raymarch::motion
{

using namespace protocol; // NOLINT(google-build-using-namespace): most names

void randomise(const Accelerator& accelerator, std::string_view group, std::mt19937_64& random,
               State& state) noexcept
{
    const auto in_group = [&](std::size_t i) {
        return is_in_group(accelerator.parameters[i], group);
    };
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const Parameter& parameter = accelerator.parameters[i];
        // At the upper end of the range only an empty tail is valid, so this end is left out.
        const std::int64_t largest = std::min(
            parameter.max_scaled - (parameter.tail_bits > 0 ? 1 : 0), parameter.largest_code);
        if (in_group(i))
            state.codes[i] = std::uniform_int_distribution(parameter.min_scaled, largest)(random);
    }
    if (accelerator.camera && in_group(accelerator.camera->zoom)) {
        const double yaw = std::uniform_real_distribution(0.0, 360.0)(random);
        // If the sine of the pitch is uniform, the points are uniform on the sphere. The poles
        // are left out.
        const double sine = std::uniform_real_distribution(-0.999, 0.999)(random);
        const double pitch = std::asin(sine) * 180.0 / std::numbers::pi;
        set_orbit(accelerator, yaw, pitch, state);
    }
    if (accelerator.colour && in_group(accelerator.colour->channels[0]))
        set_hue(accelerator, std::uniform_real_distribution(0.0, 1.0)(random), state);
}

} // namespace raymarch::motion
