// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/material/material.h"
#include "model/terrain/tin/tin.h"

#include <string>
#include <vector>

namespace model::terrain {

/// Where the local frame of a terrain lies in the world.
struct GeoReference
{
    double originX = 0, originY = 0; ///< of the local frame, in the units of the coordinate system
    std::string crs;                 ///< the coordinate reference system as WKT; empty if unknown
    std::string unit = "metre";

    friend bool operator==(const GeoReference &, const GeoReference &) = default;
};

/// No longer list of materials: layers name them by a byte, and people by reading through them.
inline constexpr std::size_t LargestMaterialList = 64;

/// A terrain: its surface with layers, what these are made of, and where it lies. Which material a layer is belongs to
/// the TIN (TinTotals::layers) and is undone with it; the materials themselves are plain values.
struct Terrain
{
    Tin tin;
    std::vector<Material> materials;
    GeoReference geoReference;

    explicit Terrain(Tin surface)
        : tin(std::move(surface))
    {}

    /// The material of a mobile layer. Precondition: the layer exists, and check() holds.
    const Material &materialOf(std::uint32_t layer) const
    {
        return materials[tin.arrays().totals.layers.materials[layer]];
    }

    /// What one meets first at `p`, which lies in the domain: the material of the topmost layer with any thickness
    /// there. Null on bare rock.
    const Material *topMaterialAt(Point2 p) const;

    /// What a layer weighs, in kg: that of its volume as poured, and of what was pressed out of it. Cost: O(n).
    double mass(std::uint32_t layer) const;
    /// What a cubic metre of a layer weighs now, on average; as poured if the layer is empty. Cost: O(n).
    double bulkDensity(std::uint32_t layer) const;

    /// A digest of all that is saved.
    std::uint64_t fingerprint() const;
};

/// \error BadSetting     a material's parameter (prefixed by "materials[i].")
/// \error LimitExceeded  too many materials
/// \error BadValue       a layer of a material that is not in the list
/// \error NonFinite      an origin that is no number
/// \error BrokenTerrain  as validate(const Tin &)
Result<void> validate(const Terrain &terrain);

} // namespace model::terrain
