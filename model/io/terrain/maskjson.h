// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/paintmask.h"

#include <QJsonObject>

namespace model::io {

/// A painted mask as an object of JSON, for the state of the tools in a `.terrain` file; FORMAT.md.
QJsonObject jsonOf(const terrain::PaintMask &mask);
/// Its key among TerrainExtras::tools.
inline constexpr QLatin1String MaskKey("mask");
/// \error BadValue       numbers of cells or values that do not fit
/// \error CorruptStream  values that cannot be unpacked
Result<terrain::PaintMask> maskOf(const QJsonObject &json, const terrain::Rectangle &domain);

} // namespace model::io
