// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/handonground.h"

#include "views/haptics/hapticssession.h"

#include <QKeyEvent>

#include <algorithm>

namespace views {

namespace {

/// m of the hand for a notch of the wheel, and for a key.
constexpr double HeightStep = 0.002;
constexpr double LowestHeight = -0.06, HighestHeight = 0.06;

} // namespace

HandOnGround::HandOnGround(HapticsSession &session, QObject *parent)
    : QObject(parent)
    , mSession(session)
{}

void HandOnGround::setHeight(double height)
{
    height = std::clamp(height, LowestHeight, HighestHeight);
    if (height == mHeight)
        return;
    mHeight = height;
    send();
    emit heightChanged();
}

/// The place on the ground is that of the event, not of now: a tool that is held still does not follow the ground that
/// it presses down.
void HandOnGround::send()
{
    if (!mPlace)
        return;
    model::terrain::Point3 place = *mPlace;
    place.z += mHeight * mSession.service().settings().workspace.scale;
    mSession.moveHand(place, mIsPressed);
}

void HandOnGround::hover(const GroundEvent &event)
{
    mPlace = event.point;
    send();
}

bool HandOnGround::press(const GroundEvent &event)
{
    mIsPressed = true;
    hover(event);
    return true;
}

void HandOnGround::move(const GroundEvent &event)
{
    hover(event);
}

void HandOnGround::release(const GroundEvent &event)
{
    mIsPressed = false;
    hover(event);
}

void HandOnGround::cancel()
{
    mIsPressed = false;
    send();
    mSession.cancelStroke();
}

bool HandOnGround::wheel(const GroundEvent &event, double notches)
{
    if (event.modifiers & Qt::ControlModifier)
        return false;
    setHeight(mHeight + notches * HeightStep);
    return true;
}

bool HandOnGround::keyPress(const QKeyEvent &event)
{
    if (event.modifiers() || (event.key() != Qt::Key_PageUp && event.key() != Qt::Key_PageDown))
        return false;
    if (event.type() != QEvent::ShortcutOverride)
        setHeight(mHeight + (event.key() == Qt::Key_PageUp ? HeightStep : -HeightStep));
    return true;
}

} // namespace views
