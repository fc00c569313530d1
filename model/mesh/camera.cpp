// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/camera.h"

#include <algorithm>
#include <numbers>

namespace model {

namespace {

constexpr float HalfPi = std::numbers::pi_v<float> / 2;
/// Limits of the distance: beyond them float positions of the camera lose all precision.
constexpr float MinDistance = 1e-12f;
constexpr float MaxDistance = 1e18f;
/// Space left around a box that is fitted, as a share of the picture; judged by eye.
constexpr float FitMargin = 0.06f;
/// The near plane is never nearer than this share of the far plane: 24 bits of depth still tell surfaces apart.
constexpr float MinNearToFar = 1e-4f;

/// From the target towards the camera.
Vec3f backward(const OrbitCamera &camera)
{
    return {std::sin(camera.yaw) * std::cos(camera.pitch), std::sin(camera.pitch),
            std::cos(camera.yaw) * std::cos(camera.pitch)};
}

} // namespace

Vec3f OrbitCamera::position() const
{
    return target + backward(*this) * distance;
}

Vec3f OrbitCamera::right() const
{
    return {std::cos(yaw), 0, -std::sin(yaw)};
}

Vec3f OrbitCamera::up() const
{
    return {-std::sin(yaw) * std::sin(pitch), std::cos(pitch), -std::cos(yaw) * std::sin(pitch)};
}

void OrbitCamera::orbit(float dx, float dy)
{
    // The whole height turns by half a circle, as if the scene were a ball that fills the picture.
    yaw = std::remainder(yaw - dx * 2 * HalfPi, 4 * HalfPi);
    pitch = std::clamp(pitch + dy * 2 * HalfPi, -HalfPi, HalfPi);
}

void OrbitCamera::pan(float dx, float dy)
{
    const float height = 2 * distance * std::tan(fieldOfView / 2);
    target = target - right() * (dx * height) + up() * (dy * height);
}

void OrbitCamera::zoom(float factor)
{
    distance = std::clamp(distance * factor, MinDistance, MaxDistance);
}

void OrbitCamera::zoomAt(float factor, float x, float y)
{
    // The point of the picture plane under (x, y) moves to the middle, and back after the zoom.
    pan(-x, -y);
    zoom(factor);
    pan(x, y);
}

void OrbitCamera::fit(const Box3f &box, float aspect)
{
    if (box.isEmpty())
        return;
    target = box.center();
    const float slopeY = std::tan(fieldOfView / 2) * (1 - FitMargin);
    const float slopeX = slopeY * aspect;
    const Vec3f half = box.size() * 0.5f;
    float wanted = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3f p{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z};
        const float depth = dot(p, backward(*this));
        wanted =
            std::max({wanted, depth + std::abs(dot(p, right())) / slopeX, depth + std::abs(dot(p, up())) / slopeY});
    }
    distance = wanted > 0 ? std::clamp(wanted, MinDistance, MaxDistance) : 1; // a single point fits from anywhere
}

Matrix4 OrbitCamera::viewMatrix() const
{
    const Vec3f x = right(), y = up(), z = backward(*this), eye = position();
    return {x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1};
}

Matrix4 OrbitCamera::projectionMatrix(float aspect, const Box3f &scene) const
{
    const float radius = std::max(scene.isEmpty() ? 0 : scene.diagonal() / 2, distance * 1e-3f);
    const float depth = scene.isEmpty() ? distance : dot(position() - scene.center(), backward(*this));
    const float farPlane = std::max(depth + radius, distance * 1e-2f) * 1.01f;
    const float nearPlane = std::max((depth - radius) * 0.99f, farPlane * MinNearToFar);
    const float scale = 1 / std::tan(fieldOfView / 2);
    Matrix4 m{};
    m[0] = scale / aspect;
    m[5] = scale;
    m[10] = (farPlane + nearPlane) / (nearPlane - farPlane);
    m[11] = -1;
    m[14] = 2 * farPlane * nearPlane / (nearPlane - farPlane);
    return m;
}

Matrix4 multiply(const Matrix4 &a, const Matrix4 &b)
{
    Matrix4 product{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k)
                product[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    return product;
}

} // namespace model
