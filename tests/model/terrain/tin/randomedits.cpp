// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/tin/randomedits.h"

#include <algorithm>
#include <cmath>

namespace tests {

using namespace model::terrain;

const char *nameOf(Ground ground)
{
    switch (ground) {
    case Ground::Random:
        return "random";
    case Ground::Grid:
        return "grid";
    case Ground::FineGrid:
        return "fine grid";
    case Ground::Lines:
        return "lines";
    case Ground::Clusters:
        return "clusters";
    case Ground::Circles:
        return "circles";
    case Ground::Far:
        return "far";
    }
    return "";
}

PointSource::PointSource(Ground ground, unsigned seed)
    : mGround(ground)
    , mRandom(seed)
    , mDomain{{0, 0}, {1, 1}}
{
    if (ground == Ground::Grid || ground == Ground::FineGrid)
        mDomain = {{0, 0}, {12, 9}};
    if (ground == Ground::Circles)
        mDomain = {{-30, -30}, {30, 30}};
    if (ground == Ground::Far)
        mDomain = {{1e7, 2e7}, {1e7 + 100, 2e7 + 60}};
}

Point2 PointSource::point()
{
    const Point2 low = mDomain.low, high = mDomain.high;
    switch (mGround) {
    case Ground::Random:
        break;
    case Ground::Grid: // every four neighbours on a circle, many on the border, duplicates
        return {double(below(13)), double(below(10))};
    case Ground::FineGrid: // the same in numbers whose products are rounded
        return {below(121) * 0.1 > high.x ? high.x : below(121) * 0.1, std::min(below(91) * 0.1, high.y)};
    case Ground::Lines: { // collinear in one of eight directions, exactly or nearly
        const double s = uniform(0, 1);
        const std::uint32_t line = below(8);
        if (line < 4)
            return line & 1 ? Point2{s, 0.25 * (line + 1)} : Point2{0.25 * (line + 1), s};
        return {s, std::clamp(line * 0.2 - 0.5 + (line & 1 ? s : -s) * 0.75, 0.0, 1.0)};
    }
    case Ground::Clusters: { // six orders of magnitude of spacing
        const double radius = std::pow(10.0, -uniform(0, 6));
        const double angle = uniform(0, 6.283);
        const Point2 centre = below(2) ? Point2{0.3, 0.4} : Point2{0.7, 0.6};
        return {std::clamp(centre.x + 0.3 * radius * std::cos(angle), 0.0, 1.0),
                std::clamp(centre.y + 0.3 * radius * std::sin(angle), 0.0, 1.0)};
    }
    case Ground::Circles: { // many points on exactly one circle around the origin
        static constexpr double Triples[][2] = {{3, 4}, {7, 24}, {15, 20}, {0, 25}, {25, 0}, {20, 15}, {24, 7}, {0, 0}};
        const auto &triple = Triples[below(8)];
        const std::uint32_t signs = below(4);
        return {signs & 1 ? -triple[0] : triple[0], signs & 2 ? -triple[1] : triple[1]};
    }
    case Ground::Far: // big offsets: differences lose bits
        return {std::round(uniform(low.x, high.x) * 128) / 128, uniform(low.y, high.y)};
    }
    return {uniform(low.x, high.x), uniform(low.y, high.y)};
}

std::vector<Point3> PointSource::points(std::size_t count)
{
    std::vector<Point3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const Point2 p = point();
        points.push_back({p.x, p.y, uniform(-1, 1)});
    }
    return points;
}

namespace {

VertexId randomVertex(const TinArrays &tin, PointSource &source)
{
    for (;;)
        if (const VertexId v = source.below(tin.vertexSlots()); tin.isVertex(v))
            return v;
}

/// A vertex a few edges away.
VertexId randomNeighbour(const TinArrays &tin, VertexId v, PointSource &source)
{
    for (std::uint32_t steps = 1 + source.below(6); steps > 0; --steps) {
        Corner c = tin.corners[v];
        for (std::uint32_t turns = source.below(6); turns > 0; --turns)
            if (const Corner turned = tin.counterClockwise(c); turned != NoCorner)
                c = turned;
        v = tin.vertex(next(c));
    }
    return v;
}

} // namespace

void randomStep(TinEdit &edit, PointSource &source)
{
    const TinArrays &tin = edit.tin().arrays();
    switch (source.below(10)) {
    case 0:
    case 1:
    case 2:
        edit.insert(source.point());
        return;
    case 3:
        edit.insert(source.point(), source.uniform(-1, 1), randomVertex(tin, source));
        return;
    case 4:
    case 5:
    case 6: {
        const VertexId v = randomVertex(tin, source);
        if (edit.canRemove(v))
            edit.remove(v);
        return;
    }
    case 7: {
        const VertexId a = randomVertex(tin, source), b = randomNeighbour(tin, a, source);
        if (a != b)
            (void)edit.constrain(a, b, source.below(5), Crossing(source.below(3)));
        return;
    }
    case 8: {
        if (tin.records.size() == 0)
            return;
        const ConstraintRecord record = tin.records[source.below(std::uint32_t(tin.records.size()))];
        if (record.a == None || record.owner == VoidOwner)
            return;
        if (source.below(20) == 0)
            edit.releaseOwner(record.owner);
        else if (source.below(2))
            edit.releaseAll(record.a, record.b);
        else
            edit.release(record.a, record.b, record.owner);
        return;
    }
    default:
        edit.setHeight(randomVertex(tin, source), source.uniform(-1, 1));
    }
}

void randomLayerStep(TinEdit &edit, PointSource &source, bool changesCount)
{
    const TinArrays &tin = edit.tin().arrays();
    const std::uint32_t count = tin.layerCount();
    if (count == 0 || (changesCount && source.below(10) == 0)) {
        if (count == 0 || (count < MaxLayers && source.below(2)))
            return edit.addLayer(source.below(count + 1), std::uint8_t(source.below(3)));
        return edit.removeLayer(source.below(count));
    }
    const VertexId v = randomVertex(tin, source);
    const std::uint32_t layer = source.below(count);
    const LayerSample sample{source.uniform(0, 0.2), float(source.uniform(0, 1))};
    switch (source.below(6)) {
    case 0:
    case 1:
        return edit.setLayer(v, layer, sample);
    case 2:
        return edit.deposit(v, layer, sample);
    case 3:
        edit.press(v, source.uniform(0, 0.1));
        return;
    case 4: {
        const VertexId to = randomVertex(tin, source);
        if (edit.areaOf(v) > 0 && edit.areaOf(to) > 0)
            edit.transfer(v, to, source.uniform(-0.1, 0.1) * std::min(edit.areaOf(v), edit.areaOf(to)));
        return;
    }
    default:
        edit.setLayerMaterial(layer, std::uint8_t(source.below(3)));
    }
}

} // namespace tests
