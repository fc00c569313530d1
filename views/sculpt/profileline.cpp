// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/profileline.h"

#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// Pixels from an end within which a press takes hold of it.
constexpr double GrabPixels = 12;
constexpr double EndPixels = 6, MarkPixels = 4, PointerPixels = 8;
constexpr QColor LineColor(0xff, 0xd8, 0x4a), MarkColor(0xff, 0xff, 0xff);

double distanceBetween(Point2 p, Point2 q)
{
    return std::hypot(p.x - q.x, p.y - q.y);
}

GroundLine diamond(Point2 at, double size, QColor color)
{
    GroundLine line;
    line.points = {{at.x + size, at.y}, {at.x, at.y + size}, {at.x - size, at.y}, {at.x, at.y - size}};
    line.isClosed = true;
    line.color = color;
    line.width = 2;
    return line;
}

} // namespace

ProfileLine::ProfileLine(GroundView *view, QObject *parent)
    : QObject(parent)
    , mView(view)
{}

void ProfileLine::setEnds(const std::optional<Ends> &ends)
{
    if (ends == mEnds)
        return;
    mEnds = ends;
    mMark.reset();
    updateLines();
    emit changed();
}

void ProfileLine::setMark(std::optional<double> distance)
{
    mMark = distance;
    updateLines();
}

void ProfileLine::setVisible(bool isVisible)
{
    mIsVisible = isVisible;
    updateLines();
}

ProfileLine::End ProfileLine::endAt(const GroundEvent &event) const
{
    if (!mEnds)
        return End::None;
    const Point2 p{event.point.x, event.point.y};
    const double toA = distanceBetween(p, mEnds->a), toB = distanceBetween(p, mEnds->b);
    if (std::min(toA, toB) > GrabPixels * event.metresPerPixel)
        return End::None;
    return toA < toB ? End::A : End::B;
}

bool ProfileLine::press(const GroundEvent &event)
{
    mBefore = mEnds;
    mDragged = endAt(event);
    if (mDragged == End::None) {
        const Point2 p{event.point.x, event.point.y};
        mDragged = End::B;
        setEnds(Ends{p, p});
    }
    move(event);
    return true;
}

void ProfileLine::move(const GroundEvent &event)
{
    if (mDragged == End::None || !mEnds)
        return;
    mPointer = event;
    mMetresPerPixel = event.metresPerPixel;
    Ends ends = *mEnds;
    (mDragged == End::A ? ends.a : ends.b) = {event.point.x, event.point.y};
    setEnds(ends);
}

void ProfileLine::release(const GroundEvent &event)
{
    move(event);
    mDragged = End::None;
    if (mEnds && mEnds->a == mEnds->b)
        setEnds(mBefore); // a click draws no line
}

void ProfileLine::cancel()
{
    mDragged = End::None;
    setEnds(mBefore);
}

void ProfileLine::hover(const GroundEvent &event)
{
    mPointer = event;
    mMetresPerPixel = event.metresPerPixel;
    updateLines();
}

void ProfileLine::leave()
{
    mPointer.reset();
    updateLines();
}

void ProfileLine::updateLines()
{
    if (mView)
        mView->updateLines();
}

std::vector<GroundLine> ProfileLine::lines() const
{
    std::vector<GroundLine> lines;
    if (mEnds && mIsVisible) {
        GroundLine line;
        line.points = {mEnds->a, mEnds->b};
        line.color = LineColor;
        line.width = 2;
        lines.push_back(line);
        for (const Point2 end : {mEnds->a, mEnds->b})
            lines.push_back(diamond(end, EndPixels * mMetresPerPixel, LineColor));
        const double length = distanceBetween(mEnds->a, mEnds->b);
        if (mMark && length > 0) {
            const double share = *mMark / length;
            lines.push_back(diamond(
                {mEnds->a.x + share * (mEnds->b.x - mEnds->a.x), mEnds->a.y + share * (mEnds->b.y - mEnds->a.y)},
                MarkPixels * mMetresPerPixel, MarkColor));
        }
    }
    if (mPointer && mDragged == End::None) {
        const Point2 p{mPointer->point.x, mPointer->point.y};
        const double size = PointerPixels * mPointer->metresPerPixel;
        GroundLine across, along;
        across.points = {{p.x - size, p.y}, {p.x + size, p.y}};
        along.points = {{p.x, p.y - size}, {p.x, p.y + size}};
        across.color = along.color = LineColor;
        lines.push_back(std::move(across));
        lines.push_back(std::move(along));
    }
    return lines;
}

} // namespace views
