// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinwriter.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

/// Spreads the values of `from` layers to `to` for each vertex; layer `l` of the new ones is `source(l)` of the old.
template <class T, class Source>
FlatArray<T> rearranged(const FlatArray<T> &values, std::size_t vertices, std::uint32_t from, std::uint32_t to,
                        Source source)
{
    FlatArray<T> result;
    result.resize(vertices * to);
    for (std::size_t v = 0; v < vertices; ++v)
        for (std::uint32_t l = 0; l < to; ++l)
            result[v * to + l] = source(l) < from ? values[v * from + source(l)] : T(0);
    return result;
}

} // namespace

void TinWriter::moveLayers(VertexId v, double up)
{
    touchColumn(v);
    double *const thickness = tin.thicknesses.data() + tin.layerSlot(v, 0);
    std::uint32_t l = tin.layerCount();
    if (up > 0)
        thickness[l - 1] += up;
    for (double down = -up; down > 0 && l > 0;) {
        const double taken = std::min(down, thickness[--l]);
        thickness[l] -= taken;
        down -= taken;
    }
}

void TinWriter::setColumn(VertexId v, const Weights &weights)
{
    touchColumn(v);
    for (std::uint32_t l = 0; l < tin.layerCount(); ++l) {
        double thickness = 0, water = 0, humidity = 0;
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (weights.vertices[i] == None)
                continue;
            const LayerSample sample = tin.sample(weights.vertices[i], l);
            thickness += weights.weights[i] * sample.thickness;
            water += weights.weights[i] * sample.thickness * double(sample.humidity);
            humidity += weights.weights[i] * double(sample.humidity);
        }
        // Of what is there; where nothing is, what the neighbours would have.
        if (thickness > 0)
            humidity = water / thickness;
        tin.thicknesses[tin.layerSlot(v, l)] = thickness;
        tin.humidities[tin.layerSlot(v, l)] = float(std::clamp(humidity, 0.0, 1.0));
    }
}

void TinWriter::addLayer(std::uint32_t layer, std::uint8_t material)
{
    LayerTable &table = tin.totals.layers;
    assert(layer <= table.count && table.count < MaxLayers);
    if (mIsRecording)
        mJournal.touchAllColumns(tin);
    const std::uint32_t count = table.count;
    const auto source = [&](std::uint32_t l) { return l < layer ? l : l > layer ? l - 1 : count; };
    tin.thicknesses = rearranged(tin.thicknesses, tin.vertexSlots(), count, count + 1, source);
    tin.humidities = rearranged(tin.humidities, tin.vertexSlots(), count, count + 1, source);
    std::copy_backward(table.materials + layer, table.materials + count, table.materials + count + 1);
    std::copy_backward(tin.totals.compacted + layer, tin.totals.compacted + count, tin.totals.compacted + count + 1);
    table.materials[layer] = material;
    tin.totals.compacted[layer] = {};
    ++table.count;
}

void TinWriter::removeLayer(std::uint32_t layer)
{
    LayerTable &table = tin.totals.layers;
    assert(layer < table.count);
    if (mIsRecording)
        mJournal.touchAllColumns(tin);
    const std::uint32_t count = table.count;
    const auto source = [&](std::uint32_t l) { return l < layer ? l : l + 1; };
    tin.thicknesses = rearranged(tin.thicknesses, tin.vertexSlots(), count, count - 1, source);
    tin.humidities = rearranged(tin.humidities, tin.vertexSlots(), count, count - 1, source);
    std::copy(table.materials + layer + 1, table.materials + count, table.materials + layer);
    std::copy(tin.totals.compacted + layer + 1, tin.totals.compacted + count, tin.totals.compacted + layer);
    --table.count;
    table.materials[table.count] = 0;
    tin.totals.compacted[table.count] = {};
}

} // namespace model::terrain
