// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using model::Sequence;
using model::Triangle;
using model::TriangleMesh;
using model::Vec3f;

namespace tests {

namespace {

TriangleMesh meshOf(std::vector<Vec3f> positions, std::vector<Triangle> triangles)
{
    const auto vertexCount = std::uint32_t(positions.size());
    return {std::move(positions), {vertexCount, std::move(triangles)}};
}

/// A sequence whose frame f holds move(position, f / frameCount) of each vertex.
SequencePtr animated(const TriangleMesh &mesh, std::uint32_t frameCount, std::string name,
                     const std::function<Vec3f(Vec3f, double)> &move)
{
    std::vector<Vec3f> positions;
    positions.reserve(std::size_t(frameCount) * mesh.positions.size());
    for (std::uint32_t frame = 0; frame < frameCount; ++frame)
        for (const Vec3f &position : mesh.positions)
            positions.push_back(move(position, double(frame) / frameCount));
    return std::make_shared<Sequence>(mesh.connectivity, std::move(positions), 25.0, std::move(name));
}

constexpr double FullTurn = 2 * std::numbers::pi;

} // namespace

TriangleMesh cube()
{
    return meshOf({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                  {{0, 2, 1},
                   {0, 3, 2},
                   {4, 5, 6},
                   {4, 6, 7},
                   {0, 1, 5},
                   {0, 5, 4},
                   {1, 2, 6},
                   {1, 6, 5},
                   {2, 3, 7},
                   {2, 7, 6},
                   {3, 0, 4},
                   {3, 4, 7}});
}

TriangleMesh tetrahedron()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TriangleMesh torus()
{
    constexpr std::uint32_t Around = 12, Across = 8;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < Around; ++i)
        for (std::uint32_t j = 0; j < Across; ++j) {
            const double u = FullTurn * i / Around, v = FullTurn * j / Across;
            const double radius = 2 + 0.5 * std::cos(v);
            mesh.positions.push_back(
                {float(radius * std::cos(u)), float(radius * std::sin(u)), float(0.5 * std::sin(v))});
            const auto at = [&](std::uint32_t di, std::uint32_t dj) {
                return (i + di) % Around * Across + (j + dj) % Across;
            };
            mesh.connectivity.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
            mesh.connectivity.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

TriangleMesh twoParts()
{
    TriangleMesh mesh = cube();
    const TriangleMesh second = tetrahedron();
    const std::uint32_t first = mesh.connectivity.vertexCount;
    for (const Vec3f &position : second.positions)
        mesh.positions.push_back(position + Vec3f{3, 0, 0});
    for (const Triangle &t : second.connectivity.triangles)
        mesh.connectivity.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.connectivity.vertexCount += second.connectivity.vertexCount;
    return mesh;
}

TriangleMesh degenerate()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 1, 3}, {0, 1, 2}, {0, 1, 3}});
}

TriangleMesh nonManifold()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
}

TriangleMesh bowTie()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
}

TriangleMesh misoriented()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}});
}

TriangleMesh oneTriangle()
{
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
}

TriangleMesh isolatedVertex()
{
    TriangleMesh mesh = tetrahedron();
    mesh.positions.push_back({5, 5, 5});
    mesh.connectivity.vertexCount += 1;
    return mesh;
}

TriangleMesh noTriangles()
{
    return meshOf({{0, 0, 0}, {1, 2, 3}, {-1, 0, 0.5f}}, {});
}

TriangleMesh oneVertex()
{
    return meshOf({{1, 2, 3}}, {});
}

TriangleMesh none()
{
    return {};
}

TriangleMesh grid(std::uint32_t columns, std::uint32_t rows)
{
    TriangleMesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column)
            mesh.positions.push_back({float(column) / float(columns), float(row) / float(rows), 0});
    const std::uint32_t width = columns + 1;
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = row * width + column;
            mesh.connectivity.triangles.push_back({corner, corner + 1, corner + width + 1});
            mesh.connectivity.triangles.push_back({corner, corner + width + 1, corner + width});
        }
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

const std::vector<NamedMesh> &namedMeshes()
{
    static const std::vector<NamedMesh> meshes{
        {"cube", cube()},
        {"tetrahedron", tetrahedron()},
        {"torus", torus()},
        {"two parts", twoParts()},
        {"degenerate", degenerate()},
        {"non-manifold", nonManifold()},
        {"bow tie", bowTie()},
        {"misoriented", misoriented()},
        {"one triangle", oneTriangle()},
        {"isolated vertex", isolatedVertex()},
        {"no triangles", noTriangles()},
        {"one vertex", oneVertex()},
        {"none", none()},
        {"grid", grid()},
    };
    return meshes;
}

SequencePtr rigidRotation(const TriangleMesh &mesh, std::uint32_t frameCount)
{
    return animated(mesh, frameCount, "rotation", [](Vec3f p, double time) {
        const double c = std::cos(FullTurn * time), s = std::sin(FullTurn * time);
        return Vec3f{float(c * p.x - s * p.y), float(s * p.x + c * p.y), p.z};
    });
}

SequencePtr wave(const TriangleMesh &mesh, std::uint32_t frameCount)
{
    return animated(mesh, frameCount, "wave", [](Vec3f p, double time) {
        return p + Vec3f{0, 0, float(0.2 * std::sin(FullTurn * time + 3.0 * p.x + 2.0 * p.y))};
    });
}

SequencePtr noise(const TriangleMesh &mesh, std::uint32_t frameCount, std::uint32_t seed)
{
    // The engine's numbers are the standard's, those of its distributions are not.
    std::mt19937 random(seed);
    const auto shift = [&random] { return float(double(random()) / double(std::mt19937::max()) * 0.2 - 0.1); };
    return animated(mesh, frameCount, "noise", [&shift](Vec3f p, double) {
        const float x = shift(), y = shift(), z = shift();
        return p + Vec3f{x, y, z};
    });
}

SequencePtr constant(const TriangleMesh &mesh, std::uint32_t frameCount)
{
    return animated(mesh, frameCount, "constant", [](Vec3f p, double) { return p; });
}

SequencePtr oneFrame(const TriangleMesh &mesh)
{
    return constant(mesh, 1);
}

const std::vector<NamedAnimation> &namedAnimations()
{
    static const std::vector<NamedAnimation> animations = [] {
        std::vector<NamedAnimation> result;
        for (const NamedMesh &entry : namedMeshes())
            if (!entry.mesh.positions.empty())
                result.push_back({"wave of " + entry.name, wave(entry.mesh)});
        result.push_back({"rotating cube", rigidRotation(cube(), 30)});
        result.push_back({"noisy torus", noise(torus(), 20)});
        result.push_back({"noisy tetrahedron, more frames than coordinates", noise(tetrahedron(), 40)});
        result.push_back({"constant grid", constant(grid())});
        result.push_back({"one frame of a cube", oneFrame(cube())});
        result.push_back({"one frame of one vertex", oneFrame(oneVertex())});
        result.push_back({"two frames of a grid", wave(grid(), 2)});
        return result;
    }();
    return animations;
}

} // namespace tests
