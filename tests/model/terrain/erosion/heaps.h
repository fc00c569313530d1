// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/erosion/erosion.h"

namespace tests {

/// The column of the benchmarks: a cylinder of radius 0.1 and height 0.5 in the middle of a flat unit square, of as
/// many random vertices.
model::terrain::Tin column(std::size_t vertices, unsigned seed = 1);

/// The same with the whole column as the top one of `layers` layers, all of material 0, on a flat bedrock.
model::terrain::Tin layeredColumn(std::size_t vertices, std::uint32_t layers, float humidity = 0);

/// Degrees.
double steepestFace(const model::terrain::Tin &tin);
double steepestEdge(const model::terrain::Tin &tin);

/// All bytes that a change could change.
std::string bytesOf(const model::terrain::Tin &tin);

/// Settles, commits, and gives the edit. Fails the program on an error.
model::terrain::Edit settle(model::terrain::Tin &tin, model::terrain::Erosion &erosion,
                            model::terrain::ErosionStatistics *statistics = nullptr);

} // namespace tests
