// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/actions/compareactions.h"
#include "app/editor/actions/editactions.h"
#include "app/editor/actions/exportactions.h"
#include "app/editor/actions/fileactions.h"
#include "app/editor/actions/helpactions.h"
#include "app/editor/actions/menus.h"
#include "app/editor/actions/recordactions.h"
#include "app/editor/actions/viewactions.h"
#include "app/editor/inspect/inspector.h"
#include "app/editor/inspect/meshactions.h"
#include "app/editor/sandbox/groundstyle.h"
#include "app/editor/sandbox/sandbox.h"
#include "app/editor/sandbox/terrainmenu.h"
#include "app/editor/start/language.h"
#include "app/editor/start/settings.h"
#include "app/editor/window/docklayouts.h"
#include "app/editor/window/droptarget.h"
#include "app/editor/window/messagelog.h"
#include "app/editor/window/statuspanel.h"
#include "app/editor/window/workspace.h"
#include "views/itemmodels/logmodel.h"

#include <QMainWindow>

class QToolBar;

namespace views {
class CompressionDock;
class HistoryDock;
class LogDock;
class TimelineDock;
} // namespace views

namespace editor {

class WelcomePage;

/// The window: puts the parts together and lets the docks follow the present tab.
class MainWindow final : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(Language &language);
    ~MainWindow() override;

    void open(const QStringList &paths) { mFiles.openPaths(paths); }
    /// Asks about what an earlier session left, if it left something.
    void offerRecovery() { mFiles.offerRecovery(); }
    Workspace &workspace() { return *mWorkspace; }
    Sandbox &sandbox() { return mSandbox; }
    Actions &actions() { return mActions; }
    views::LogModel &log() { return mLog; }

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void makeDocks();
    void makeToolBars();
    QToolBar *makeToolBar(const char *key, std::initializer_list<ActionId> ids);
    void followDocument();
    void showKind(DocumentKind kind);
    void letGo();
    void showTitle();
    void retranslate();

    Settings mSettings;
    Language &mLanguage;
    views::LogModel mLog;
    MessageLog mMessageLog{mLog};
    Actions mActions;
    WelcomePage *mWelcome;
    Workspace *mWorkspace;
    FileActions mFiles;
    EditActions mEdits;
    RecordActions mRecords;
    ExportActions mExports;
    ViewActions mViews;
    CompareActions mCompares;
    HelpActions mHelp;
    Menus mMenus;
    GroundStyle mGroundStyle;
    Sandbox mSandbox;
    TerrainMenu mTerrainMenu;
    Inspector mInspector;
    MeshActions mMeshActions;
    StatusPanel mStatus;
    DropTarget mDrops;
    DockLayouts mLayouts;
    views::TimelineDock *mTimeline = nullptr;
    views::CompressionDock *mCompression = nullptr;
    views::HistoryDock *mHistory = nullptr;
    views::LogDock *mLogDock = nullptr;
    QList<QToolBar *> mToolBars;
    QAction *mDensity = nullptr; ///< the slider in its toolbar
};

} // namespace editor
