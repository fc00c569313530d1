// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. Meyer, M. Desbrun, P. Schroeder, A. Barr: Discrete Differential-Geometry Operators for Triangulated
// 2-Manifolds, 2003
#include "model/mesh/analysis/vertexfields.h"

#include "model/geometry/vec3d.h"
#include "model/mesh/analysis/facelinks.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace model {

namespace {

constexpr float NoValue = std::numeric_limits<float>::quiet_NaN();

double length(Vec3d v)
{
    return std::sqrt(dot(v, v));
}

/// What the triangles around a vertex add up to.
struct Sums
{
    double area = 0;  ///< mixed
    double angle = 0; ///< radians
    Vec3d bend;       ///< 2 x area x mean curvature normal, pointing inwards where it bulges
    Vec3d normal;     ///< of the triangles, weighted by area
};

void addTriangle(const std::array<Vec3d, 3> &p, const Triangle &triangle, std::vector<Sums> &sums)
{
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
    const double twiceArea = length(normal);
    if (!(twiceArea > 0))
        return;
    std::array<double, 3> cotangent{}, angle{};
    unsigned obtuse = 3;
    for (unsigned i = 0; i < 3; ++i) {
        const Vec3d a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        cotangent[i] = dot(a, b) / twiceArea;
        angle[i] = std::atan2(twiceArea, dot(a, b));
        if (cotangent[i] < 0)
            obtuse = i;
    }
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
        Sums &sum = sums[triangle[i]];
        sum.angle += angle[i];
        sum.normal = sum.normal + normal;
        sum.bend = sum.bend + (p[j] - p[i]) * (cotangent[k] / 2) + (p[k] - p[i]) * (cotangent[j] / 2); // eq. 8
        if (obtuse == 3)                                                                               // eq. 7
            sum.area += (squaredDistance(p[i], p[j]) * cotangent[k] + squaredDistance(p[i], p[k]) * cotangent[j]) / 8;
        else
            sum.area += twiceArea / (obtuse == i ? 4 : 8);
    }
}

} // namespace

std::vector<float> valences(const Faces &faces)
{
    const FaceLinks links(faces);
    std::vector<float> result(faces.vertexCount(), NoValue);
    for (const std::uint32_t vertex : faces.vertices())
        result[vertex] = 0;
    const auto count = [&](Edge edge) {
        ++result[edge[0]];
        ++result[edge[1]];
    };
    for (std::uint32_t side = 0; side < faces.cornerCount(); ++side)
        if (links.isBorder(side) || (links.isLinked(side) && side < links.across(side)))
            count(links.edge(side));
    for (const FaceLinks::CrowdedEdge &crowded : links.crowded())
        count(crowded.edge);
    return result;
}

Curvatures curvatures(const Faces &faces, std::span<const Vec3f> positions)
{
    const FaceLinks links(faces);
    std::vector<Sums> sums(faces.vertexCount());
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto face = faces.face(f);
        for (std::size_t i = 2; i < face.size(); ++i)
            addTriangle({Vec3d(positions[face[0]]), Vec3d(positions[face[i - 1]]), Vec3d(positions[face[i]])},
                        {face[0], face[i - 1], face[i]}, sums);
    }
    std::vector<bool> isInside(faces.vertexCount(), true);
    for (std::uint32_t side = 0; side < faces.cornerCount(); ++side)
        if (!links.isLinked(side))
            isInside[faces.vertex(side)] = isInside[faces.sideEnd(side)] = false;
    Curvatures result{std::vector<float>(sums.size(), NoValue), std::vector<float>(sums.size(), NoValue)};
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const Sums &sum = sums[v];
        if (!isInside[v] || !(sum.area > 0))
            continue;
        const double size = length(sum.bend) / (2 * sum.area);
        result.mean[v] = float(dot(sum.bend, sum.normal) > 0 ? -size : size);
        result.gaussian[v] = float((2 * std::numbers::pi - sum.angle) / sum.area);
    }
    return result;
}

} // namespace model
