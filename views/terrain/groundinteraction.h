// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <QColor>
#include <QPointF>
#include <Qt>

#include <optional>
#include <vector>

class QKeyEvent;

namespace views {

/// What a mouse or pen did, seen from the ground.
struct GroundEvent
{
    /// Where on the ground, in the terrain's local metres. Past the terrain's edge it lies on the plane at the height
    /// of the nearest place of the border.
    model::terrain::Point3 point;
    bool isOnTerrain = true;
    double metresPerPixel = 1; ///< at `point`, across the line of sight
    QPointF position;          ///< in the view, in its logical pixels
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    bool isByKeys = false; ///< the arrow keys moved here, or Space pressed
    bool isPen = false;
    bool isEraser = false;  ///< the pen's other end
    double pressure = 1;    ///< 0 ... 1; 1 for a mouse
    double xTilt = 0;       ///< degrees from the vertical, to the right; 0 for a mouse
    double yTilt = 0;       ///< towards the user
    std::uint64_t time = 0; ///< milliseconds, of the event
};

/// A line that is draped on the ground: an outline of a tool, a path, a symmetry axis.
struct GroundLine
{
    std::vector<model::terrain::Point2> points; ///< local metres
    bool isClosed = false;
    QColor color = Qt::white;
    float width = 1.5f; ///< logical pixels
    bool isDashed = false;
};

/// Who takes what happens on the ground: a tool. All calls come in the GUI thread. Nothing is asked for a place where
/// the pointer shows no ground (the sky).
class GroundInteraction
{
public:
    virtual ~GroundInteraction() = default;

    /// True while the left button and the pen belong to this, not to the camera. The right button then orbits.
    virtual bool isActive() const = 0;

    /// A stroke begins: the left button, the pen's tip or Space. True if it is taken; then it gets the moves up to
    /// release() or cancel(), else the camera does.
    virtual bool press(const GroundEvent &event) = 0;
    virtual void move(const GroundEvent &event) = 0;
    virtual void release(const GroundEvent &event) = 0;
    /// The stroke was called off: right click or Escape meanwhile, the focus went to another window, or the view goes.
    virtual void cancel() = 0;

    /// The pointer moves without a button down.
    virtual void hover(const GroundEvent &) {}
    /// The pointer has left the ground or the view.
    virtual void leave() {}
    /// True if it is taken; else the view zooms. \param notches  of the wheel, positive away from the user
    virtual bool wheel(const GroundEvent &, double /*notches*/) { return false; }
    /// True if the key is taken; asked before the camera. \param event  also of kind ShortcutOverride: true then says
    /// that the key is wanted here rather than by a shortcut of the window, and nothing is to be done yet
    virtual bool keyPress(const QKeyEvent &) { return false; }
    virtual bool keyRelease(const QKeyEvent &) { return false; }

    /// What to draw on the ground now. Asked at each repaint: after a change call GroundView::updateLines().
    virtual std::vector<GroundLine> lines() const { return {}; }
};

/// A view of a terrain, whoever draws it: that with OpenGL and that without.
class GroundView
{
public:
    virtual ~GroundView() = default;

    /// Null: every button is the camera's. Not owned; has to outlive the view or be taken away before. A stroke in
    /// progress is cancelled.
    virtual void setInteraction(GroundInteraction *interaction) = 0;
    /// What the terrain shows at a place of the view, in logical pixels; nothing beside the terrain, or over a void.
    virtual std::optional<model::terrain::Point3> pick(QPointF place) const = 0;
    /// The interaction's lines have changed.
    virtual void updateLines() = 0;
};

} // namespace views
