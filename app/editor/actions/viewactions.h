// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"
#include "views/viewport/drawmode.h"

#include <QObject>

class QActionGroup;
class QSlider;
class QWidgetAction;
class QMainWindow;

namespace views {
class AnimationViewport;
} // namespace views

namespace editor {

class Workspace;

/// The View menu: how the present tab is drawn. A new tab is drawn as the one before.
class ViewActions final : public QObject
{
    Q_OBJECT

public:
    ViewActions(Actions &actions, Workspace &workspace, Settings &settings, QMainWindow &window);

    /// The slider of the share of points, for toolbars and menus.
    QWidget *makeDensitySlider(QWidget *parent);
    void retranslate();

private:
    void follow();
    void setDrawMode(views::DrawMode mode);
    void setDensity(int percent);
    void toggleFullScreen(bool on);
    views::AnimationViewport *viewport() const;

    Actions &mActions;
    Workspace &mWorkspace;
    Settings &mSettings;
    QMainWindow &mWindow;
    QActionGroup *mModes;
    std::vector<QSlider *> mSliders;
    views::DrawMode mDrawMode;
    int mDensityPercent = 100;
};

} // namespace editor
