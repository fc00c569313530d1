// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/layers.h"

namespace commands {

using namespace model::terrain;

namespace {

void fill(TinEdit &edit, std::uint32_t layer, LayerSample sample)
{
    const TinArrays &tin = edit.tin().arrays();
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v) && !(tin.sample(v, layer) == sample))
            edit.setLayer(v, layer, sample);
}

} // namespace

EditSurface::Work addLayer(std::uint32_t layer, std::uint8_t material, LayerSample sample)
{
    return [=](TinEdit &edit) {
        edit.addLayer(layer, material);
        fill(edit, layer, sample);
    };
}

EditSurface::Work removeLayer(std::uint32_t layer)
{
    return [=](TinEdit &edit) { edit.removeLayer(layer); };
}

EditSurface::Work fillLayer(std::uint32_t layer, LayerSample sample)
{
    return [=](TinEdit &edit) { fill(edit, layer, sample); };
}

EditSurface::Work setLayerMaterial(std::uint32_t layer, std::uint8_t material)
{
    return [=](TinEdit &edit) { edit.setLayerMaterial(layer, material); };
}

} // namespace commands
