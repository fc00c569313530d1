// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/haptics/hapticssession.h"

#include <QObject>

class QAction;
class QMainWindow;
class QPushButton;

namespace views {
class HapticsDock;
}

namespace editor {

/// Haptics in the window: the session with its device, the dock, the actions, and the ways to stop: STOP in the status
/// bar while forces are wanted, Escape wherever the focus is, and closing the dock.
class Feeling final : public QObject
{
    Q_OBJECT

public:
    Feeling(const views::ToolSettings &settings, QMainWindow &window, QObject *parent = nullptr);
    ~Feeling() override;

    views::HapticsSession &session() { return mSession; }
    views::HapticsDock &dock() const { return *mDock; }
    /// While it is checked, the mouse moves the simulated device.
    QAction &modeAction() const { return *mMode; }
    QAction &forcesAction() const { return *mForces; }
    QAction &stopAction() const { return *mStop; }

    /// Another terrain is in front, or none: as HapticsSession::setTerrain().
    void setTerrain(const model::TerrainDocument *document, views::StrokeController *strokes);
    /// Texts of what belongs to no dock and no menu.
    void retranslate();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow();

    views::HapticsSession mSession;
    views::HapticsDock *mDock;
    QAction *mMode, *mForces, *mStop;
    QPushButton *mStopButton; ///< in the status bar
};

} // namespace editor
