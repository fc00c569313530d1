// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <array>

namespace views {

/// The colours of errors, from none to the largest, at equal distances: viridis, whose steps look equally large, also
/// to the colour-blind. Source: N. Smith, S. van der Walt, E. Firing, 2015 (CC0), every 32nd of its 256 colours.
constexpr std::array<QRgb, 9> ErrorColors{0xff440154, 0xff472d7b, 0xff3b528b, 0xff2c728e, 0xff21908c,
                                          0xff27ad81, 0xff5dc863, 0xffaadc32, 0xfffde725};

} // namespace views
