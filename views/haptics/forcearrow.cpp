// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/forcearrow.h"

#include "views/dialogs/quantitytext.h"
#include "views/haptics/hapticssession.h"
#include "views/terrain/terrainviewport.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// m of the hand for a newton.
constexpr double MetresPerNewton = 0.02;
/// N: weaker ones have no arrow.
constexpr double LeastForce = 0.02;
constexpr double ToolPixels = 5, HeadPixels = 11;
/// Pixels: what moves by less is not drawn again.
constexpr double LeastPixels = 0.5;
/// Between two drawings: the picture of the window is put together anew for each.
constexpr int ShowMilliseconds = 30;
constexpr QColor ForceColor(0xff, 0x6a, 0x2b), ToolColor(0xff, 0xff, 0xff), EdgeColor(0, 0, 0, 170);

bool isFar(QPointF a, QPointF b)
{
    return (a - b).manhattanLength() > LeastPixels;
}

bool isSame(const ForceArrow::Shape &a, const ForceArrow::Shape &b)
{
    return !isFar(a.tool, b.tool) && !isFar(a.ground, b.ground) && a.tip.has_value() == b.tip.has_value() &&
           !(a.tip && isFar(*a.tip, *b.tip)) && std::abs(a.newtons - b.newtons) < 0.05 && a.isDeep == b.isDeep;
}

QPainterPath arrow(QPointF from, QPointF to)
{
    QPainterPath path(from);
    path.lineTo(to);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1)
        return path;
    const QPointF along = way * (std::min(HeadPixels, length) / length), across(along.y() * 0.45, -along.x() * 0.45);
    path.moveTo(to - along + across);
    path.lineTo(to);
    path.lineTo(to - along - across);
    return path;
}

/// Light on dark ground and on bright ground alike.
void stroke(QPainter &painter, const QPainterPath &path, QColor color, double width)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(EdgeColor, width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

} // namespace

ForceArrow::ForceArrow(HapticsSession &session, TerrainViewport &viewport)
    : QWidget(&viewport)
    , mSession(session)
    , mViewport(viewport)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(viewport.rect());
    hide();
    viewport.installEventFilter(this);
    connect(&session, &HapticsSession::stepped, this, &ForceArrow::follow);
    connect(&session, &HapticsSession::chosenChanged, this, &ForceArrow::follow);
    connect(&viewport, &SceneViewport::cameraChanged, this, &ForceArrow::follow);
}

void ForceArrow::setActive(bool isActive)
{
    mIsActive = isActive;
    follow();
}

std::optional<ForceArrow::Shape> ForceArrow::shape() const
{
    const auto &now = mSession.now();
    if (!mIsActive || !mSession.service().isOpen() || !mSession.hasTerrain() || !now.reading.isConnected)
        return std::nullopt;
    const double scale = mSession.service().settings().workspace.scale;
    const Point3 tool = mSession.toolPlace();
    const auto seen = mViewport.placeOf(tool);
    const auto ground = mViewport.placeOf({tool.x, tool.y, tool.z + now.depth * scale});
    if (!seen || !ground)
        return std::nullopt;
    Shape shape{*seen, *ground, {}, std::sqrt(dot(now.force, now.force)), now.depth > 0};
    if (shape.newtons > LeastForce) {
        const double metres = MetresPerNewton * scale;
        shape.tip = mViewport.placeOf(
            {tool.x + metres * now.force.x, tool.y + metres * now.force.y, tool.z + metres * now.force.z});
    }
    return shape;
}

void ForceArrow::follow()
{
    const bool isShowing = mShown && mIsActive && mSession.service().isOpen();
    if (isShowing && mSinceShown.isValid() && mSinceShown.elapsed() < ShowMilliseconds)
        return; // the next step comes soon
    std::optional<Shape> next = shape();
    if (next && mShown && isSame(*next, *mShown))
        return;
    mSinceShown.restart();
    if (next || mShown)
        update();
    mShown = std::move(next);
    setVisible(mShown.has_value());
}

bool ForceArrow::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &mViewport && event->type() == QEvent::Resize)
        setGeometry(mViewport.rect());
    return QWidget::eventFilter(watched, event);
}

void ForceArrow::paintEvent(QPaintEvent *)
{
    if (!mShown)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath stem(mShown->ground);
    stem.lineTo(mShown->tool);
    stroke(painter, stem, ToolColor, 1.5);
    QPainterPath foot;
    foot.addEllipse(mShown->ground, ToolPixels * 1.4, ToolPixels * 0.7);
    stroke(painter, foot, ToolColor, 1);
    QPainterPath tool;
    tool.addEllipse(mShown->tool, ToolPixels, ToolPixels);
    stroke(painter, tool, mShown->isDeep ? ForceColor : ToolColor, 2);
    if (!mShown->tip)
        return;
    stroke(painter, arrow(mShown->tool, *mShown->tip), ForceColor, 3);
    QPainterPath text;
    text.addText(*mShown->tip + QPointF(10, -4), font(), tr("%1 N").arg(numberText(mShown->newtons, 1)));
    painter.setPen(QPen(EdgeColor, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(text);
    painter.fillPath(text, ToolColor);
}

} // namespace views
