// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/newterrain.h"

#include "model/terrain/tin/tinedit.h"

#include <algorithm>
#include <cmath>

namespace model::io {

using namespace terrain;

namespace {

struct Grid
{
    double columns, rows; ///< of cells
};

Grid gridOf(const NewTerrain &description)
{
    if (!(description.spacing > 0))
        return {1, 1};
    return {std::ceil(description.width / description.spacing), std::ceil(description.depth / description.spacing)};
}

Result<void> check(const ReliefSettings &relief)
{
    if (relief.shape == ReliefShape::Flat)
        return {};
    const auto isPositive = [](double value) { return std::isfinite(value) && value > 0; };
    if (!isPositive(relief.height))
        return fail(ErrorCode::BadSetting, "height", std::to_string(relief.height), "above 0");
    if (!isPositive(relief.wavelength))
        return fail(ErrorCode::BadSetting, "wavelength", std::to_string(relief.wavelength), "above 0");
    return {};
}

} // namespace

double vertexCountOf(const NewTerrain &description)
{
    const Grid grid = gridOf(description);
    return (grid.columns + 1) * (grid.rows + 1);
}

Result<void> addLayers(Terrain &terrain, const std::vector<NewLayer> &layers)
{
    if (layers.size() > MaxLayers)
        return fail(ErrorCode::LimitExceeded, "number of layers", std::to_string(layers.size()),
                    std::to_string(MaxLayers));
    TinEdit edit(terrain.tin);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const NewLayer &layer = layers[l];
        terrain.materials.push_back(layer.material);
        edit.addLayer(std::uint32_t(l), std::uint8_t(l));
        for (VertexId v = 0; v < terrain.tin.arrays().vertexSlots(); ++v)
            edit.setLayer(v, std::uint32_t(l), {layer.thickness, float(layer.material.humidity)});
    }
    edit.commit();
    return {};
}

Result<Terrain> makeTerrain(const NewTerrain &description, const Progress &progress)
{
    constexpr double MostVertices = 1e8;
    const double spacing = description.spacing;
    if (!(vertexCountOf(description) <= MostVertices))
        return fail(ErrorCode::LimitExceeded, "number of points", std::to_string(vertexCountOf(description)),
                    std::to_string(std::uint64_t(MostVertices)));
    if (auto checked = check(description.relief); !checked)
        return fail(checked.error());
    const Grid grid = gridOf(description);
    const Relief relief(description.relief);
    std::vector<Point3> points;
    for (double j = 0; j <= grid.rows && spacing > 0; ++j) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        progress.report(0.3 * j / grid.rows);
        for (double i = 0; i <= grid.columns; ++i) {
            const Point2 p{std::min(i * spacing, description.width), std::min(j * spacing, description.depth)};
            points.push_back({p.x, p.y, description.height + relief.heightAt(p)});
        }
    }
    auto built = buildTin(points, {{0, 0}, {description.width, description.depth}});
    if (!built)
        return fail(built.error());
    Terrain terrain(std::move(built->tin));
    terrain.geoReference.originX = description.originX;
    terrain.geoReference.originY = description.originY;
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    progress.report(0.7);
    TinEdit edit(terrain.tin);
    if (points.empty())
        for (VertexId v = 0; v < 4; ++v)
            edit.setHeight(v, description.height + relief.heightAt(terrain.tin.arrays().points[v]));
    edit.commit();
    if (auto added = addLayers(terrain, description.layers); !added)
        return fail(added.error());
    return terrain;
}

} // namespace model::io
