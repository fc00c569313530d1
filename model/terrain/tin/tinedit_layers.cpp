// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace model::terrain {

namespace {

/// Puts `amount` of another humidity into a layer: the water of both is in it afterwards.
void mixIn(double &thickness, float &humidity, double amount, double added)
{
    const double sum = thickness + amount;
    if (sum > 0)
        humidity = float(std::clamp((thickness * double(humidity) + amount * added) / sum, 0.0, 1.0));
    thickness = sum;
}

} // namespace

void TinEdit::addLayer(std::uint32_t layer, std::uint8_t material)
{
    assert(mIsOpen);
    mWriter.addLayer(layer, material);
}

void TinEdit::removeLayer(std::uint32_t layer)
{
    assert(mIsOpen);
    mWriter.removeLayer(layer);
}

void TinEdit::setLayerMaterial(std::uint32_t layer, std::uint8_t material)
{
    assert(mIsOpen && layer < mArrays.layerCount());
    mArrays.totals.layers.materials[layer] = material;
}

void TinEdit::setLayer(VertexId v, std::uint32_t layer, LayerSample sample)
{
    assert(mIsOpen && layer < mArrays.layerCount());
    mWriter.touchColumn(v);
    mArrays.thicknesses[mArrays.layerSlot(v, layer)] = sample.thickness;
    mArrays.humidities[mArrays.layerSlot(v, layer)] = sample.humidity;
}

void TinEdit::deposit(VertexId v, std::uint32_t layer, LayerSample sample)
{
    assert(mIsOpen && layer < mArrays.layerCount() && sample.thickness >= 0);
    if (sample.thickness == 0)
        return;
    mArrays.totals.ledger.added.add(sample.thickness * areaOf(v));
    mWriter.touchColumn(v);
    mWriter.setHeight(v, mArrays.heights[v] + sample.thickness);
    const std::size_t slot = mArrays.layerSlot(v, layer);
    mixIn(mArrays.thicknesses[slot], mArrays.humidities[slot], sample.thickness, double(sample.humidity));
}

double TinEdit::press(VertexId v, double depth)
{
    assert(mIsOpen && depth >= 0);
    const double area = areaOf(v);
    double pressed = 0;
    mWriter.touchColumn(v);
    for (std::uint32_t l = mArrays.layerCount(); l-- > 0 && pressed < depth;) {
        double &thickness = mArrays.thicknesses[mArrays.layerSlot(v, l)];
        const double taken = std::min(depth - pressed, thickness);
        thickness -= taken;
        pressed += taken;
        mArrays.totals.compacted[l].add(taken * area);
    }
    mArrays.totals.ledger.pressed.add(pressed * area);
    mWriter.setHeight(v, mArrays.heights[v] - pressed);
    return pressed;
}

void TinEdit::bookPressed(double volume)
{
    assert(mIsOpen && volume >= 0);
    mArrays.totals.ledger.pressed.add(volume);
    if (mArrays.layerCount() > 0)
        mArrays.totals.compacted[mArrays.layerCount() - 1].add(volume);
    mWriter.leak.add(volume);
}

void TinEdit::place(VertexId v, double height, const double *thicknesses, const float *humidities)
{
    assert(mIsOpen);
    mWriter.setHeight(v, height);
    if (mArrays.layerCount() == 0)
        return;
    mWriter.touchColumn(v);
    std::copy_n(thicknesses, mArrays.layerCount(), mArrays.thicknesses.data() + mArrays.layerSlot(v, 0));
    std::copy_n(humidities, mArrays.layerCount(), mArrays.humidities.data() + mArrays.layerSlot(v, 0));
}

void TinEdit::transfer(VertexId from, VertexId to, double volume)
{
    assert(mIsOpen);
    if (volume < 0)
        return transfer(to, from, -volume);
    const double fromArea = areaOf(from), toArea = areaOf(to);
    assert(fromArea > 0 && toArea > 0);
    const double lowered = volume / fromArea, raised = volume / toArea;
    if (mArrays.layerCount() > 0 && from != to) {
        mWriter.touchColumn(from);
        mWriter.touchColumn(to);
        double left = lowered;
        for (std::uint32_t l = mArrays.layerCount(); l-- > 0 && left > 0;) {
            const std::size_t source = mArrays.layerSlot(from, l), target = mArrays.layerSlot(to, l);
            const double taken = std::min(left, mArrays.thicknesses[source]);
            mArrays.thicknesses[source] -= taken;
            mixIn(mArrays.thicknesses[target], mArrays.humidities[target], taken * fromArea / toArea,
                  double(mArrays.humidities[source]));
            left -= taken;
        }
        // Bedrock that was dug out is loose material where it comes to lie.
        if (left > 0)
            mArrays.thicknesses[mArrays.layerSlot(to, mArrays.layerCount() - 1)] += left * fromArea / toArea;
    }
    mWriter.setHeight(from, mArrays.heights[from] - lowered);
    mWriter.setHeight(to, mArrays.heights[to] + raised);
    mArrays.totals.ledger.moved.add(volume);
}

} // namespace model::terrain
