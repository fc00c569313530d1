// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"
#include "views/terrain/groundinteraction.h"

#include <QPainter>

#include <functional>

namespace views {

/// Where a point of the ground is in the picture; nothing if it is behind the camera.
using PlaceOf = std::function<std::optional<QPointF>(const model::terrain::Point3 &)>;

/// Draws lines along the ground: each is divided until it follows it, and is seen through hills.
void drawDrapedLines(QPainter &painter, const std::vector<GroundLine> &lines, const model::terrain::Tin &tin,
                     const PlaceOf &placeOf);

} // namespace views
