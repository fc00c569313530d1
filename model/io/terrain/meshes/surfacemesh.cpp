// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/meshes/surfacemesh.h"

#include "model/terrain/tin/predicates.h"
#include "model/terrain/tin/tinedit.h"

#include <QCoreApplication>

#include <array>

namespace model::io {

using namespace terrain;

namespace {

std::string placeText(const Point3 &p)
{
    char text[96];
    std::snprintf(text, sizeof text, "x %.7g, y %.7g", p.x, p.y);
    return text;
}

tl::unexpected<Error> failAt(const Point3 &p, const char *why)
{
    return fail(ErrorCode::NotASurface, placeText(p), why);
}

} // namespace

Result<Tin> tinOfSurface(std::span<const Point3> positions, std::span<const Triangle> triangles,
                         const Progress &progress)
{
    // Vertices of no face are no part of the surface.
    std::vector<std::uint32_t> pointOf(positions.size(), None);
    std::vector<Point3> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (const Triangle &triangle : triangles) {
        const Point3 a = positions[triangle[0]], b = positions[triangle[1]], c = positions[triangle[2]];
        const int side = orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        if (side == 0) {
            const bool isFlat = (a.x == b.x && a.y == b.y && a.z != b.z) || (b.x == c.x && b.y == c.y && b.z != c.z) ||
                                (c.x == a.x && c.y == a.y && c.z != a.z);
            // A sliver without an area is nothing; one that stands upright is a wall.
            const double nx = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
            const double ny = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
            if (isFlat || nx != 0 || ny != 0)
                return failAt(a, QT_TRANSLATE_NOOP("ErrorText", "a face stands upright"));
            continue;
        }
        std::array<std::uint32_t, 3> face;
        for (std::size_t i = 0; i < 3; ++i) {
            std::uint32_t &point = pointOf[triangle[side > 0 ? i : 2 - i]];
            if (point == None) {
                point = std::uint32_t(points.size());
                points.push_back(positions[triangle[side > 0 ? i : 2 - i]]);
            }
            face[i] = point;
        }
        faces.push_back(face);
    }
    if (points.empty())
        return fail(ErrorCode::NoVertices);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    Result<BuiltTin> built = buildTin(points, boundsOf(points));
    if (!built)
        return fail(built.error());
    Tin &tin = built->tin;
    // Vertices at the same place must have one height, the corners of the domain included.
    for (std::size_t p = 0; p < points.size(); ++p)
        if (tin.arrays().heights[built->vertexOf[p]] != points[p].z)
            return failAt(points[p], QT_TRANSLATE_NOOP("ErrorText", "a point lies above another"));
    progress.report(0.4);

    TinEdit edit(tin, VolumeRule::Keep);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (f % 4096 == 0 && progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % 3];
            if (!edit.constrain(built->vertexOf[a], built->vertexOf[b], SurfaceOwner))
                return failAt(points[a], QT_TRANSLATE_NOOP("ErrorText", "edges cross, seen from above"));
        }
    }
    progress.report(0.8);
    std::vector<bool> isCovered(tin.arrays().triangleSlots());
    for (const auto &face : faces) {
        const VertexId a = built->vertexOf[face[0]], b = built->vertexOf[face[1]], c = built->vertexOf[face[2]];
        const Corner corner = cornerOfEdge(tin.arrays(), a, b);
        if (corner == NoCorner || tin.arrays().vertex(corner) != c || tin.arrays().vertex(next(corner)) != a ||
            isCovered[triangleOf(corner)])
            return failAt(points[face[0]], QT_TRANSLATE_NOOP("ErrorText", "faces lie above one another"));
        isCovered[triangleOf(corner)] = true;
    }
    std::vector<TriangleId> voids;
    for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
        if (!isCovered[t])
            voids.push_back(t);
    edit.setVoid(voids, true);
    edit.commit();
    return std::move(tin);
}

} // namespace model::io
