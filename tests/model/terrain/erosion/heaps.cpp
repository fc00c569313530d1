// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/erosion/heaps.h"

#include <cmath>
#include <random>

namespace tests {

using namespace model::terrain;

Tin column(std::size_t vertices, unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(vertices);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = std::hypot(p.x - 0.5, p.y - 0.5) < 0.1 ? 0.5 : 0;
    }
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

Tin layeredColumn(std::size_t vertices, std::uint32_t layers, float humidity)
{
    Tin tin = column(vertices);
    TinEdit edit(tin);
    for (std::uint32_t l = 0; l < layers; ++l)
        edit.addLayer(l, 0);
    for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
        edit.setLayer(v, layers - 1, {tin.arrays().heights[v], humidity});
    edit.commit();
    return tin;
}

double steepestFace(const Tin &tin)
{
    double steepest = 0;
    for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
        if (tin.arrays().isTriangle(t) && !tin.arrays().isVoid(t))
            steepest = std::max(steepest, slopeOf(tin.arrays(), t) * 180 / M_PI);
    return steepest;
}

double steepestEdge(const Tin &tin)
{
    const TinArrays &arrays = tin.arrays();
    double steepest = 0;
    for (TriangleId t = 0; t < arrays.triangleSlots(); ++t)
        for (Corner c = cornerOf(t, 0); arrays.isTriangle(t) && c <= cornerOf(t, 2); ++c) {
            const Point2 a = arrays.pointAt(next(c)), b = arrays.pointAt(previous(c));
            const double drop =
                std::abs(arrays.heights[arrays.vertex(next(c))] - arrays.heights[arrays.vertex(previous(c))]);
            steepest = std::max(steepest, std::atan(drop / std::hypot(a.x - b.x, a.y - b.y)) * 180 / M_PI);
        }
    return steepest;
}

std::string bytesOf(const Tin &tin)
{
    std::string bytes;
    const auto add = [&](const auto &array) {
        bytes.append(reinterpret_cast<const char *>(array.data()), array.byteSize());
    };
    add(tin.arrays().points);
    add(tin.arrays().heights);
    add(tin.arrays().thicknesses);
    add(tin.arrays().humidities);
    add(tin.arrays().triangleVertices);
    add(tin.arrays().opposites);
    bytes.append(reinterpret_cast<const char *>(&tin.arrays().totals), sizeof(TinTotals));
    return bytes;
}

Edit settle(Tin &tin, Erosion &erosion, ErosionStatistics *statistics)
{
    TinEdit edit(tin);
    const auto settled = erosion.settle(edit);
    if (!settled)
        std::abort();
    if (statistics)
        *statistics = *settled;
    return edit.commit();
}

} // namespace tests
