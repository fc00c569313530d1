// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/viewactions.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/inspect/meshview.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/animationviewport.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QSlider>

namespace editor {

namespace {

const std::pair<ActionId, views::DrawMode> Modes[] = {
    {ActionId::Shaded, views::DrawMode::Shaded},
    {ActionId::ShadedWireframe, views::DrawMode::ShadedWireframe},
    {ActionId::Wireframe, views::DrawMode::Wireframe},
    {ActionId::Points, views::DrawMode::Points},
};

} // namespace

ViewActions::ViewActions(Actions &actions, Workspace &workspace, Settings &settings, QMainWindow &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mSettings(settings)
    , mWindow(window)
    , mModes(new QActionGroup(this))
    , mDrawMode(views::DrawMode::Shaded)
{
    for (const auto &[id, mode] : Modes) {
        mModes->addAction(&actions[id]);
        connect(&actions[id], &QAction::triggered, this, [this, mode = mode] { setDrawMode(mode); });
    }
    actions[ActionId::Shaded].setChecked(true);
    actions[ActionId::Statistics].setChecked(settings.statisticsVisible());
    connect(&actions[ActionId::Statistics], &QAction::toggled, this, [this](bool on) {
        mSettings.setStatisticsVisible(on);
        follow();
    });
    connect(&actions[ActionId::Fit], &QAction::triggered, this, [this] {
        if (auto *view = viewport())
            view->fitView();
        else if (TerrainTab *tab = mWorkspace.currentTerrain(); tab && tab->viewport())
            tab->viewport()->fitView();
        else if (MeshTab *mesh = mWorkspace.currentMesh(); mesh && mesh->view())
            mesh->view()->fitView();
    });
    connect(&actions[ActionId::FullScreen], &QAction::toggled, this, &ViewActions::toggleFullScreen);
    connect(&actions[ActionId::NextTab], &QAction::triggered, this, [this] { mWorkspace.showNeighbour(1); });
    connect(&actions[ActionId::PreviousTab], &QAction::triggered, this, [this] { mWorkspace.showNeighbour(-1); });
    connect(&workspace, &Workspace::currentChanged, this, &ViewActions::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &ViewActions::follow);
    follow();
}

QWidget *ViewActions::makeDensitySlider(QWidget *parent)
{
    auto *slider = new QSlider(Qt::Horizontal, parent);
    slider->setRange(1, 100);
    slider->setValue(mDensityPercent);
    slider->setFixedWidth(110);
    slider->setObjectName(QStringLiteral("pointDensity"));
    connect(slider, &QSlider::valueChanged, this, &ViewActions::setDensity);
    mSliders.push_back(slider);
    follow();
    return slider;
}

void ViewActions::retranslate()
{
    for (QSlider *slider : mSliders) {
        slider->setAccessibleName(tr("Density of the points"));
        slider->setToolTip(tr("Share of the vertices that are drawn as points"));
    }
}

void ViewActions::follow()
{
    views::AnimationViewport *view = viewport();
    for (const auto &[id, mode] : Modes)
        mActions[id].setEnabled(view != nullptr);
    const TerrainTab *terrain = mWorkspace.currentTerrain();
    MeshTab *mesh = mWorkspace.currentMesh();
    mActions[ActionId::Fit].setEnabled(view || (terrain && terrain->viewport()) || (mesh && mesh->view()));
    for (QSlider *slider : mSliders) {
        const QSignalBlocker blocker(slider);
        slider->setEnabled(view && mDrawMode == views::DrawMode::Points);
        slider->setValue(mDensityPercent);
    }
    if (!view)
        return;
    view->setDrawMode(mDrawMode);
    view->setPointDensity(mDensityPercent / 100.0);
    view->setStatisticsVisible(mActions[ActionId::Statistics].isChecked());
}

void ViewActions::setDrawMode(views::DrawMode mode)
{
    mDrawMode = mode;
    follow();
}

void ViewActions::setDensity(int percent)
{
    mDensityPercent = percent;
    follow();
}

void ViewActions::toggleFullScreen(bool on)
{
    if (on)
        mWindow.setWindowState(mWindow.windowState() | Qt::WindowFullScreen);
    else
        mWindow.setWindowState(mWindow.windowState() & ~Qt::WindowFullScreen);
}

views::AnimationViewport *ViewActions::viewport() const
{
    const AnimationTab *tab = mWorkspace.currentAnimation();
    return tab ? tab->viewport() : nullptr;
}

} // namespace editor
