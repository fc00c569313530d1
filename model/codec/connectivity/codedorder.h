// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <vector>

namespace model::codec {

/// Finds again in which order a codec that does not keep it has put the vertices of a mesh, so that the two can be
/// compared vertex by vertex without anybody having kept a permutation.
/// \returns  for each vertex of `coded` the vertex of `input`, if coding `input` makes exactly `coded`; empty if it
/// does
///           not, or if the two are the same as they are
/// \error Cancelled
Result<std::vector<std::uint32_t>> codedOrder(const Connectivity &input, const Connectivity &coded,
                                              const Progress &progress = Progress());

} // namespace model::codec
