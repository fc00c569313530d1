// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/menus.h"

#include "app/editor/start/language.h"
#include "app/editor/start/samples.h"
#include "app/editor/window/theme.h"
#include "views/widgets/icons.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace editor {

namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

} // namespace

Menus::Menus(QMainWindow &window, Actions &actions, Settings &settings, Language &language)
    : mWindow(window)
    , mActions(actions)
    , mSettings(settings)
    , mLanguage(language)
{
    fillFile();
    fillEdit();
    fillView();
    fillTerrain();
    mPlay = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Play"));
    mMesh = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Mesh"));
    fillSettings();
    fillHelp();
    retranslate();
}

QMenu *Menus::addMenu(QMenu *parent, const char *title, const QString &iconName)
{
    QMenu *menu = parent ? parent->addMenu(QString()) : mWindow.menuBar()->addMenu(QString());
    if (!iconName.isEmpty())
        menu->setIcon(views::icon(iconName));
    mTitled.push_back({menu, title});
    return menu;
}

void Menus::fillFile()
{
    QMenu *menu = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&File"));
    for (const ActionId id : {ActionId::Prepare, ActionId::NewTerrain, ActionId::ImportTerrain})
        menu->addAction(&mActions[id]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Open]);
    mRecent = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "Open &Recent"), QStringLiteral("recent"));
    connect(mRecent, &QMenu::aboutToShow, this, &Menus::showRecentFiles);
    mSamples = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "Open Sa&mple"), QStringLiteral("sample"));
    connect(mSamples, &QMenu::aboutToShow, this, &Menus::showSamples);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Save]);
    menu->addAction(&mActions[ActionId::SaveAs]);
    QMenu *exports = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Export"), QStringLiteral("export"));
    for (const ActionId id :
         {ActionId::ExportFrames, ActionId::ExportPointCache, ActionId::ExportScreenshot, ActionId::ExportPictures,
          ActionId::ExportTerrain, ActionId::TerrainScreenshot, ActionId::Turntable})
        exports->addAction(&mActions[id]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Reload]);
    menu->addAction(&mActions[ActionId::CloseTab]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Quit]);
}

void Menus::fillEdit()
{
    QMenu *menu = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Edit"));
    menu->addAction(&mActions[ActionId::Undo]);
    menu->addAction(&mActions[ActionId::Redo]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Trim]);
    menu->addAction(&mActions[ActionId::Reverse]);
    menu->addAction(&mActions[ActionId::Resample]);
    menu->addAction(&mActions[ActionId::FrameRate]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Normalise]);
    menu->addAction(&mActions[ActionId::Rename]);
}

void Menus::fillView()
{
    QMenu *menu = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&View"));
    for (const ActionId id : {ActionId::Shaded, ActionId::ShadedWireframe, ActionId::Wireframe, ActionId::Points})
        menu->addAction(&mActions[id]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Fit]);
    menu->addAction(&mActions[ActionId::Statistics]);
    menu->addSeparator();
    mGround = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Ground"));
    for (const ActionId id : {ActionId::Compare, ActionId::ErrorColors, ActionId::ErrorRange, ActionId::StopComparing})
        menu->addAction(&mActions[id]);
    menu->addAction(&mActions[ActionId::InspectFrame]);
    menu->addSeparator();
    mDocks = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Docks"));
    mToolBars = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Toolbars"));
    menu->addAction(&mActions[ActionId::FullScreen]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::NextTab]);
    menu->addAction(&mActions[ActionId::PreviousTab]);
}

void Menus::fillTerrain()
{
    mTerrain = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Terrain"));
    mTerrain->addAction(&mActions[ActionId::Sculpt]);
    mTerrain->addAction(&mActions[ActionId::Record]);
    mTool = addMenu(mTerrain, QT_TRANSLATE_NOOP("Actions", "&Tool"), QStringLiteral("sculpt"));
    mSymmetry = addMenu(mTerrain, QT_TRANSLATE_NOOP("Actions", "S&ymmetry"), QStringLiteral("symmetry"));
    mTerrain->addSeparator();
}

void Menus::fillSettings()
{
    QMenu *menu = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Settings"));
    menu->addAction(&mActions[ActionId::ConfigureShortcuts]);

    QMenu *languages = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Language"), QStringLiteral("language"));
    auto *languageGroup = new QActionGroup(this);
    for (const Language::Choice &choice : Language::choices()) {
        QAction *action = languageGroup->addAction(languages->addAction(choice.name));
        action->setObjectName(QStringLiteral("language.") + choice.code);
        action->setCheckable(true);
        action->setChecked(choice.code == mLanguage.current());
        connect(action, &QAction::triggered, this, [this, code = choice.code] {
            mSettings.setLanguage(code);
            mLanguage.apply(code);
        });
    }

    QMenu *themes = addMenu(menu, QT_TRANSLATE_NOOP("Actions", "&Theme"), QStringLiteral("theme"));
    auto *themeGroup = new QActionGroup(this);
    const std::tuple<Theme, const char *, const char *> choices[] = {
        {Theme::System, "theme.system", QT_TRANSLATE_NOOP("Actions", "Like the &System")},
        {Theme::Light, "theme.light", QT_TRANSLATE_NOOP("Actions", "&Light")},
        {Theme::Dark, "theme.dark", QT_TRANSLATE_NOOP("Actions", "&Dark")},
    };
    for (const auto &[theme, key, text] : choices) {
        QAction *action = themeGroup->addAction(themes->addAction(QString()));
        action->setObjectName(QLatin1String(key));
        action->setCheckable(true);
        action->setChecked(theme == mSettings.theme());
        mTexts.emplace_back(action, text);
        connect(action, &QAction::triggered, this, [this, chosen = theme] {
            mSettings.setTheme(chosen);
            applyTheme(chosen);
        });
    }
}

void Menus::fillHelp()
{
    QMenu *menu = addMenu(nullptr, QT_TRANSLATE_NOOP("Actions", "&Help"));
    menu->addAction(&mActions[ActionId::ShortcutList]);
    menu->addSeparator();
    menu->addAction(&mActions[ActionId::Licences]);
    menu->addAction(&mActions[ActionId::About]);
}

void Menus::addPanelActions(const QList<QAction *> &docks, const QList<QAction *> &toolBars)
{
    mDocks->addActions(docks);
    mToolBars->addActions(toolBars);
}

void Menus::retranslate()
{
    for (const Titled &titled : mTitled)
        titled.menu->setTitle(translated(titled.title));
    for (const auto &[action, text] : mTexts)
        action->setText(translated(text));
}

void Menus::showRecentFiles()
{
    mRecent->clear();
    const QStringList files = mSettings.recentFiles();
    for (const QString &path : files) {
        const QFileInfo file(path);
        QString name = file.fileName();
        name.replace(QLatin1Char('&'), QLatin1String("&&"));
        QAction *action =
            mRecent->addAction(file.exists() ? name : QCoreApplication::translate("Actions", "%1 (missing)").arg(name));
        action->setEnabled(file.exists());
        action->setStatusTip(QDir::toNativeSeparators(path));
        connect(action, &QAction::triggered, this, [this, path] { emit openRequested(path); });
    }
    if (files.isEmpty()) {
        mRecent->addAction(translated(QT_TRANSLATE_NOOP("Actions", "No Recent Files")))->setEnabled(false);
        return;
    }
    mRecent->addSeparator();
    connect(mRecent->addAction(translated(QT_TRANSLATE_NOOP("Actions", "&Clear List"))), &QAction::triggered, this,
            [this] {
                mSettings.clearRecentFiles();
                emit recentFilesCleared();
            });
}

void Menus::showSamples()
{
    mSamples->clear();
    for (const Sample &sample : samples()) {
        QAction *action = mSamples->addAction(sample.name);
        connect(action, &QAction::triggered, this, [this, path = sample.path] { emit openRequested(path); });
    }
    if (mSamples->isEmpty())
        mSamples->addAction(translated(QT_TRANSLATE_NOOP("Actions", "No Samples")))->setEnabled(false);
}

} // namespace editor
