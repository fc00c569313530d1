// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/terrainstyle.h"

#include <QRgb>

#include <array>
#include <vector>

namespace views {

/// Colours of a map from its first to its last value, at equal distances, sRGB.
using GroundColors = std::array<QRgb, 9>;

/// Viridis, from dark to bright in steps that look equal. Source: S. van der Walt, N. Smith, 2015 (CC0).
inline constexpr GroundColors SequentialColors{0xff440154, 0xff472d7b, 0xff3b528b, 0xff2c728e, 0xff21918c,
                                               0xff28ae80, 0xff5ec962, 0xffaddc30, 0xfffde725};
/// Red for what is gone, blue for what was added, pale in the middle. Source: C. Brewer, ColorBrewer RdBu.
inline constexpr GroundColors DivergingColors{0xffb2182b, 0xffd6604d, 0xfff4a582, 0xfffddbc7, 0xfff7f7f7,
                                              0xffd1e5f0, 0xff92c5de, 0xff4393c3, 0xff2166ac};

inline const GroundColors &colorsOf(GroundOverlay overlay)
{
    return overlay == GroundOverlay::CutAndFill ? DivergingColors : SequentialColors;
}

/// The values with the first and the last colour.
struct GroundRange
{
    double low = 0, high = 1;
};

/// The colour of a value, as the ground has it where it is level.
QRgb colorAt(const GroundColors &colors, const GroundRange &range, double value);

/// 1, 2 or 5 times a power of ten, at least `length`; 1 if that is not above 0.
double roundUp(double length);

} // namespace views
