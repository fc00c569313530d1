// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <QElapsedTimer>
#include <QWidget>

#include <optional>

namespace views {

class HapticsSession;
class TerrainViewport;

/// The tool of a haptic device over the picture of the terrain: where it is, how far above or below the ground, and the
/// force on the hand as an arrow. Takes no events.
class ForceArrow final : public QWidget
{
    Q_OBJECT

public:
    ForceArrow(HapticsSession &session, TerrainViewport &viewport);

    /// Off: nothing is drawn.
    void setActive(bool isActive);

    /// In the viewport's pixels.
    struct Shape
    {
        QPointF tool, ground;
        std::optional<QPointF> tip; ///< of the arrow; nothing without a force that can be seen
        double newtons = 0;
        bool isDeep = false; ///< the tool is below the ground
    };
    /// As it is now; nothing without a device, or behind the camera.
    std::optional<Shape> shape() const;

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();

    HapticsSession &mSession;
    TerrainViewport &mViewport;
    bool mIsActive = false;
    QElapsedTimer mSinceShown;
    std::optional<Shape> mShown;
};

} // namespace views
