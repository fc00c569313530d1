// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/snapshot/terrainpatch.h"
#include "model/terrain/terrain.h"
#include "model/terrain/tin/query/disc.h"

namespace model::haptics {

/// Cuts the patch around a tool out of a terrain. Keep one: it keeps the marks of its search.
class PatchBuilder
{
public:
    /// Fills all of `patch` but its id and time.
    ///
    /// The triangles are the terrain's own if they are few enough; where the terrain is finer than a patch can hold,
    /// heights sampled in a grid of 15 x 15 cells. A place outside the domain gives an empty patch.
    /// Precondition: `radius` is above 0. Cost: that of a few hundred look-ups and of some thousand
    /// triangles at most, unless most of a fine ground hides between the places that are looked at.
    void build(const terrain::Terrain &terrain, terrain::Point2 centre, double radius, TerrainPatch &patch);

private:
    bool takeTriangles(const terrain::Tin &tin, TerrainPatch &patch) const;
    static void sample(const terrain::Tin &tin, TerrainPatch &patch);

    terrain::DiscSearch mSearch;
};

} // namespace model::haptics
