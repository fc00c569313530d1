// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/exportactions.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/start/settings.h"
#include "app/editor/window/workspace.h"
#include "views/dialogs/exportframesdialog.h"
#include "views/dialogs/exportpicturesdialog.h"
#include "views/dialogs/exportpointcachedialog.h"
#include "views/dialogs/exportterraindialog.h"
#include "views/dialogs/screenshotdialog.h"
#include "views/dialogs/turntabledialog.h"
#include "views/terrain/terrainpictures.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/animationviewport.h"

#include <QDir>
#include <QFileInfo>

namespace editor {

namespace {

void present(QDialog *dialog)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

/// Pictures follow one another as they are played.
views::ExportPicturesDialog::Order orderOf(const model::Playback &playback)
{
    using Order = views::ExportPicturesDialog::Order;
    if (playback.loopMode() == model::LoopMode::PingPong)
        return Order::ThereAndBack;
    return playback.isReversed() ? Order::Backward : Order::Forward;
}

} // namespace

ExportActions::ExportActions(Actions &actions, Workspace &workspace, const Settings &settings, QWidget &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mSettings(settings)
    , mWindow(window)
{
    const auto onTab = [this](ActionId id, auto function) {
        connect(&mActions[id], &QAction::triggered, this, [this, function] {
            if (AnimationTab *tab = mWorkspace.currentAnimation())
                (this->*function)(*tab);
        });
    };
    onTab(ActionId::ExportFrames, &ExportActions::exportFrames);
    onTab(ActionId::ExportPointCache, &ExportActions::exportPointCache);
    onTab(ActionId::ExportScreenshot, &ExportActions::exportScreenshot);
    onTab(ActionId::ExportPictures, &ExportActions::exportPictures);
    connect(&mActions[ActionId::ExportTerrain], &QAction::triggered, this, [this] {
        if (TerrainTab *tab = mWorkspace.currentTerrain())
            exportTerrain(*tab);
    });
    const auto onDrawnTerrain = [this](ActionId id, auto function) {
        connect(&mActions[id], &QAction::triggered, this, [this, function] {
            if (TerrainTab *tab = mWorkspace.currentTerrain(); tab && tab->viewport())
                (this->*function)(*tab);
        });
    };
    onDrawnTerrain(ActionId::TerrainScreenshot, &ExportActions::exportTerrainScreenshot);
    onDrawnTerrain(ActionId::Turntable, &ExportActions::exportTurntable);
    connect(&workspace, &Workspace::currentChanged, this, &ExportActions::update);
    connect(&workspace, &Workspace::currentStateChanged, this, &ExportActions::update);
    update();
}

void ExportActions::update()
{
    const AnimationTab *tab = mWorkspace.currentAnimation();
    const bool open = tab && tab->document().isOpen();
    const bool drawn = open && tab->viewport();
    mActions[ActionId::ExportFrames].setEnabled(open);
    mActions[ActionId::ExportPointCache].setEnabled(open);
    mActions[ActionId::ExportScreenshot].setEnabled(drawn);
    mActions[ActionId::ExportPictures].setEnabled(drawn);
    const TerrainTab *terrain = mWorkspace.currentTerrain();
    const bool isOpen = terrain && terrain->document().isOpen();
    mActions[ActionId::ExportTerrain].setEnabled(isOpen);
    mActions[ActionId::TerrainScreenshot].setEnabled(isOpen && terrain->viewport());
    mActions[ActionId::Turntable].setEnabled(isOpen && terrain->viewport());
}

void ExportActions::exportFrames(AnimationTab &tab)
{
    views::Player &player = tab.document().player();
    present(new views::ExportFramesDialog(player.source(), proposal(tab, QStringLiteral("_frames")),
                                          player.playback().rangeFirst(), player.playback().rangeLast(), &mWindow));
}

void ExportActions::exportPointCache(AnimationTab &tab)
{
    views::Player &player = tab.document().player();
    present(new views::ExportPointCacheDialog(player.source(), proposal(tab, QStringLiteral(".pc2")),
                                              player.playback().rangeFirst(), player.playback().rangeLast(), &mWindow));
}

void ExportActions::exportScreenshot(AnimationTab &tab)
{
    const views::FrameDataPtr frame = tab.document().player().currentFrame();
    if (frame)
        present(new views::ScreenshotDialog(*tab.viewport(), frame, proposal(tab, QStringLiteral(".png")), &mWindow));
}

void ExportActions::exportPictures(AnimationTab &tab)
{
    views::Player &player = tab.document().player();
    const model::Playback &playback = player.playback();
    auto *dialog =
        new views::ExportPicturesDialog(*tab.viewport(), player.source(), proposal(tab, QStringLiteral("_pictures")),
                                        playback.rangeFirst(), playback.rangeLast(), &mWindow);
    dialog->setOrder(orderOf(playback));
    present(dialog);
}

void ExportActions::exportTerrain(TerrainTab &tab)
{
    // The dialog comes a moment later, when there is a snapshot for it.
    tab.document().takeSnapshot([this, step = tab.document().extras().step, path = proposal(tab, QString())](
                                    std::shared_ptr<const model::terrain::Terrain> terrain) {
        present(new views::ExportTerrainDialog(std::move(terrain), step, path, &mWindow));
    });
}

void ExportActions::exportTerrainScreenshot(TerrainTab &tab)
{
    present(new views::ScreenshotDialog(*tab.viewport(), views::drawingOf(*tab.viewport()),
                                        proposal(tab, QStringLiteral(".png")), &mWindow));
}

void ExportActions::exportTurntable(TerrainTab &tab)
{
    present(new views::TurntableDialog(*tab.viewport(), views::drawingOf(*tab.viewport()),
                                       proposal(tab, QStringLiteral("_turntable")), &mWindow));
}

QString ExportActions::proposal(const DocumentTab &tab, const QString &suffix) const
{
    const QString path = tab.document().path();
    const QDir folder(path.isEmpty() ? mSettings.lastFolder() : QFileInfo(path).absolutePath());
    return folder.filePath(tab.document().title() + suffix);
}

} // namespace editor
