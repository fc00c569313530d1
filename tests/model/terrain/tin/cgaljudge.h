// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"

#include <string>

namespace tests {

/// Builds CGAL's Constrained_Delaunay_triangulation_2 of the vertices and constraints of `tin`, from nothing, and
/// compares edge for edge. Empty if both have the same edges, constrained or not; otherwise what differs first.
///
/// From nothing, because CGAL 5.5 may fill the hole of a removed vertex wrongly where a constrained edge hides one
/// vertex of the hole from another.
std::string differenceFromCgal(const model::terrain::Tin &tin);

} // namespace tests
