// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/normals.h"

#include <algorithm>
#include <vector>

namespace model {

namespace {

constexpr Vec3f NoNormal{0, 0, 1};
/// Squared lengths outside this range have lost bits to underflow or overflow in float.
constexpr float SmallestSquare = 1e-30f;
constexpr float LargestSquare = 1e30f;

constexpr float SmallSide = 1e-15f;

struct Vec3d
{
    double x = 0, y = 0, z = 0;
};

/// The same in double, whose range holds products of any two float coordinates.
void computeInDouble(std::span<const Vec3f> positions, std::span<const Triangle> triangles, std::span<Vec3f> normals)
{
    std::vector<Vec3d> sums(positions.size());
    for (const auto &[a, b, c] : triangles) {
        const Vec3f p = positions[a], q = positions[b], r = positions[c];
        const Vec3d u{double(q.x) - p.x, double(q.y) - p.y, double(q.z) - p.z};
        const Vec3d v{double(r.x) - p.x, double(r.y) - p.y, double(r.z) - p.z};
        const Vec3d n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        for (const std::uint32_t i : {a, b, c}) {
            sums[i].x += n.x;
            sums[i].y += n.y;
            sums[i].z += n.z;
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Vec3d &n = sums[i];
        const double l = std::hypot(n.x, n.y, n.z);
        normals[i] = l > 0 ? Vec3f{float(n.x / l), float(n.y / l), float(n.z / l)} : NoNormal;
    }
}

} // namespace

void computeVertexNormals(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                          std::span<Vec3f> normals)
{
    std::ranges::fill(normals, Vec3f{});
    // Scattering each triangle's normal to its corners beats gathering per vertex: no adjacency to read, and meshes
    // come in an order that keeps neighbouring vertices in the cache (figures: tests/bench/bench_mesh.cpp).
    for (const auto &[a, b, c] : triangles) {
        const Vec3f n = cross(positions[b] - positions[a], positions[c] - positions[a]);
        normals[a] = normals[a] + n;
        normals[b] = normals[b] + n;
        normals[c] = normals[c] + n;
    }
    bool needsDouble = false, hasZero = false;
    for (Vec3f &n : normals) {
        const float square = dot(n, n);
        if (square >= SmallestSquare && square <= LargestSquare) {
            n = n * (1 / std::sqrt(square));
        } else {
            (n == Vec3f{} ? hasZero : needsDouble) = true;
            n = NoNormal;
        }
    }
    // A mesh may be so small that every product vanishes.
    if (needsDouble || (hasZero && boundingBox(positions).longestSide() < SmallSide))
        computeInDouble(positions, triangles, normals);
}

} // namespace model
