// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/outline.h"

namespace model::terrain {

/// An outline from the path data of SVG ("M 0 0 L 10 0 C ... Z"): the commands M, L, H, V, C, Q and Z, and the relative
/// ones in small letters, in one closed subpath. Curves become chords that stay within `tolerance` of them, in units of
/// the outline. The middle of its box becomes the origin, the farthest corner gets distance 1, and y points north,
/// where that of SVG points down.
/// \error SyntaxError  args: what was expected, what was found
/// \error BadSetting   as Outline::polygon()
Result<Outline> outlineFromSvgPath(std::string_view data, double tolerance = 0.01);

} // namespace model::terrain
