// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/meshreport.h"

namespace model {

/// The vertices that are exactly where an earlier vertex is: the first one there is the second of each pair. +0 and -0
/// are the same place.
std::vector<ProblemIds> findCoincidentVertices(std::span<const Vec3f> positions);

} // namespace model
