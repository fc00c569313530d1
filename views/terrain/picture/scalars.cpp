// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/scalars.h"

#include <algorithm>

namespace views {

using namespace model::terrain;

GroundScalar thicknessOf(const Terrain &terrain, int layer)
{
    return [&terrain, layer](VertexId v) {
        const TinArrays &tin = terrain.tin.arrays();
        if (layer < 0)
            return float(tin.cover(v));
        return std::uint32_t(layer) < tin.layerCount() ? float(tin.thicknesses[tin.layerSlot(v, std::uint32_t(layer))])
                                                       : 0.0f;
    };
}

GroundScalar heightOver(const Terrain &terrain, std::shared_ptr<const Terrain> reference)
{
    if (!reference)
        return [](VertexId) { return 0.0f; };
    return [&terrain, reference = std::move(reference)](VertexId v) {
        const TinArrays &now = terrain.tin.arrays();
        const TinArrays &then = reference->tin.arrays();
        if (then.isVertex(v) && then.points[v] == now.points[v])
            return float(now.heights[v] - then.heights[v]);
        const Rectangle &domain = reference->tin.domain();
        const Point2 p{std::clamp(now.points[v].x, domain.low.x, domain.high.x),
                       std::clamp(now.points[v].y, domain.low.y, domain.high.y)};
        return float(now.heights[v] - reference->tin.heightAt(p));
    };
}

GroundScalar protectionOf(const Terrain &terrain, std::shared_ptr<const PaintMask> mask)
{
    if (!mask)
        return [](VertexId) { return 0.0f; };
    return [&terrain, mask = std::move(mask)](VertexId v) {
        return float(100 * mask->at(terrain.tin.arrays().points[v]));
    };
}

} // namespace views
