// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundinteraction.h"

#include <functional>

class QEvent;
class QMouseEvent;
class QTabletEvent;

namespace views {

/// Turns the events of a view into calls of a GroundInteraction, and keeps the order that it promises: after press()
/// come moves and then release() or cancel(), once.
class GroundDispatcher final
{
public:
    /// The ground at a place of the view: point, isOnTerrain, metresPerPixel; nothing where the sky is.
    using Find = std::function<std::optional<GroundEvent>(QPointF place)>;

    explicit GroundDispatcher(Find find)
        : mFind(std::move(find))
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
    bool begin(const std::optional<GroundEvent> &ground);
    void end(const std::optional<GroundEvent> &ground);
    void hover(const std::optional<GroundEvent> &ground);
    void leave();

    Find mFind;
    GroundInteraction *mInteraction = nullptr;
    bool mIsStroking = false;
    bool mIsPenStroke = false;
    bool mIsHovering = false;
    bool mIgnoresRight = false; ///< the button that cancelled is still down
    std::optional<GroundEvent> mLast;
};

} // namespace views
