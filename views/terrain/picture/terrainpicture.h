// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/terrain/terrainstyle.h"

#include <QSize>

namespace views {

/// A picture of a terrain that is to be drawn.
struct TerrainPicture
{
    model::OrbitCamera camera;
    QSize size; ///< pixels
    TerrainStyle style;
    float pixelRatio = 1; ///< lines keep their width on high-DPI screens
    /// Shadows stay as they are where the ground has changed: they cost more than the ground itself where the processor
    /// draws. The next picture without this brings them up to date.
    bool keepsShadows = false;
    /// A grid stands for the terrain if it is large, and edges are left out: for what moves, where the processor draws.
    bool isCoarse = false;
};

} // namespace views
