// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

/// The folder that a web server serves. What the page does with it: tests/app/web.
class TestExportPlayer : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void writesPageFilesPicturesAndList();
    void sameFileTwiceIsStoredOnce();
    void replacesAnEarlierExport();
    void leavesOtherFoldersAlone();
    void leavesNothingBehindOnErrors_data();
    void leavesNothingBehindOnErrors();
    void saysWhereThePageWasLookedFor();

private:
    QString path(const QString &name) const { return mFolder.filePath(name); }
    tests::CliRun run(const QStringList &arguments, const QString &page = QString()) const;
    static QString anim(const char *name)
    {
        return QStringLiteral(SANDREEL_SOURCE_DIR "/tests/data/anim/%1").arg(name);
    }
    QJsonArray listOf(const QString &folder) const;

    QTemporaryDir mFolder;
};

tests::CliRun TestExportPlayer::run(const QStringList &arguments, const QString &page) const
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("SANDREEL_PLAYER"), page.isEmpty() ? path("page") : page);
    return tests::runCli(QStringList{"export-player"} + arguments, {}, environment);
}

QJsonArray TestExportPlayer::listOf(const QString &folder) const
{
    const QJsonObject list = QJsonDocument::fromJson(tests::readFile(path(folder + "/list.json"))).object();
    return list.value("version") == 1 ? list.value("animations").toArray() : QJsonArray();
}

void TestExportPlayer::initTestCase()
{
    QDir().mkpath(path("page"));
    for (const char *name : {"index.html", "player.js", "decoder.wasm"})
        tests::writeFile(path("page/") + name, QByteArray("contents of ") + name);
    tests::writeFile(path("broken.anim"), tests::readFile(anim("reel-1.0.anim")).chopped(40));
    tests::writeFile(path("mesh.obj"), "v 0 0 0\n");
}

void TestExportPlayer::writesPageFilesPicturesAndList()
{
    const tests::CliRun done = run({path("site"), anim("reel-1.0.anim"), anim("direct-1.0.anim"), "--json"});
    QVERIFY2(done.exitCode == 0, done.err.constData());
    QCOMPARE(tests::readFile(path("site/player.js")), QByteArray("contents of player.js"));
    const QJsonArray list = listOf("site");
    QCOMPARE(list.size(), 2);
    QCOMPARE(done.json().value("animations").toArray(), list);
    const QStringList sources{"reel-1.0.anim", "direct-1.0.anim"};
    QStringList expected{"decoder.wasm", "files", "index.html", "list.json", "pictures", "player.js"};
    for (qsizetype i = 0; i < list.size(); ++i) {
        const QJsonObject entry = list[i].toObject();
        const QString file = entry.value("file").toString(), picture = entry.value("picture").toString();
        QCOMPARE(tests::readFile(path("site/" + file)), tests::readFile(anim(sources[i].toUtf8())));
        QCOMPARE(QImage(path("site/" + picture)).size(), QSize(480, 360));
        QVERIFY(!entry.value("name").toString().isEmpty());
        QCOMPARE(entry.value("vertices").toInt(), 30);
        QCOMPARE(entry.value("frames").toInt(), 5);
        expected << file << picture;
    }
    expected.sort();
    QCOMPARE(tests::contentsOf(path("site")), expected);
    QVERIFY(QFileInfo(path("site")).permissions().testFlag(QFile::ReadOther));
}

void TestExportPlayer::sameFileTwiceIsStoredOnce()
{
    const tests::CliRun done = run({path("twice"), anim("reel-1.0.anim"), anim("reel-1.0.anim")});
    QVERIFY2(done.exitCode == 0, done.err.constData());
    QCOMPARE(listOf("twice").size(), 2);
    QCOMPARE(QDir(path("twice/files")).entryList(QDir::Files).size(), 1);
}

void TestExportPlayer::replacesAnEarlierExport()
{
    QVERIFY(run({path("again"), anim("reel-1.0.anim")}).exitCode == 0);
    const QString first = listOf("again")[0].toObject().value("file").toString();
    QVERIFY(run({path("again"), anim("wave-1.0.anim")}).exitCode == 0);
    QVERIFY(!QFile::exists(path("again/" + first)));
    QCOMPARE(listOf("again").size(), 1);
    QCOMPARE(QDir(mFolder.path()).entryList({"again*"}, QDir::AllEntries | QDir::Hidden), QStringList{"again"});
}

void TestExportPlayer::leavesOtherFoldersAlone()
{
    QDir().mkpath(path("mine"));
    tests::writeFile(path("mine/thesis.txt"), "years of work");
    const tests::CliRun done = run({path("mine"), anim("reel-1.0.anim")});
    QCOMPARE(done.exitCode, 4);
    QVERIFY2(done.err.contains("other files"), done.err.constData());
    QCOMPARE(tests::contentsOf(path("mine")), QStringList{"thesis.txt"});
    const tests::CliRun onFile = run({path("mesh.obj"), anim("reel-1.0.anim")});
    QCOMPARE(onFile.exitCode, 4);
    QCOMPARE(tests::readFile(path("mesh.obj")), QByteArray("v 0 0 0\n"));
}

void TestExportPlayer::leavesNothingBehindOnErrors_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("exitCode");
    QTest::newRow("truncated") << path("broken.anim") << 3;
    QTest::newRow("missing") << path("none.anim") << 4;
    QTest::newRow("not an animation") << path("mesh.obj") << 2;
}

void TestExportPlayer::leavesNothingBehindOnErrors()
{
    QFETCH(const QString, file);
    QFETCH(const int, exitCode);
    QVERIFY(run({path("kept"), anim("reel-1.0.anim")}).exitCode == 0);
    const QStringList before = tests::contentsOf(path("kept"));
    const tests::CliRun onOld = run({path("kept"), anim("wave-1.0.anim"), file});
    QVERIFY2(onOld.exitCode == exitCode, onOld.err.constData());
    QCOMPARE(tests::contentsOf(path("kept")), before);
    QCOMPARE(run({path("fresh"), anim("wave-1.0.anim"), file}).exitCode, exitCode);
    QCOMPARE(QDir(mFolder.path()).entryList({"fresh*", "kept.*"}, QDir::AllEntries | QDir::Hidden), QStringList());
}

void TestExportPlayer::saysWhereThePageWasLookedFor()
{
    const tests::CliRun done = run({path("nowhere"), anim("reel-1.0.anim")}, path("no-page"));
    QCOMPARE(done.exitCode, 4);
    QVERIFY2(done.err.contains("no-page/index.html"), done.err.constData());
    QVERIFY(!QFile::exists(path("nowhere")));
}

SANDREEL_TEST(TestExportPlayer)
#include "tst_exportplayer.moc"
