// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/editsurface.h"

namespace commands {

// What is done to the layers of a terrain: the work for EditSurface, or for a copy of the terrain in a worker, as each
// visits every vertex.

/// Inserts a layer below the one that is `layer` now, or on top, `sample` everywhere. The surface stays: the bedrock
/// gives way. Preconditions: as TinEdit::addLayer() and setLayer().
EditSurface::Work addLayer(std::uint32_t layer, std::uint8_t material, model::terrain::LayerSample sample);
/// What the layer held becomes bedrock.
EditSurface::Work removeLayer(std::uint32_t layer);
/// Makes a layer `sample` everywhere.
EditSurface::Work fillLayer(std::uint32_t layer, model::terrain::LayerSample sample);
/// Makes a layer of another material. Cost: none.
EditSurface::Work setLayerMaterial(std::uint32_t layer, std::uint8_t material);

} // namespace commands
