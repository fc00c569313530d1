// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/terrain.h"

#include "model/base/digest.h"
#include "model/terrain/tin/validate.h"

#include <cmath>

namespace model::terrain {

namespace {

std::uint64_t digestOfText(const std::string &text, std::uint64_t seed)
{
    return digestOfArray<char>(text, seed);
}

std::uint64_t digestOfMaterial(const Material &m, std::uint64_t seed)
{
    const double values[] = {m.humidity,     m.bulkDensity, m.compressibility, m.insideSlope,
                             m.outsideSlope, m.roughness,   m.liquidity,       m.compression};
    seed = digestOfText(m.name, seed);
    seed = digestOfArray<CriticalAngle>(m.criticalAngles, seed);
    return digestOfArray<double>(values, seed);
}

} // namespace

const Material *Terrain::topMaterialAt(Point2 p) const
{
    const TinArrays &arrays = tin.arrays();
    const TriangleId t = tin.triangleAt(p);
    for (std::uint32_t l = arrays.layerCount(); l-- > 0;)
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
            if (arrays.sample(arrays.vertex(c), l).thickness > 0)
                return &materialOf(l);
    return nullptr;
}

double Terrain::mass(std::uint32_t layer) const
{
    return materialOf(layer).bulkDensity * (tin.layerVolume(layer) + tin.arrays().totals.compacted[layer].value());
}

double Terrain::bulkDensity(std::uint32_t layer) const
{
    const double volume = tin.layerVolume(layer);
    return volume > 0 ? mass(layer) / volume : materialOf(layer).bulkDensity;
}

std::uint64_t Terrain::fingerprint() const
{
    std::uint64_t digest = tin.fingerprint();
    for (const Material &m : materials)
        digest = digestOfMaterial(m, digest);
    const double origin[] = {geoReference.originX, geoReference.originY};
    digest = digestOfArray<double>(origin, digest);
    return digestOfText(geoReference.unit, digestOfText(geoReference.crs, digest));
}

Result<void> validate(const Terrain &terrain)
{
    if (terrain.materials.size() > LargestMaterialList)
        return fail(ErrorCode::LimitExceeded, "number of materials", std::to_string(terrain.materials.size()),
                    std::to_string(LargestMaterialList));
    for (std::size_t i = 0; i < terrain.materials.size(); ++i)
        if (auto checked = check(terrain.materials[i]); !checked) {
            checked.error().args[0].insert(0, "materials[" + std::to_string(i) + "].");
            return checked;
        }
    if (!std::isfinite(terrain.geoReference.originX) || !std::isfinite(terrain.geoReference.originY))
        return fail(ErrorCode::NonFinite, "origin");
    if (auto valid = validate(terrain.tin); !valid)
        return valid;
    const LayerTable &layers = terrain.tin.arrays().totals.layers;
    for (std::uint32_t l = 0; l < layers.count; ++l)
        if (layers.materials[l] >= terrain.materials.size())
            return fail(ErrorCode::BadValue, "material of layer " + std::to_string(l),
                        std::to_string(layers.materials[l]), "below " + std::to_string(terrain.materials.size()));
    return {};
}

} // namespace model::terrain
