// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/fillholes.h"

namespace model {

/// Cuts a mesh open along a loop of edges, as findHandles() gives them, and closes both sides by lids: the handle is
/// gone, and the genus one less.
/// \param loop  vertices in order, each once; the last is joined to the first
/// \error BadLoop, LoopAtBorder, Cancelled
EditResult cutHandle(const Faces &faces, std::span<const Vec3f> positions, std::span<const std::uint32_t> loop,
                     const HoleFilling &filling = {}, const Progress &progress = Progress());

} // namespace model
