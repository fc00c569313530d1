// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/newterrain.h"

#include "model/terrain/tin/tinedit.h"

#include <algorithm>
#include <cmath>

namespace model::io {

using namespace terrain;

Result<Terrain> makeTerrain(const NewTerrain &description)
{
    constexpr double MostVertices = 1e8;
    const double spacing = description.spacing;
    const double columns = spacing > 0 ? std::ceil(description.width / spacing) : 1;
    const double rows = spacing > 0 ? std::ceil(description.depth / spacing) : 1;
    if (!((columns + 1) * (rows + 1) <= MostVertices))
        return fail(ErrorCode::LimitExceeded, "number of points", std::to_string((columns + 1) * (rows + 1)),
                    std::to_string(std::uint64_t(MostVertices)));
    if (description.layers.size() > MaxLayers)
        return fail(ErrorCode::LimitExceeded, "number of layers", std::to_string(description.layers.size()),
                    std::to_string(MaxLayers));
    std::vector<Point3> points;
    for (double j = 0; j <= rows; ++j)
        for (double i = 0; i <= columns; ++i)
            points.push_back({std::min(i * spacing, description.width), std::min(j * spacing, description.depth),
                              description.height});
    if (!(spacing > 0))
        points.clear();
    auto built = buildTin(points, {{0, 0}, {description.width, description.depth}});
    if (!built)
        return fail(built.error());
    Terrain terrain(std::move(built->tin));
    terrain.geoReference.originX = description.originX;
    terrain.geoReference.originY = description.originY;
    TinEdit edit(terrain.tin);
    if (points.empty())
        for (VertexId v = 0; v < 4; ++v)
            edit.setHeight(v, description.height);
    for (std::size_t l = 0; l < description.layers.size(); ++l) {
        const NewTerrain::Layer &layer = description.layers[l];
        terrain.materials.push_back(layer.material);
        edit.addLayer(std::uint32_t(l), std::uint8_t(l));
        for (VertexId v = 0; v < terrain.tin.arrays().vertexSlots(); ++v)
            edit.setLayer(v, std::uint32_t(l), {layer.thickness, float(layer.material.humidity)});
    }
    edit.commit();
    return terrain;
}

} // namespace model::io
