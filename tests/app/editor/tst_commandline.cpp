// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/commandline.h"
#include "tests/support/testmain.h"

#include <QDir>

using editor::parseCommandLine;

class TestCommandLine final : public QObject
{
    Q_OBJECT

private slots:
    void everyOptionArrives()
    {
        const auto options = parseCommandLine({"sandreel", "--language", "cs", "--theme", "dark", "--size", "1200x800",
                                               "--frame", "7", "--play", "--compare", "walk.pc2", "--screenshot",
                                               "a.png", "--after", "250", "walk.anim"});
        QVERIFY(!options.exit);
        QCOMPARE(*options.language, QString("cs"));
        QVERIFY(options.theme == editor::Theme::Dark);
        QCOMPARE(*options.size, QSize(1200, 800));
        QCOMPARE(*options.frame, 7);
        QVERIFY(options.play);
        QCOMPARE(options.original, QDir::current().absoluteFilePath("walk.pc2"));
        QCOMPARE(options.screenshot, QString("a.png"));
        QCOMPARE(options.screenshotDelay, 250);
        QCOMPARE(options.paths, QStringList{QDir::current().absoluteFilePath("walk.anim")});
    }

    void nonsenseIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("unknown option") << QStringList{"--nosuch"};
        QTest::newRow("language") << QStringList{"--language", "xx"};
        QTest::newRow("theme") << QStringList{"--theme", "pink"};
        QTest::newRow("size") << QStringList{"--size", "12by8"};
        QTest::newRow("frame zero") << QStringList{"--frame", "0"};
        QTest::newRow("frame text") << QStringList{"--frame", "one"};
        QTest::newRow("negative delay") << QStringList{"--after", "-5"};
    }
    void nonsenseIsRefused()
    {
        QFETCH(QStringList, arguments);
        const auto options = parseCommandLine(QStringList{"sandreel"} + arguments);
        QVERIFY(options.exit);
        QCOMPARE(options.exit->code, 2);
        QVERIFY(options.exit->text.contains(arguments.constFirst().mid(2)));
    }

    void helpAndVersionEndWell()
    {
        QCOMPARE(parseCommandLine({"sandreel", "--help"}).exit->code, 0);
        QVERIFY(parseCommandLine({"sandreel", "--help"}).exit->text.contains("--screenshot"));
        QCOMPARE(parseCommandLine({"sandreel", "--version"}).exit->code, 0);
    }
};

SANDREEL_TEST(TestCommandLine)
#include "tst_commandline.moc"
