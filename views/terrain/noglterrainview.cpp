// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/noglterrainview.h"

#include "views/terrain/drapedlines.h"
#include "views/terrain/groundray.h"

#include <QPainter>

#include <algorithm>

namespace views {

using namespace model::terrain;

namespace {

constexpr int Margin = 12;
/// Pixels of the map at most; larger, it would lag behind strokes.
constexpr int LargestSide = 700;
constexpr double DrawMilliseconds = 12;

} // namespace

NoGlTerrainView::NoGlTerrainView(const model::TerrainDocument &document, QWidget *parent)
    : QWidget(parent)
    , mDocument(document)
    , mShade(document.terrain())
    , mDispatcher(*this, [this](QPointF place) { return groundAt(place); })
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAccessibleName(tr("Terrain"));
    setAccessibleDescription(tr("A map of the terrain from above. The 3D view needs OpenGL 3.3. While you sculpt, "
                                "arrow keys move the tool and Space presses and lifts it."));
    mDrawing.setInterval(0);
    connect(&mDrawing, &QTimer::timeout, this, &NoGlTerrainView::drawOn);
    connect(&mDocument, &model::TerrainDocument::changed, this, &NoGlTerrainView::documentChanged);
}

NoGlTerrainView::~NoGlTerrainView()
{
    mDispatcher.setInteraction(nullptr);
}

void NoGlTerrainView::setInteraction(GroundInteraction *interaction)
{
    mDispatcher.setInteraction(interaction);
    updateLines();
}

void NoGlTerrainView::updateLines()
{
    setCursor(mDispatcher.isActive() ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void NoGlTerrainView::documentChanged(const model::TerrainChange &change)
{
    if (const auto *surface = std::get_if<model::SurfaceChanged>(&change))
        mShade.note(*surface->edit);
    else if (std::holds_alternative<model::MaterialsChanged>(change))
        mShade.restart();
    mDrawing.start();
}

void NoGlTerrainView::drawOn()
{
    if (!mShade.draw(DrawMilliseconds))
        mDrawing.stop();
    update();
}

QRect NoGlTerrainView::mapArea() const
{
    const QRect room = rect().adjusted(Margin, Margin, -Margin, -Margin - fontMetrics().height());
    QRect area({}, mShade.image().size().scaled(room.size(), Qt::KeepAspectRatio));
    area.moveCenter(room.center());
    return area;
}

Point2 NoGlTerrainView::mapPoint(QPointF place) const
{
    const QRectF area = mapArea();
    const Rectangle &domain = mDocument.tin().domain();
    return {domain.low.x + (place.x() - area.left()) / std::max(area.width(), 1.0) * (domain.high.x - domain.low.x),
            domain.high.y - (place.y() - area.top()) / std::max(area.height(), 1.0) * (domain.high.y - domain.low.y)};
}

QPointF NoGlTerrainView::placeOf(Point2 point) const
{
    const QRectF area = mapArea();
    const Rectangle &domain = mDocument.tin().domain();
    return {area.left() + (point.x - domain.low.x) / (domain.high.x - domain.low.x) * area.width(),
            area.top() + (domain.high.y - point.y) / (domain.high.y - domain.low.y) * area.height()};
}

std::optional<Point3> NoGlTerrainView::pick(QPointF place) const
{
    const Point2 p = mapPoint(place);
    const Tin &tin = mDocument.tin();
    if (!tin.domain().contains(p) || tin.arrays().isVoid(tin.triangleAt(p)))
        return std::nullopt;
    return Point3{p.x, p.y, tin.heightAt(p)};
}

std::optional<GroundEvent> NoGlTerrainView::groundAt(QPointF place) const
{
    const Point2 p = mapPoint(place);
    const Rectangle &domain = mDocument.tin().domain();
    GroundEvent event;
    event.point = {p.x, p.y, nearestHeight(mDocument.tin(), p)};
    event.isOnTerrain = pick(place).has_value();
    event.metresPerPixel = (domain.high.x - domain.low.x) / std::max(mapArea().width(), 1);
    return event;
}

void NoGlTerrainView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(mapArea(), mShade.image());
    if (const GroundInteraction *interaction = mDispatcher.interaction())
        drawDrapedLines(painter, interaction->lines(), mDocument.tin(), [this](const Point3 &p) {
            return std::optional(placeOf({p.x, p.y}));
        });
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(Margin, 0, -Margin, -4), Qt::AlignHCenter | Qt::AlignBottom,
                     tr("A map from above: the 3D view needs OpenGL 3.3."));
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void NoGlTerrainView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const QSize room = size() - QSize(2 * Margin, 2 * Margin + fontMetrics().height());
    mShade.resize(room.boundedTo({LargestSide, LargestSide}).expandedTo({1, 1}));
    mDrawing.start();
}

bool NoGlTerrainView::event(QEvent *event)
{
    return mDispatcher.handle(*event) || QWidget::event(event);
}

} // namespace views
