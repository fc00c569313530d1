// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/groundreading.h"

#include "model/terrain/tin/query/surface.h"
#include "views/sculpt/materialtitles.h"

#include <cmath>

namespace views {

using namespace model::terrain;

std::optional<GroundReading> readingAt(const Terrain &terrain, const GroundEvent &event)
{
    const Point2 p{event.point.x, event.point.y};
    if (!event.isOnTerrain || !terrain.tin.domain().contains(p))
        return std::nullopt;
    const TinArrays &tin = terrain.tin.arrays();
    const TriangleId t = terrain.tin.triangleAt(p);
    GroundReading reading;
    reading.point = {p.x, p.y, terrain.tin.heightAt(p)};
    reading.slope = slopeOf(tin, t) * 180 / M_PI;
    reading.isByKeys = event.isByKeys;
    // Of the nearest vertex: materials do not mix between vertices.
    VertexId nearest = tin.vertex(cornerOf(t, 0));
    const auto distance = [&](VertexId v) { return std::hypot(tin.points[v].x - p.x, tin.points[v].y - p.y); };
    for (const VertexId v : {tin.vertex(cornerOf(t, 1)), tin.vertex(cornerOf(t, 2))})
        if (distance(v) < distance(nearest))
            nearest = v;
    for (std::uint32_t layer = tin.layerCount(); layer-- > 0;)
        if (const LayerSample sample = tin.sample(nearest, layer); sample.thickness > 0) {
            reading.humidity = sample.humidity;
            reading.material = titleOf(terrain.materialOf(layer));
            break;
        }
    return reading;
}

} // namespace views
