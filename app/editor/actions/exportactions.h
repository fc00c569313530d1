// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"

#include <QObject>

namespace editor {

class AnimationTab;
class DocumentTab;
class TerrainTab;
class Settings;
class Workspace;

/// The Export menu: opens the dialogs with proposals that fit the present tab.
class ExportActions final : public QObject
{
    Q_OBJECT

public:
    ExportActions(Actions &actions, Workspace &workspace, const Settings &settings, QWidget &window);

private:
    void update();
    void exportFrames(AnimationTab &tab);
    void exportPointCache(AnimationTab &tab);
    void exportScreenshot(AnimationTab &tab);
    void exportPictures(AnimationTab &tab);
    void exportTerrain(TerrainTab &tab);
    void exportTerrainScreenshot(TerrainTab &tab);
    void exportTurntable(TerrainTab &tab);
    /// Beside the document's file, named after it, with `suffix` appended.
    QString proposal(const DocumentTab &tab, const QString &suffix) const;

    Actions &mActions;
    Workspace &mWorkspace;
    const Settings &mSettings;
    QWidget &mWindow;
};

} // namespace editor
