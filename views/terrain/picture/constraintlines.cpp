// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/constraintlines.h"

#include <QColor>

#include <cmath>

namespace views {

using namespace model::terrain;

QRgb ownerColor(OwnerId owner)
{
    constexpr double GoldenRatio = 0.6180339887498949;
    const double turn = double(owner) * GoldenRatio;
    return QColor::fromHsvF(float(turn - std::floor(turn)), 0.85f, 0.95f).rgb();
}

ConstraintLines constraintLines(const TinArrays &tin, bool isByOwner)
{
    ConstraintLines lines;
    lines.vertices.reserve(2 * std::size_t(tin.totals.records));
    lines.colors.reserve(tin.totals.records);
    for (const ConstraintRecord &record : tin.records.values()) {
        if (record.a == None)
            continue;
        const QRgb color = isByOwner ? ownerColor(record.owner) : ConstraintColor;
        lines.vertices.insert(lines.vertices.end(), {record.a, record.b});
        lines.colors.push_back(0xff000000u | std::uint32_t(qBlue(color)) << 16 | std::uint32_t(qGreen(color)) << 8 |
                               std::uint32_t(qRed(color)));
    }
    return lines;
}

} // namespace views
