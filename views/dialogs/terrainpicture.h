// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/bytes.h"
#include "model/base/progress.h"
#include "model/terrain/terrain.h"

#include <QImage>

namespace views {

/// Of the pictures that `.terrain` files carry.
inline constexpr QSize TerrainThumbnailSize(256, 160);

/// A mesh that looks like the terrain in a small picture, as an animation of one frame, y up: a grid of at most
/// `cells` cells along the longer side. Voids are left out. Null after a cancel.
model::FrameSourcePtr terrainPreview(const model::terrain::Terrain &terrain, int cells,
                                     const model::Progress &progress = model::Progress());

/// Drawn without OpenGL, in any thread. A null image once the work is cancelled.
QImage drawTerrain(const model::terrain::Terrain &terrain, QSize size,
                   const model::Progress &progress = model::Progress());

/// The same as a PNG for a `.terrain` file; empty if it cannot be made.
model::Bytes thumbnailOf(const model::terrain::Terrain &terrain, const model::Progress &progress = model::Progress());

} // namespace views
