// SPDX-License-Identifier: MIT
#include "motion/colour.hpp"

#include "motion/nearest_code.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace raymarch::motion
{

using namespace protocol; // NOLINT(google-build-using-namespace): most names

void set_hue(const Accelerator& accelerator, double hue, State& state) noexcept
{
    const double sextant = std::floor(hue * 6.0);
    const double rising = hue * 6.0 - sextant;
    const double falling = 1.0 - rising;
    const std::array<Triple, 6> wheel = {{{1, rising, 0},
                                          {falling, 1, 0},
                                          {0, 1, rising},
                                          {0, falling, 1},
                                          {rising, 0, 1},
                                          {1, 0, falling}}};
    set_triple(accelerator, accelerator.colour->channels,
               wheel[static_cast<std::size_t>(sextant) % wheel.size()], state);
}

} // namespace raymarch::motion
