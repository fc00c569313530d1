// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/settings.h"
#include "app/editor/window/docklayouts.h"
#include "app/editor/window/windowstate.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

using editor::Settings;

class TestSettings final : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void garbageIsAsNothing()
    {
        QSettings raw;
        raw.setValue("interface/theme", QByteArray("\xff\x00\x17", 3));
        raw.setValue("files/recent", 17);
        raw.setValue("files/lastFolder", "/no/such/folder");
        raw.setValue("shortcuts/file.open", QVariantList{1, 2});
        raw.setValue("view/statistics", "perhaps");
        const Settings settings;
        QVERIFY(settings.theme() == editor::Theme::System);
        QCOMPARE(settings.recentFiles(), QStringList());
        QCOMPARE(settings.lastFolder(), QDir::homePath());
        QVERIFY(settings.shortcuts("file.open").value_or(QList<QKeySequence>()).isEmpty());
        settings.statisticsVisible(); // either will do
    }

    void layoutsOfOtherVersionsLeaveTheWindowWhole_data()
    {
        QTest::addColumn<QByteArray>("state");
        QMainWindow window;
        auto *dock = new QDockWidget(&window);
        dock->setObjectName("someDock");
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        const QByteArray future = window.saveState(99);
        QTest::newRow("future") << future;
        QTest::newRow("cut") << window.saveState(2).left(20);
        QTest::newRow("noise") << QByteArray(500, '\x5a');
        QTest::newRow("nothing") << QByteArray();
    }
    void layoutsOfOtherVersionsLeaveTheWindowWhole()
    {
        QFETCH(QByteArray, state);
        Settings settings;
        settings.setWindowGeometry(state);
        settings.setWindowState("animation", state);
        QMainWindow window;
        auto *dock = new QDockWidget(&window);
        dock->setObjectName("ourDock");
        window.addDockWidget(Qt::RightDockWidgetArea, dock);
        editor::restoreWindow(window, settings);
        editor::DockLayouts layouts(window, settings);
        layouts.add(*dock, {});
        layouts.restore(editor::DocumentKind::Animation);
        QCOMPARE(window.dockWidgetArea(dock), Qt::RightDockWidgetArea);
        QVERIFY(!dock->isHidden());
        QVERIFY(window.width() >= 200 && window.height() >= 150);
    }

    void windowComesBackAsItWas()
    {
        Settings settings;
        {
            QMainWindow window;
            auto *dock = new QDockWidget(&window);
            dock->setObjectName("ourDock");
            window.addDockWidget(Qt::LeftDockWidgetArea, dock);
            window.resize(640, 480);
            editor::DockLayouts layouts(window, settings);
            layouts.add(*dock, {});
            layouts.restore(editor::DocumentKind::Animation);
            layouts.save();
            editor::saveWindow(window, settings);
        }
        QMainWindow window;
        auto *dock = new QDockWidget(&window);
        dock->setObjectName("ourDock");
        window.addDockWidget(Qt::RightDockWidgetArea, dock);
        editor::restoreWindow(window, settings);
        editor::DockLayouts layouts(window, settings);
        layouts.add(*dock, {});
        layouts.restore(editor::DocumentKind::Animation);
        QCOMPARE(window.dockWidgetArea(dock), Qt::LeftDockWidgetArea);
        QCOMPARE(window.size(), QSize(640, 480));
    }

    void recentFilesAreNewestFirstWithoutDoubles()
    {
        Settings settings;
        for (int i = 0; i < 20; ++i)
            settings.addRecentFile(QString("/tmp/%1.anim").arg(i));
        settings.addRecentFile("/tmp/15.anim");
        QCOMPARE(settings.recentFiles().size(), qsizetype(Settings::MaxRecentFiles));
        QCOMPARE(settings.recentFiles().constFirst(), QString("/tmp/15.anim"));
        QCOMPARE(settings.recentFiles().count("/tmp/15.anim"), 1);
        settings.removeRecentFile("/tmp/15.anim");
        QVERIFY(!settings.recentFiles().contains("/tmp/15.anim"));
        settings.clearRecentFiles();
        QVERIFY(settings.recentFiles().isEmpty());
    }

    void shortcutsTellDefaultFromTakenAway()
    {
        Settings settings;
        QVERIFY(!settings.shortcuts("file.open"));
        settings.setShortcuts("file.open", QList<QKeySequence>());
        QVERIFY(settings.shortcuts("file.open"));
        QVERIFY(settings.shortcuts("file.open")->isEmpty());
        const QList<QKeySequence> keys{QKeySequence("Ctrl+J"), QKeySequence("F7")};
        settings.setShortcuts("file.open", keys);
        QCOMPARE(*settings.shortcuts("file.open"), keys);
        settings.setShortcuts("file.open", std::nullopt);
        QVERIFY(!settings.shortcuts("file.open"));
    }
};

SANDREEL_TEST(TestSettings)
#include "tst_settings.moc"
