// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/meshreport.h"

namespace model {

/// The faces whose corners are those of an earlier face, whichever way round: that face is the second of each pair.
/// Faces that cannot have one are passed by, by what is across their edges.
std::vector<ProblemIds> findDuplicateFaces(const FaceLinks &links);

} // namespace model
