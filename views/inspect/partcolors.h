// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace views {

/// What marks are drawn in; told apart by the colour-blind as well (after M. Okabe, K. Ito, 2008), on light ground and
/// on dark.
struct MarkColors
{
    QColor hole, handle, tunnel, problem, selected, selectedTunnel, picked;
};
const MarkColors &markColors(const QPalette &palette);

/// Neighbours in the list differ clearly; after twelve they begin again.
QRgb componentColor(std::uint32_t component);

/// What is not selected steps back.
QRgb dimmed(QRgb color, const QPalette &palette);

} // namespace views
