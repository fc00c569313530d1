// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "model/terrain/tools/paintmask.h"

#include <functional>
#include <memory>

namespace views {

/// A number for a vertex of the terrain it was made for, mostly in metres.
using GroundScalar = std::function<float(model::terrain::VertexId)>;

/// How thick a layer is; \param layer  below 0: all of them together. 0 for a layer that is not there.
GroundScalar thicknessOf(const model::terrain::Terrain &terrain, int layer);

/// By how much the surface is higher than it was in `reference` (null: the same). Vertices that were there then cost a
/// subtraction, others a search.
GroundScalar heightOver(const model::terrain::Terrain &terrain,
                        std::shared_ptr<const model::terrain::Terrain> reference);

/// How far a place is protected from tools, in per cent; null: not at all.
GroundScalar protectionOf(const model::terrain::Terrain &terrain,
                          std::shared_ptr<const model::terrain::PaintMask> mask);

} // namespace views
