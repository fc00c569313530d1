// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/snapshot/terrainpatch.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

/// A point counts as in a triangle down to this barycentric coordinate: rounding must leave no gaps between them.
constexpr double Tolerance = -1e-6;
/// Triangles thinner than this share of the patch's area hold no point that their neighbours do not.
constexpr double LeastArea = 1e-9;

double evaluate(const double (&plane)[3], double x, double y)
{
    return plane[0] * x + plane[1] * y + plane[2];
}

/// Twice the area, positive if counter-clockwise.
double doubleArea(const std::array<Vec3f, 3> &t)
{
    return (double(t[1].x) - t[0].x) * (double(t[2].y) - t[0].y) -
           (double(t[1].y) - t[0].y) * (double(t[2].x) - t[0].x);
}

} // namespace

std::uint32_t TerrainPatch::cellOf(double x) const
{
    const double cell = (x + radius) / (2 * radius) * CellsPerSide;
    return std::uint32_t(std::clamp(cell, 0.0, double(CellsPerSide - 1)));
}

template <class Visit>
void TerrainPatch::forEachCellOf(std::uint32_t triangle, Visit visit) const
{
    const auto &[a, b, c] = triangles[triangle];
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [front, back] = std::minmax({a.y, b.y, c.y});
    for (std::uint32_t y = cellOf(front); y <= cellOf(back); ++y)
        for (std::uint32_t x = cellOf(left); x <= cellOf(right); ++x)
            visit(y * CellsPerSide + x);
}

bool TerrainPatch::index()
{
    const double least = LeastArea * radius * radius;
    std::uint32_t kept = 0;
    for (std::uint32_t t = 0; t < triangleCount; ++t)
        if (std::abs(doubleArea(triangles[t])) > least)
            triangles[kept++] = triangles[t];
    triangleCount = kept;

    mCellBegins.fill(0);
    std::uint32_t entries = 0;
    for (std::uint32_t t = 0; t < triangleCount; ++t) {
        const auto &[a, b, c] = triangles[t];
        const double scale = 1 / doubleArea(triangles[t]);
        const auto opposite = [scale](Vec3f p, Vec3f q, double(&plane)[3]) { // 0 on p-q
            plane[0] = (double(p.y) - q.y) * scale;
            plane[1] = (double(q.x) - p.x) * scale;
            plane[2] = -(plane[0] * p.x + plane[1] * p.y);
        };
        Plane &plane = mPlanes[t];
        opposite(b, c, plane.first);
        opposite(c, a, plane.second);
        for (int i = 0; i < 3; ++i)
            plane.height[i] = (double(a.z) - c.z) * plane.first[i] + (double(b.z) - c.z) * plane.second[i];
        plane.height[2] += c.z;
        forEachCellOf(t, [&](std::uint32_t cell) {
            ++entries;
            ++mCellBegins[cell];
        });
        if (entries > MaxCellEntries) {
            triangleCount = 0;
            mCellBegins.fill(0);
            return false;
        }
    }
    std::uint16_t sum = 0;
    for (std::uint16_t &begin : mCellBegins)
        begin = sum = std::uint16_t(sum + begin);
    // Filled from behind, so that each cell's begin ends where it belongs, and its triangles keep their order.
    for (std::uint32_t t = triangleCount; t-- > 0;)
        forEachCellOf(t, [&](std::uint32_t cell) { mCellEntries[--mCellBegins[cell]] = std::uint16_t(t); });
    return true;
}

Ground TerrainPatch::groundAt(terrain::Point2 p) const
{
    const double x = p.x - centre.x, y = p.y - centre.y;
    if (!(std::abs(x) <= radius && std::abs(y) <= radius))
        return {};
    const std::uint32_t cell = cellOf(y) * CellsPerSide + cellOf(x);
    // The triangle that the point is deepest in: on an edge the first of two that agree.
    double best = Tolerance;
    const Plane *found = nullptr;
    for (std::uint32_t i = mCellBegins[cell]; i < mCellBegins[cell + 1]; ++i) {
        const Plane &plane = mPlanes[mCellEntries[i]];
        const double first = evaluate(plane.first, x, y), second = evaluate(plane.second, x, y);
        const double least = std::min({first, second, 1 - first - second});
        if (least > best) {
            best = least;
            found = &plane;
        }
    }
    if (!found)
        return {};
    return {centreHeight + evaluate(found->height, x, y), found->height[0], found->height[1], true};
}

} // namespace model::haptics
