// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <span>

namespace model {

/// A point or direction in space, as it lies in GPU buffers and point caches.
struct Vec3f
{
    float x = 0, y = 0, z = 0;

    friend constexpr bool operator==(const Vec3f &, const Vec3f &) = default;
    friend constexpr Vec3f operator+(Vec3f a, Vec3f b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3f operator-(Vec3f a, Vec3f b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3f operator*(Vec3f a, float s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3f operator*(float s, Vec3f a) { return a * s; }
};
static_assert(sizeof(Vec3f) == 12);

constexpr float dot(Vec3f a, Vec3f b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3f cross(Vec3f a, Vec3f b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec3f a)
{
    return std::sqrt(dot(a, a));
}
/// Zero stays zero.
inline Vec3f normalized(Vec3f a)
{
    const float l = length(a);
    return l > 0 ? a * (1 / l) : a;
}
inline bool isFinite(Vec3f a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// An axis-aligned box; empty (min > max) until something is added.
struct Box3f
{
    Vec3f min{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    Vec3f max{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
              std::numeric_limits<float>::lowest()};

    bool isEmpty() const { return min.x > max.x; }
    void add(Vec3f p);
    void add(const Box3f &box);
    Vec3f center() const { return isEmpty() ? Vec3f{} : (min + max) * 0.5f; }
    Vec3f size() const { return isEmpty() ? Vec3f{} : max - min; }
    float longestSide() const;
    float diagonal() const { return length(size()); }
};

Box3f boundingBox(std::span<const Vec3f> points);

} // namespace model
