// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/snapshot/patchbuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace model::haptics {

using namespace terrain;

namespace {

constexpr std::uint32_t SamplesPerSide = 16;
static_assert(2 * (SamplesPerSide - 1) * (SamplesPerSide - 1) <= TerrainPatch::MaxTriangles);

/// A square that seems to hold so many patches is not searched: that would take as long as there are triangles.
constexpr double SearchedPatches = 4;
constexpr std::uint32_t ProbesPerSide = 8;

/// In radii of the patch: corners further away would not be exact enough as floats.
constexpr double LongestReach = 1000;

/// Of the layer that one meets first, and how wet it is there; bare rock where there is none.
Feel feelAt(const Terrain &terrain, Point2 p)
{
    const TinArrays &tin = terrain.tin.arrays();
    if (tin.layerCount() == 0)
        return feelOf(material(MaterialPreset::DrySand), 0); // a surface without materials is the sand it looks like
    const TriangleId t = terrain.tin.triangleAt(p);
    for (std::uint32_t l = tin.layerCount(); l-- > 0;) {
        double thickness = 0, water = 0;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
            const LayerSample sample = tin.sample(tin.vertex(c), l);
            thickness += sample.thickness;
            water += sample.thickness * double(sample.humidity);
        }
        if (thickness > 0)
            return feelOf(terrain.materialOf(l), water / thickness);
    }
    return rockFeel();
}

/// About how many triangles the square around a place holds: by the areas of those at some places.
double triangleEstimate(const Tin &tin, Point2 centre, double radius)
{
    const double cell = 2 * radius / ProbesPerSide;
    double count = 0;
    VertexId near = None;
    for (std::uint32_t j = 0; j < ProbesPerSide; ++j)
        for (std::uint32_t i = 0; i < ProbesPerSide; ++i) {
            const Point2 p{centre.x - radius + (i + 0.5) * cell, centre.y - radius + (j + 0.5) * cell};
            if (!tin.domain().contains(p))
                continue;
            const TriangleId t = tin.triangleAt(p, near);
            near = tin.arrays().vertex(cornerOf(t, 0));
            const Point2 a = tin.arrays().pointAt(cornerOf(t, 0)), b = tin.arrays().pointAt(cornerOf(t, 1)),
                         c = tin.arrays().pointAt(cornerOf(t, 2));
            const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
            count += cell * cell / std::max(area, 1e-12 * cell * cell);
        }
    return count;
}

} // namespace

void PatchBuilder::build(const Terrain &terrain, Point2 centre, double radius, TerrainPatch &patch)
{
    patch.centre = centre;
    patch.radius = radius;
    patch.triangleCount = 0;
    patch.centreHeight = 0;
    patch.feel = {};
    const Tin &tin = terrain.tin;
    if (std::isfinite(centre.x) && std::isfinite(centre.y) && tin.domain().contains(centre)) {
        patch.centreHeight = tin.heightAt(centre);
        patch.feel = feelAt(terrain, centre);
        if (triangleEstimate(tin, centre, radius) < SearchedPatches * TerrainPatch::MaxTriangles) {
            // The disc around the patch's square.
            mSearch.search(tin, centre, radius * std::numbers::sqrt2);
            if (takeTriangles(tin, patch) && patch.index())
                return;
        }
        sample(tin, patch);
    }
    patch.index();
}

bool PatchBuilder::takeTriangles(const Tin &tin, TerrainPatch &patch) const
{
    const TinArrays &arrays = tin.arrays();
    patch.triangleCount = 0;
    for (const TriangleId t : mSearch.triangles()) {
        if (arrays.isVoid(t))
            continue;
        if (patch.triangleCount == TerrainPatch::MaxTriangles)
            return false;
        std::array<Vec3f, 3> &corners = patch.triangles[patch.triangleCount++];
        for (std::uint32_t i = 0; i < 3; ++i) {
            const VertexId v = arrays.vertex(cornerOf(t, i));
            if (std::abs(arrays.points[v].x - patch.centre.x) > LongestReach * patch.radius ||
                std::abs(arrays.points[v].y - patch.centre.y) > LongestReach * patch.radius)
                return false;
            corners[i] = {float(arrays.points[v].x - patch.centre.x), float(arrays.points[v].y - patch.centre.y),
                          float(arrays.heights[v] - patch.centreHeight)};
        }
    }
    return true;
}

void PatchBuilder::sample(const Tin &tin, TerrainPatch &patch)
{
    std::array<std::array<Vec3f, SamplesPerSide>, SamplesPerSide> heights;
    std::array<std::array<bool, SamplesPerSide>, SamplesPerSide> known{};
    VertexId near = None;
    for (std::uint32_t j = 0; j < SamplesPerSide; ++j)
        for (std::uint32_t i = 0; i < SamplesPerSide; ++i) {
            const auto offset = [&](std::uint32_t k) { return patch.radius * (2.0 * k / (SamplesPerSide - 1) - 1); };
            const Point2 p{patch.centre.x + offset(i), patch.centre.y + offset(j)};
            if (!tin.domain().contains(p))
                continue;
            const TriangleId t = tin.triangleAt(p, near);
            near = tin.arrays().vertex(cornerOf(t, 0));
            known[j][i] = !tin.arrays().isVoid(t);
            heights[j][i] = {float(offset(i)), float(offset(j)),
                             float(heightIn(tin.arrays(), t, p) - patch.centreHeight)};
        }
    patch.triangleCount = 0;
    for (std::uint32_t j = 0; j + 1 < SamplesPerSide; ++j)
        for (std::uint32_t i = 0; i + 1 < SamplesPerSide; ++i) {
            if (!known[j][i] || !known[j][i + 1] || !known[j + 1][i] || !known[j + 1][i + 1])
                continue;
            patch.triangles[patch.triangleCount++] = {heights[j][i], heights[j][i + 1], heights[j + 1][i + 1]};
            patch.triangles[patch.triangleCount++] = {heights[j][i], heights[j + 1][i + 1], heights[j + 1][i]};
        }
}

} // namespace model::haptics
