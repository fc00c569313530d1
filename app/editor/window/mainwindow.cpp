// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/mainwindow.h"

#include "app/editor/actions/shortcuts.h"
#include "app/editor/documents/animationtab.h"
#include "app/editor/start/welcomepage.h"
#include "app/editor/window/windowstate.h"
#include "views/docks/compressiondock.h"
#include "views/docks/historydock.h"
#include "views/docks/logdock.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/docks/terrain/materialdock.h"
#include "views/docks/terrain/profiledock.h"
#include "views/docks/terrain/toolsdock.h"
#include "views/docks/timelinedock.h"
#include "views/haptics/hapticsdock.h"
#include "views/inspect/inspectordock.h"
#include "views/widgets/icons.h"

#include <QCloseEvent>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>

namespace editor {

namespace {

constexpr const char *ToolBarTitles[][2] = {
    {"fileToolBar", QT_TRANSLATE_NOOP("editor::MainWindow", "File Toolbar")},
    {"editToolBar", QT_TRANSLATE_NOOP("editor::MainWindow", "Edit Toolbar")},
    {"viewToolBar", QT_TRANSLATE_NOOP("editor::MainWindow", "View Toolbar")},
};

} // namespace

MainWindow::MainWindow(Language &language)
    : mLanguage(language)
    , mActions(*this)
    , mWelcome(new WelcomePage(mActions, mSettings))
    , mWorkspace(new Workspace(mWelcome, this))
    , mFiles(mActions, *mWorkspace, mSettings, mLog, *this)
    , mEdits(mActions, *mWorkspace, *this)
    , mRecords(mActions, *mWorkspace, mFiles, *statusBar())
    , mExports(mActions, *mWorkspace, mSettings, *this)
    , mViews(mActions, *mWorkspace, mSettings, *this)
    , mCompares(mActions, *mWorkspace, mSettings, mLog, *this)
    , mHelp(mActions, mSettings, *this)
    , mMenus(*this, mActions, mSettings, mLanguage)
    , mGroundStyle(mActions, *mWorkspace, mMenus.groundMenu())
    , mSandbox(mActions, *mWorkspace, *this)
    , mTerrainMenu(mActions, mMenus, mSandbox)
    , mInspector(mActions, mFiles, *mWorkspace, mSettings, *this)
    , mMeshActions(mActions, mFiles, *mWorkspace, mMenus.meshMenu())
    , mStatus(*statusBar(), *mWorkspace)
    , mDrops(*this)
    , mLayouts(*this, mSettings)
{
    setObjectName(QStringLiteral("mainWindow"));
    setCentralWidget(mWorkspace);
    setDockNestingEnabled(true);
    makeToolBars();
    makeDocks();
    applyShortcuts(mActions, mSettings);

    connect(mWelcome, &WelcomePage::openRequested, this, [this](const QString &path) { open({path}); });
    connect(&mMenus, &Menus::openRequested, this, [this](const QString &path) { open({path}); });
    connect(&mMenus, &Menus::recentFilesCleared, mWelcome, &WelcomePage::refresh);
    connect(&mDrops, &DropTarget::dropped, this, &MainWindow::open);
    connect(&mSandbox, &Sandbox::readingChanged, &mStatus, &StatusPanel::showReading);
    connect(&mSandbox.maskAction(), &QAction::toggled, &mGroundStyle, &GroundStyle::showMask);
    connect(&mSandbox, &Sandbox::strokeTold, &mStatus, &StatusPanel::showMessage);
    connect(&mFiles, &FileActions::quitReady, this, &QWidget::close);
    connect(mWorkspace, &Workspace::currentChanged, this, &MainWindow::followDocument);
    connect(mWorkspace, &Workspace::currentStateChanged, this, &MainWindow::followDocument);
    retranslate();
    restoreWindow(*this, mSettings);
    mLayouts.restore(DocumentKind::Animation);
    mActions.showFor(DocumentKind::Animation);
    for (QMenu *menu : {&mMenus.groundMenu(), &mMenus.terrainMenu(), &mMenus.meshMenu()})
        menu->menuAction()->setVisible(false);
    followDocument();
}

MainWindow::~MainWindow()
{
    // The documents go first, while everything that follows them is still there; also those whose tabs are closed and
    // wait for the event loop.
    mRecords.drop();
    mWorkspace->blockSignals(true);
    for (DocumentTab *tab : findChildren<DocumentTab *>())
        delete tab;
}

void MainWindow::makeToolBars()
{
    makeToolBar("fileToolBar", {ActionId::Prepare, ActionId::NewTerrain, ActionId::Open, ActionId::Save});
    makeToolBar("editToolBar", {ActionId::Undo, ActionId::Redo, ActionId::Sculpt, ActionId::Trim, ActionId::Reverse,
                                ActionId::Resample, ActionId::Normalise});
    QToolBar *view = makeToolBar("viewToolBar",
                                 {ActionId::Shaded, ActionId::ShadedWireframe, ActionId::Wireframe, ActionId::Points});
    mDensity = view->addWidget(mViews.makeDensitySlider(view));
    view->addSeparator();
    view->addAction(&mActions[ActionId::Fit]);
    view->addAction(&mActions[ActionId::Statistics]);
}

QToolBar *MainWindow::makeToolBar(const char *key, std::initializer_list<ActionId> ids)
{
    auto *bar = new QToolBar(this);
    bar->setObjectName(QLatin1String(key));
    bar->setIconSize({20, 20});
    for (const ActionId id : ids)
        bar->addAction(&mActions[id]);
    addToolBar(bar);
    mToolBars << bar;
    return bar;
}

void MainWindow::makeDocks()
{
    mTimeline = new views::TimelineDock(this);
    mCompression = new views::CompressionDock(this);
    mHistory = new views::HistoryDock(this);
    mLogDock = new views::LogDock(mLog, this);
    addDockWidget(Qt::BottomDockWidgetArea, mTimeline);
    addDockWidget(Qt::RightDockWidgetArea, mCompression);
    addDockWidget(Qt::RightDockWidgetArea, mHistory);
    addDockWidget(Qt::BottomDockWidgetArea, mLogDock);
    addDockWidget(Qt::LeftDockWidgetArea, &mSandbox.tools());
    for (QDockWidget *dock :
         {static_cast<QDockWidget *>(&mSandbox.erosion()), static_cast<QDockWidget *>(&mSandbox.materials())}) {
        addDockWidget(Qt::RightDockWidgetArea, dock);
        splitDockWidget(dock, mHistory, Qt::Vertical);
    }
    addDockWidget(Qt::RightDockWidgetArea, &mInspector.dock());
    splitDockWidget(&mInspector.dock(), mHistory, Qt::Vertical);
    for (QDockWidget *view : mInspector.views())
        addDockWidget(Qt::LeftDockWidgetArea, view);
    tabifyDockWidget(&mSandbox.materials(), &mSandbox.erosion());
    tabifyDockWidget(&mSandbox.erosion(), &mSandbox.feeling().dock());
    addDockWidget(Qt::BottomDockWidgetArea, &mSandbox.profile());
    splitDockWidget(mTimeline, mLogDock, Qt::Vertical);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    mLogDock->hide();
    resizeDocks({mCompression, mHistory}, {300, 300}, Qt::Horizontal);
    resizeDocks({mCompression, mHistory}, {430, 220}, Qt::Vertical);

    mTimeline->addErrorActions(
        {&mActions[ActionId::ErrorColors], &mActions[ActionId::ErrorRange], &mActions[ActionId::StopComparing]});
    const QList<QAction *> playActions = mTimeline->actions();
    for (QAction *action : playActions) {
        mMenus.playMenu().addAction(action);
        mActions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&Play"), DocumentKind::Animation);
    }
    mLayouts.add(*mTimeline, DocumentKind::Animation);
    mLayouts.add(*mCompression, DocumentKind::Animation);
    QList<QDockWidget *> sandbox{&mSandbox.tools(), &mSandbox.erosion(), &mSandbox.materials()};
    for (QDockWidget *dock : sandbox)
        mLayouts.add(*dock, DocumentKind::Terrain);
    for (QDockWidget *dock :
         {static_cast<QDockWidget *>(&mSandbox.profile()), static_cast<QDockWidget *>(&mSandbox.feeling().dock())}) {
        mLayouts.add(*dock, DocumentKind::Terrain, true);
        sandbox << dock;
    }
    mLayouts.add(mInspector.dock(), DocumentKind::Mesh);
    for (QDockWidget *view : mInspector.views())
        mLayouts.add(*view, DocumentKind::Mesh, true);
    mLayouts.add(*mHistory, {});
    mLayouts.add(*mLogDock, {}, true);
    QList<QAction *> docks;
    for (QDockWidget *dock :
         sandbox + mInspector.views() +
             QList<QDockWidget *>{&mInspector.dock(), mTimeline, mCompression, mHistory, mLogDock}) {
        dock->toggleViewAction()->setObjectName(QStringLiteral("view.") + dock->objectName());
        mActions.adopt(*dock->toggleViewAction(), QT_TRANSLATE_NOOP("Actions", "&View"));
        docks << dock->toggleViewAction();
    }
    QList<QAction *> bars;
    for (QToolBar *bar : mToolBars)
        bars << bar->toggleViewAction();
    mMenus.addPanelActions(docks, bars);
}

void MainWindow::followDocument()
{
    DocumentTab *tab = mWorkspace->current();
    if (tab)
        showKind(tab->document().kind()); // without a tab everything stays as it is
    mHistory->setContext(tab ? tab->document().context() : nullptr);
    AnimationTab *animation = mWorkspace->currentAnimation();
    commands::AnimationContext *context = animation ? animation->document().context() : nullptr;
    mCompression->setDocument(context, animation ? animation->document().fileFacts() : std::nullopt);
    mTimeline->setPlayer(context ? &animation->document().player() : nullptr);
    mTimeline->setComparison(context ? &animation->document().comparison() : nullptr);
    if (tab)
        connect(&tab->document(), &Document::aboutToBeReplaced, this, &MainWindow::letGo, Qt::UniqueConnection);
    showTitle();
}

void MainWindow::showKind(DocumentKind kind)
{
    mLayouts.show(kind);
    mActions.showFor(kind);
    for (QAction *action : {mMenus.playMenu().menuAction(), mDensity})
        action->setVisible(kind == DocumentKind::Animation);
    for (QAction *action : {mMenus.groundMenu().menuAction(), mMenus.terrainMenu().menuAction()})
        action->setVisible(kind == DocumentKind::Terrain);
    mMenus.meshMenu().menuAction()->setVisible(kind == DocumentKind::Mesh);
}

void MainWindow::letGo()
{
    const DocumentTab *tab = mWorkspace->current();
    if (!tab || sender() != &tab->document())
        return;
    mHistory->setContext(nullptr);
    mCompression->setDocument(nullptr, std::nullopt);
    mTimeline->setPlayer(nullptr);
    mTimeline->setComparison(nullptr);
}

void MainWindow::showTitle()
{
    const DocumentTab *tab = mWorkspace->current();
    setWindowTitle(tab ? tab->document().title() + QStringLiteral("[*] – Sandreel") : QStringLiteral("Sandreel"));
    setWindowModified(tab && tab->document().isModified());
    setWindowFilePath(tab ? tab->document().path() : QString());
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    mRecords.stop();
    if (!mFiles.mayQuit()) {
        event->ignore();
        return;
    }
    if (!isFullScreen()) {
        saveWindow(*this, mSettings);
        mLayouts.save();
    }
    for (DocumentTab *tab : mWorkspace->tabs())
        tab->document().abandon(); // saved, or the user said that it need not be
    event->accept();
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::WindowStateChange)
        mActions[ActionId::FullScreen].setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
}

void MainWindow::retranslate()
{
    mActions.retranslate();
    mMenus.retranslate();
    mViews.retranslate();
    mGroundStyle.retranslate();
    mTerrainMenu.retranslate();
    mInspector.retranslate();
    mMeshActions.retranslate();
    mStatus.retranslate();
    for (QToolBar *bar : mToolBars)
        for (const auto &[key, title] : ToolBarTitles)
            if (bar->objectName() == QLatin1String(key))
                bar->setWindowTitle(tr(title));
}

} // namespace editor
