// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "views/terrain/groundinteraction.h"

#include <QString>

#include <optional>

namespace views {

/// What lies under the cursor.
struct GroundReading
{
    model::terrain::Point3 point;
    double slope = 0;              ///< degrees
    std::optional<float> humidity; ///< of the layer at the surface; nothing on bare rock or without layers
    QString material;              ///< likewise
    bool isByKeys = false;         ///< keys moved the cursor: for screen readers
};

/// Nothing beside the terrain.
std::optional<GroundReading> readingAt(const model::terrain::Terrain &terrain, const GroundEvent &event);

} // namespace views
