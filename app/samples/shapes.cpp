// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/samples/shapes.h"

#include <cmath>
#include <map>
#include <numbers>

namespace samples {

using model::TriangleMesh;
using model::Vec3f;

Pose Pose::in(const Pose &parent) const
{
    const auto turned = [&](Vec3f d) { return parent(d) - parent.origin; };
    return {turned(x), turned(y), turned(z), parent(origin)};
}

Pose moved(Vec3f by)
{
    Pose pose;
    pose.origin = by;
    return pose;
}

Pose turnedX(float angle)
{
    const float c = std::cos(angle), s = std::sin(angle);
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
}

Pose turnedY(float angle)
{
    const float c = std::cos(angle), s = std::sin(angle);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
}

Pose turnedZ(float angle)
{
    const float c = std::cos(angle), s = std::sin(angle);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
}

TriangleMesh closedSurface(int rings, int segments, const std::function<Vec3f(float, float)> &point)
{
    TriangleMesh mesh;
    mesh.positions.push_back(point(0, 0));
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < segments; ++s)
            mesh.positions.push_back(point(float(r + 1) / float(rings + 1), float(s) / float(segments)));
    mesh.positions.push_back(point(1, 0));

    const auto at = [&](int ring, int segment) { return std::uint32_t(1 + ring * segments + segment % segments); };
    const std::uint32_t last = std::uint32_t(mesh.positions.size() - 1);
    auto &triangles = mesh.connectivity.triangles;
    for (int s = 0; s < segments; ++s) {
        triangles.push_back({0, at(0, s), at(0, s + 1)});
        for (int r = 0; r + 1 < rings; ++r) {
            triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        triangles.push_back({at(rings - 1, s), last, at(rings - 1, s + 1)});
    }
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

TriangleMesh ellipsoid(Vec3f radii, int rings, int segments)
{
    return closedSurface(rings, segments, [&](float u, float v) {
        const float polar = u * std::numbers::pi_v<float>, around = v * 2 * std::numbers::pi_v<float>;
        return Vec3f{radii.x * std::sin(polar) * std::sin(around), radii.y * std::cos(polar),
                     radii.z * std::sin(polar) * std::cos(around)};
    });
}

TriangleMesh limb(float length, float top, float bottom, int segments)
{
    constexpr int CapRings = 5, ShaftRings = 6;
    constexpr int Rings = 2 * CapRings + ShaftRings;
    return closedSurface(Rings, segments, [&](float u, float v) {
        const float ring = u * float(Rings + 1);
        const float around = v * 2 * std::numbers::pi_v<float>;
        float radius, y;
        if (ring <= CapRings) {
            const float polar = ring / CapRings * std::numbers::pi_v<float> / 2;
            radius = top * std::sin(polar);
            y = top * std::cos(polar);
        } else if (ring >= Rings + 1 - CapRings) {
            const float polar = (float(Rings + 1) - ring) / CapRings * std::numbers::pi_v<float> / 2;
            radius = bottom * std::sin(polar);
            y = -length - bottom * std::cos(polar);
        } else {
            const float along = (ring - CapRings) / float(Rings + 1 - 2 * CapRings);
            radius = top + (bottom - top) * along;
            y = -length * along;
        }
        return Vec3f{radius * std::sin(around), y, radius * std::cos(around)};
    });
}

TriangleMesh icosphere(float radius, int levels)
{
    const float g = std::numbers::phi_v<float>;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.connectivity.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.positions.size()));
            if (isNew)
                mesh.positions.push_back(mesh.positions[a] + mesh.positions[b]);
            return it->second;
        };
        std::vector<model::Triangle> finer;
        for (const auto &[a, b, c] : mesh.connectivity.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.connectivity.triangles = std::move(finer);
        for (Vec3f &p : mesh.positions)
            p = model::normalized(p);
    }
    for (Vec3f &p : mesh.positions)
        p = model::normalized(p) * radius;
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

void append(TriangleMesh &mesh, const TriangleMesh &part)
{
    const std::uint32_t offset = mesh.connectivity.vertexCount;
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const auto &[a, b, c] : part.connectivity.triangles)
        mesh.connectivity.triangles.push_back({a + offset, b + offset, c + offset});
    mesh.connectivity.vertexCount += part.connectivity.vertexCount;
}

} // namespace samples
