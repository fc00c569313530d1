// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

namespace model {

/// A point or direction in double: what measuring computes with.
struct Vec3d
{
    double x = 0, y = 0, z = 0;

    constexpr Vec3d() = default;
    constexpr Vec3d(double x_, double y_, double z_)
        : x(x_)
        , y(y_)
        , z(z_)
    {}
    constexpr Vec3d(Vec3f v)
        : x(v.x)
        , y(v.y)
        , z(v.z)
    {}

    friend constexpr bool operator==(const Vec3d &, const Vec3d &) = default;
    friend constexpr Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3d operator*(Vec3d a, double s) { return {a.x * s, a.y * s, a.z * s}; }
};

constexpr double dot(Vec3d a, Vec3d b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3d cross(Vec3d a, Vec3d b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squaredDistance(Vec3d a, Vec3d b)
{
    return dot(a - b, a - b);
}
inline double distance(Vec3d a, Vec3d b)
{
    return std::sqrt(squaredDistance(a, b));
}

} // namespace model
