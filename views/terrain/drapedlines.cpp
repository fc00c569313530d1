// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/drapedlines.h"

#include "views/terrain/groundray.h"

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// Pixels between two points on the ground, and no more pieces than this for one segment.
constexpr double PieceLength = 5;
constexpr int MostPieces = 200;

int piecesBetween(const std::optional<QPointF> &a, const std::optional<QPointF> &b)
{
    if (!a || !b)
        return MostPieces;
    return std::clamp(int(std::ceil(std::hypot(b->x() - a->x(), b->y() - a->y()) / PieceLength)), 1, MostPieces);
}

/// The parts of a line that are before the camera.
std::vector<QPolygonF> drape(const GroundLine &line, const Tin &tin, const PlaceOf &placeOf)
{
    const auto place = [&](Point2 p) { return placeOf({p.x, p.y, nearestHeight(tin, p)}); };
    std::vector<QPolygonF> parts(1);
    const auto add = [&parts](const std::optional<QPointF> &p) {
        if (p)
            parts.back().push_back(*p);
        else if (!parts.back().isEmpty())
            parts.emplace_back();
    };
    const std::size_t count = line.points.size();
    std::optional<QPointF> last = place(line.points[0]);
    add(last);
    for (std::size_t i = 1; i < count + (line.isClosed ? 1 : 0); ++i) {
        const Point2 a = line.points[i - 1], b = line.points[i % count];
        const std::optional<QPointF> end = place(b);
        const int pieces = piecesBetween(last, end);
        for (int k = 1; k < pieces; ++k) {
            const double t = double(k) / pieces;
            add(place({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
        }
        add(end);
        last = end;
    }
    return parts;
}

} // namespace

void drawDrapedLines(QPainter &painter, const std::vector<GroundLine> &lines, const Tin &tin, const PlaceOf &placeOf)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const GroundLine &line : lines) {
        if (line.points.empty())
            continue;
        for (const QPolygonF &part : drape(line, tin, placeOf)) {
            // A dark rim: bright lines stay visible on bright sand.
            painter.setPen(QPen(QColor(0, 0, 0, line.color.alpha() / 2), line.width + 2, Qt::SolidLine, Qt::RoundCap,
                                Qt::RoundJoin));
            painter.drawPolyline(part);
            painter.setPen(QPen(line.color, line.width, line.isDashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap,
                                Qt::RoundJoin));
            painter.drawPolyline(part);
        }
    }
    painter.restore();
}

} // namespace views
