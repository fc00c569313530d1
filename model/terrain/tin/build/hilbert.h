// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <span>
#include <vector>

namespace model::terrain {

/// Where a cell of a 2^32 x 2^32 grid lies on the Hilbert curve.
std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y);

/// The indices of `points` along a Hilbert curve over `domain`: neighbours on it are neighbours in the plane. Points in
/// the same cell go by x, then y; those at the same place are neighbours, and keep their order. Precondition: the
/// points lie in the domain.
std::vector<std::uint32_t> hilbertOrder(std::span<const Point3> points, const Rectangle &domain);

} // namespace model::terrain
