// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/io/terrain/relief.h"
#include "model/terrain/terrain.h"

#include <vector>

namespace model::io {

/// What lies on the ground, everywhere as thick.
struct NewLayer
{
    terrain::Material material;
    double thickness = 0;
};

/// A rectangle of ground, and what lies on it.
struct NewTerrain
{
    double width = 100, depth = 100, originX = 0, originY = 0, height = 0;
    double spacing = 0; ///< of its vertices; 0: the corners alone
    using Layer = NewLayer;
    std::vector<Layer> layers; ///< the upmost last; they are part of the height
    ReliefSettings relief{};   ///< above `height`
};

/// Vertices that makeTerrain() would make.
double vertexCountOf(const NewTerrain &description);

/// Lays `layers` on a terrain without layers, whose height stays: the bedrock below them sinks. \error LimitExceeded
Result<void> addLayers(terrain::Terrain &terrain, const std::vector<NewLayer> &layers);

/// \error LimitExceeded, BadValue; BadSetting (a relief without height or wavelength); Cancelled
Result<terrain::Terrain> makeTerrain(const NewTerrain &description, const Progress &progress = Progress());

} // namespace model::io
