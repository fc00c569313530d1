// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"
#include "views/inspect/meshfields.h"
#include "views/scene/framedata.h"

#include <memory>

namespace editor {

/// The numbers that the shape alone gives: curvature and valence.
std::vector<views::FieldOffer> meshFields(const std::shared_ptr<const model::PolygonMesh> &mesh);

/// The numbers that an animation has at its vertices: the way of each, what the strongest trajectories of its basis do,
/// and, with an original, how far one frame is from it.
std::vector<views::FieldOffer> frameFields(const model::FrameSourcePtr &frames, const views::OriginalPtr &original,
                                           std::uint32_t frame);

} // namespace editor
