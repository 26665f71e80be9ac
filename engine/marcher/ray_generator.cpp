// SPDX-License-Identifier: MIT
#include "engine/marcher/ray_generator.hpp"

#include "engine/marcher/inverse_sqrt.hpp"

namespace raymarch::engine::marcher
{

Point ray_direction(const Frame& frame, PictureSize size, std::uint16_t x, std::uint16_t y) noexcept
{
    // |u| + |v| + |f| <= 1919 + 1079 + 1080, times 2^17: below 2^29.
    const std::int32_t u = 2 * x + 1 - size.width;
    const std::int32_t v = size.height - 1 - 2 * y;
    const std::int32_t f = size.height;
    return normalise({u * frame.right.x + v * frame.up.x - f * frame.forward.x,
                      u * frame.right.y + v * frame.up.y - f * frame.forward.y,
                      u * frame.right.z + v * frame.up.z - f * frame.forward.z});
}

} // namespace raymarch::engine::marcher
