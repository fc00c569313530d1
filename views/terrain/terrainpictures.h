// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/scene/picturefiles.h"

namespace views {

class TerrainViewport;

/// Draws what a viewport shows from another place and at another size, for work in the background: the GUI thread draws
/// a step at a time. Nothing is drawn once the viewport is gone.
DrawView drawingOf(TerrainViewport &viewport);

} // namespace views
