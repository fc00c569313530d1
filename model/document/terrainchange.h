// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/journal.h"

#include <variant>

namespace model {

/// Vertices, triangles, heights, layers or constraints: which, the edit says. It is done or undone, and the document is
/// on its new side. Valid while the notice is sent.
struct SurfaceChanged
{
    const terrain::Edit *edit;
};
/// The list of materials: names or numbers of them.
struct MaterialsChanged
{};
struct GeoReferenceChanged
{};

/// What changed in a TerrainDocument; sent after the change. Views std::visit it, so that a new kind breaks the build
/// of every view that forgot it.
using TerrainChange = std::variant<SurfaceChanged, MaterialsChanged, GeoReferenceChanged>;

} // namespace model
