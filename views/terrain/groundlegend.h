// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "views/terrain/groundcolors.h"
#include "views/viewport/overlay.h"

namespace views {

/// What the colours of an overlay mean, in the user's language and numbers. Precondition: an overlay is chosen.
ColorScale groundScale(const TerrainStyle &style, const GroundRange &range, const model::terrain::Terrain &terrain);

/// Draws it at the right side of `area`.
void drawGroundLegend(QPainter &painter, const QRect &area, const TerrainStyle &style, const GroundRange &range,
                      const model::terrain::Terrain &terrain);

} // namespace views
