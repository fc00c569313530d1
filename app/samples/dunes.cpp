// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/samples/samples.h"
#include "model/io/terrain/newterrain.h"
#include "model/terrain/tin/tinedit.h"

#include <cmath>

namespace samples {

model::Result<model::terrain::Terrain> makeDunes()
{
    // Millimetres would be enough; powers of two make the file small.
    constexpr double HeightStep = 1.0 / 1024;
    model::io::NewTerrain description;
    description.width = 120;
    description.depth = 90;
    description.spacing = 0.75;
    description.relief = {model::io::ReliefShape::Dunes, 7, 34, 7};
    description.layers = {{model::terrain::material(model::terrain::MaterialPreset::MoistSand), 2},
                          {model::terrain::material(model::terrain::MaterialPreset::DrySand), 2}};
    auto terrain = model::io::makeTerrain(description);
    if (!terrain)
        return terrain;
    model::terrain::TinEdit edit(terrain->tin, model::terrain::VolumeRule::Keep);
    const model::terrain::TinArrays &tin = terrain->tin.arrays();
    for (model::terrain::VertexId v = 0; v < tin.vertexSlots(); ++v)
        edit.setHeight(v, std::round(tin.heights[v] / HeightStep) * HeightStep);
    edit.commit();
    return terrain;
}

} // namespace samples
