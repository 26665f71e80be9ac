// SPDX-License-Identifier: MIT
/// @file
/// Three components of one number type; arithmetic is that of the components.
#pragma once

namespace raymarch::engine
{

template <typename T>
struct Vec3
{
    T x{};
    T y{};
    T z{};

    [[nodiscard]] friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[nodiscard]] friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    bool operator==(const Vec3&) const = default;
};

/// Applies the function to each component.
template <typename T, typename Function>
[[nodiscard]] constexpr auto map(const Vec3<T>& v, Function function) noexcept
{
    return Vec3<decltype(function(v.x))>{function(v.x), function(v.y), function(v.z)};
}

} // namespace raymarch::engine
