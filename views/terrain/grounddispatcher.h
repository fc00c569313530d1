// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundinteraction.h"

#include <functional>

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QTabletEvent;
class QWidget;

namespace views {

/// Turns the events of a view into calls of a GroundInteraction, and keeps the order that it promises: after press()
/// come moves and then release() or cancel(), once.
///
/// Keys draw as well: the arrows move a cursor over the picture (Shift: in larger steps), from where the pointer was or
/// from the middle; Space or Enter presses the tool, and lifts it the next time.
class GroundDispatcher final
{
public:
    /// The ground at a place of the view: point, isOnTerrain, metresPerPixel; nothing where the sky is.
    using Find = std::function<std::optional<GroundEvent>(QPointF place)>;

    GroundDispatcher(const QWidget &view, Find find)
        : mView(view)
        , mFind(std::move(find))
    {}
    ~GroundDispatcher() { cancelStroke(); }
    GroundDispatcher(const GroundDispatcher &) = delete;
    GroundDispatcher &operator=(const GroundDispatcher &) = delete;

    void setInteraction(GroundInteraction *interaction);
    GroundInteraction *interaction() const { return mInteraction; }
    bool isActive() const { return mInteraction && mInteraction->isActive(); }
    bool isStroking() const { return mIsStroking; }
    void cancelStroke();

    /// True if the event is done with; else the camera may have it.
    bool handle(QEvent &event);

private:
    bool handleMouse(const QMouseEvent &event);
    bool handleTablet(const QTabletEvent &event);
    bool takesKey(const QKeyEvent &event) const;
    bool handleKey(const QKeyEvent &event);
    bool begin(const std::optional<GroundEvent> &ground);
    void end(const std::optional<GroundEvent> &ground);
    void hover(const std::optional<GroundEvent> &ground);
    void leave();

    const QWidget &mView;
    Find mFind;
    GroundInteraction *mInteraction = nullptr;
    bool mIsStroking = false;
    bool mIsPenStroke = false;
    bool mIsKeyStroke = false;
    bool mIsHovering = false;
    bool mIgnoresRight = false; ///< the button that cancelled is still down
    std::optional<GroundEvent> mLast;
    std::optional<QPointF> mPlace; ///< of the pointer or of the keys' cursor, whichever moved last
};

} // namespace views
