// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/terrain/simplify/heightgrid.h"
#include "model/terrain/tin/tin.h"

namespace model::terrain {

struct SimplifySettings
{
    double maxError = 0; ///< metres, vertical; at least 0
    /// Heights of vertices are rounded to multiples of this, a power of two, which files hold in few bytes; 0: never.
    /// What rounding costs is part of the error.
    double heightQuantum = 0;
};

/// The height quantum that suits an error: the largest power of two of at most an eighth of it, and a thousandth of a
/// unit at most; 0 for an error of 0.
double heightQuantumFor(double maxError);

/// A TIN through nodes of `grid`, from which no node of a ground square differs by more than `maxError` in height.
/// Squares with a void corner are void: their border is exactly that of the grid's squares.
/// \error BadValue       a grid of one row or column; NonFinite: an infinite height (its node in the error)
/// \error NoSurface      no square is ground
/// \error Cancelled
/// Cost: O((m + n) log m) expected for m vertices of n nodes.
/// Source: M. Garland, P. S. Heckbert, Fast Polygonal Approximation of Terrains and Height Fields, 1995, algorithm III.
/// Differs: constrained; voids.
Result<Tin> simplifyGrid(const HeightGrid &grid, const SimplifySettings &settings,
                         const Progress &progress = Progress());

} // namespace model::terrain
