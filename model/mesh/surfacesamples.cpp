// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018 (the R2 sequence).
#include "model/mesh/surfacesamples.h"

#include "model/geometry/vec3d.h"

#include <cmath>

namespace model {

namespace {

/// Turns sizes into whole numbers in proportion to them: what one leaves over goes to the next, as in METRO.
std::vector<std::uint32_t> shares(std::span<const double> sizes, double samplesPerUnit)
{
    std::vector<std::uint32_t> counts(sizes.size());
    double due = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        due += sizes[i] * samplesPerUnit;
        const double whole = std::floor(due);
        counts[i] = std::uint32_t(std::min(whole, 4e9));
        due -= whole;
    }
    return counts;
}

} // namespace

SampleCounts countSamples(std::span<const Vec3f> positions, std::span<const Triangle> triangles,
                          std::span<const Edge> edges, double samplesPerTriangle)
{
    std::vector<double> areas(triangles.size()), lengths(edges.size());
    double area = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Vec3d a = positions[triangles[i][0]];
        const Vec3d normal = cross(Vec3d(positions[triangles[i][1]]) - a, Vec3d(positions[triangles[i][2]]) - a);
        areas[i] = std::sqrt(dot(normal, normal)) / 2;
        area += areas[i];
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        lengths[i] = distance(positions[edges[i][0]], positions[edges[i][1]]);
    const double density = area > 0 ? samplesPerTriangle * double(triangles.size()) / area : 0;
    return {shares(lengths, std::sqrt(density)), shares(areas, density)};
}

std::array<double, 3> triangleSample(std::uint32_t index)
{
    // 1/p and 1/p^2 of the plastic number p: no two points of the sequence come near each other.
    constexpr double StepU = 0.7548776662466927, StepV = 0.5698402909980532;
    double whole = 0;
    double u = std::modf(0.5 + StepU * (index + 1.0), &whole);
    double v = std::modf(0.5 + StepV * (index + 1.0), &whole);
    if (u + v > 1) { // the other half of the square
        u = 1 - u;
        v = 1 - v;
    }
    return {1 - u - v, u, v};
}

} // namespace model
