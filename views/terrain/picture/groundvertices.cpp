// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/groundvertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace views {

using namespace model::terrain;

namespace {

/// Thinner layers let what is below show through; metres for a terrain of any size.
constexpr double ThinnestLayer = 1e-9;
/// Tangents of 10 and 22 degrees: below the first nothing slides, from the second on all that changes does.
constexpr float FlattestSlide = 0.176f, SteepSlide = 0.404f;
/// What passes through a place, of what comes to it or leaves it. Chosen by looking at slopes that erode.
constexpr float SlideFlow = 1.5f;

QColor colorOf(MaterialPreset preset)
{
    switch (preset) {
    case MaterialPreset::DrySand:
        return {222, 190, 140};
    case MaterialPreset::MoistSand:
        return {190, 152, 104};
    case MaterialPreset::Mud:
        return {110, 84, 60};
    case MaterialPreset::Snow:
        return {240, 244, 250};
    case MaterialPreset::Gravel:
        return {150, 146, 140};
    case MaterialPreset::Custom:
        break;
    }
    return {206, 172, 128};
}

} // namespace

QColor colorOf(const Material &material)
{
    for (const MaterialPreset preset : EveryMaterialPreset)
        if (material.name == nameOf(preset))
            return colorOf(preset);
    return colorOf(presetOf(material));
}

QColor bedrockColor(bool hasLayers)
{
    return hasLayers ? QColor(122, 112, 104) : colorOf(MaterialPreset::DrySand);
}

Point3 normalAt(const TinArrays &tin, VertexId v)
{
    const Point2 p = tin.points[v];
    const double height = tin.heights[v];
    Point3 sum;
    forEachCornerAround(tin, v, [&](Corner c) {
        if (tin.isVoid(triangleOf(c)))
            return;
        const VertexId a = tin.vertex(next(c)), b = tin.vertex(previous(c));
        const Point3 u{tin.points[a].x - p.x, tin.points[a].y - p.y, tin.heights[a] - height};
        const Point3 w{tin.points[b].x - p.x, tin.points[b].y - p.y, tin.heights[b] - height};
        const double weight = 1 / ((u.x * u.x + u.y * u.y + u.z * u.z) * (w.x * w.x + w.y * w.y + w.z * w.z));
        sum.x += (u.y * w.z - u.z * w.y) * weight;
        sum.y += (u.z * w.x - u.x * w.z) * weight;
        sum.z += (u.x * w.y - u.y * w.x) * weight;
    });
    const double size = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
    if (!(size > 0) || !std::isfinite(size))
        return {0, 0, 1};
    return {sum.x / size, sum.y / size, sum.z / size};
}

GroundSlide slid(GroundSlide slide, float before, const GroundHeight &now, float reach)
{
    const float x = float(now.normalX) / 32767, z = float(now.normalZ) / 32767;
    const float across = std::hypot(x, z);
    const float slope = across / std::sqrt(std::max(1 - across * across, 1e-6f));
    const float steep = std::clamp((slope - FlattestSlide) / (SteepSlide - FlattestSlide), 0.0f, 1.0f);
    if (!(steep > 0))
        return slide;
    const float steps = SlideFlow * steep * std::abs(now.y - before) / slope / reach * float(SlideSteps);
    const auto moved = [](std::int16_t from, float by) {
        constexpr float Most = std::numeric_limits<std::int16_t>::max();
        return std::int16_t(std::lround(std::clamp(float(from) + by, -Most, Most)));
    };
    return {moved(slide.x, steps * x / across), moved(slide.z, steps * z / across)};
}

GroundVertexMaker::GroundVertexMaker(const Terrain &terrain, const GroundFrame &frame)
    : mTerrain(terrain)
    , mFrame(frame)
{
    updateColors();
}

void GroundVertexMaker::updateColors()
{
    mColors.clear();
    const std::uint32_t layers = mTerrain.tin.arrays().layerCount();
    for (std::uint32_t layer = 0; layer < layers; ++layer)
        mColors.push_back(colorOf(mTerrain.materialOf(layer)));
    mColors.push_back(bedrockColor(layers > 0));
}

std::uint32_t GroundVertexMaker::topLayer(const TinArrays &tin, VertexId v)
{
    for (std::uint32_t layer = tin.layerCount(); layer-- > 0;)
        if (tin.thicknesses[tin.layerSlot(v, layer)] > ThinnestLayer)
            return layer;
    return tin.layerCount();
}

model::Vec3f GroundVertexMaker::position(VertexId v) const
{
    const TinArrays &tin = mTerrain.tin.arrays();
    return mFrame.toScene(tin.points[v].x, tin.points[v].y, tin.heights[v]);
}

GroundPlace GroundVertexMaker::place(VertexId v) const
{
    const model::Vec3f p = position(v);
    return {p.x, p.z};
}

GroundHeight GroundVertexMaker::height(VertexId v) const
{
    const Point3 normal = normalAt(mTerrain.tin.arrays(), v);
    return {position(v).y, std::int16_t(std::lround(normal.x * 32767)), std::int16_t(std::lround(-normal.y * 32767))};
}

GroundPaint GroundVertexMaker::paint(VertexId v) const
{
    const TinArrays &tin = mTerrain.tin.arrays();
    const std::uint32_t layer = topLayer(tin, v);
    const QColor &color = mColors[std::min<std::size_t>(layer, mColors.size() - 1)];
    GroundPaint paint{std::uint8_t(color.red()), std::uint8_t(color.green()), std::uint8_t(color.blue()), 0};
    if (layer < tin.layerCount())
        paint.humidity =
            std::uint8_t(std::lround(std::clamp(tin.humidities[tin.layerSlot(v, layer)], 0.0f, 1.0f) * 255));
    return paint;
}

} // namespace views
