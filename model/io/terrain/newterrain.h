// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"

#include <vector>

namespace model::io {

/// A flat terrain.
struct NewTerrain
{
    double width = 100, depth = 100, originX = 0, originY = 0, height = 0;
    double spacing = 0; ///< of its vertices; 0: the corners alone
    struct Layer
    {
        terrain::Material material;
        double thickness = 0;
    };
    std::vector<Layer> layers;
};

/// \error LimitExceeded, BadSetting, BadValue
Result<terrain::Terrain> makeTerrain(const NewTerrain &description);

} // namespace model::io
