// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"

#include <QObject>

#include <vector>

class QActionGroup;
class QMainWindow;
class QMenu;

namespace editor {

class Language;

/// The menu bar and what is in it. Sub-menus that change (recent files, samples) are filled when they open.
class Menus final : public QObject
{
    Q_OBJECT

public:
    Menus(QMainWindow &window, Actions &actions, Settings &settings, Language &language);

    /// Where the actions of the timeline go.
    QMenu &playMenu() { return *mPlay; }
    /// How terrains are drawn.
    QMenu &groundMenu() { return *mGround; }
    /// What is done to terrains, and its sub-menus.
    QMenu &terrainMenu() { return *mTerrain; }
    QMenu &toolMenu() { return *mTool; }
    QMenu &symmetryMenu() { return *mSymmetry; }
    /// What is done to meshes.
    QMenu &meshMenu() { return *mMesh; }
    /// Where docks and toolbars can be shown and hidden; call when all of them are there.
    void addPanelActions(const QList<QAction *> &docks, const QList<QAction *> &toolBars);
    void retranslate();

signals:
    void openRequested(const QString &path);
    void recentFilesCleared();

private:
    QMenu *addMenu(QMenu *parent, const char *title, const QString &iconName = {});
    void fillFile();
    void fillEdit();
    void fillView();
    void fillTerrain();
    void fillSettings();
    void fillHelp();
    void showRecentFiles();
    void showSamples();

    struct Titled
    {
        QMenu *menu;
        const char *title;
    };

    QMainWindow &mWindow;
    Actions &mActions;
    Settings &mSettings;
    Language &mLanguage;
    std::vector<Titled> mTitled;
    QMenu *mPlay = nullptr;
    QMenu *mGround = nullptr;
    QMenu *mTerrain = nullptr;
    QMenu *mTool = nullptr;
    QMenu *mSymmetry = nullptr;
    QMenu *mMesh = nullptr;
    QMenu *mRecent = nullptr;
    QMenu *mSamples = nullptr;
    QMenu *mDocks = nullptr;
    QMenu *mToolBars = nullptr;
    std::vector<std::pair<QAction *, const char *>> mTexts;
};

} // namespace editor
