// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

#include <array>

namespace model {

/// A 4 x 4 matrix, column-major as OpenGL takes it.
using Matrix4 = std::array<float, 16>;

/// A camera that orbits a point, y up. Shared by the viewport and by pictures made without one.
struct OrbitCamera
{
    Vec3f target;             ///< what it looks at
    float distance = 4;       ///< from the target, above zero
    float yaw = 0.6f;         ///< radians about +y; 0 looks along -z
    float pitch = 0.35f;      ///< radians, -pi/2..pi/2, positive looks down
    float fieldOfView = 0.7f; ///< vertical, radians

    Vec3f position() const;
    Vec3f right() const;
    Vec3f up() const;

    // dx, dy, x, y: to the right and down, in fractions of the picture's height.

    /// Turns the scene by a drag: half a circle for the picture's height. The pitch stops at the poles.
    void orbit(float dx, float dy);
    /// Moves the target in the picture plane so that a point dragged at the target's depth stays under the cursor.
    void pan(float dx, float dy);
    /// factor < 1 comes nearer.
    void zoom(float factor);
    /// As zoom(), but what is seen at x, y from the middle of the picture (at the target's depth) stays there.
    void zoomAt(float factor, float x, float y);
    /// Keeps the direction; all of `box` comes into a picture of this aspect (width / height). An empty box changes
    /// nothing.
    void fit(const Box3f &box, float aspect);

    Matrix4 viewMatrix() const;
    /// Near and far planes hold the sphere around `scene`, so that depth keeps its precision.
    Matrix4 projectionMatrix(float aspect, const Box3f &scene) const;
};

Matrix4 multiply(const Matrix4 &a, const Matrix4 &b);

} // namespace model
