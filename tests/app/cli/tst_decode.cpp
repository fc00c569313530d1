// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

class TestDecode : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void pointCacheIsExactlyItsFormat();
    void framesAgreeWithThePointCache_data();
    void framesAgreeWithThePointCache();
    void baseMeshIsTheFirstFrame();
    void pointCacheIsReadBack();
    void framesAlreadyThereAreKept();
    void inputFolderIsNoOutput();
    void outputThatCannotBeWritten_data();
    void outputThatCannotBeWritten();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
    tests::SequencePtr mWave = tests::wave(tests::torus(), 4);
};

void TestDecode::initTestCase()
{
    tests::writeObjFolder(path("in"), *mWave);
    SANDREEL_RUN(encode, 0, {"encode", path("in"), "-o", path("in.anim"), "--permutation", path("in.txt")});
    SANDREEL_RUN(decode, 0, {"decode", path("in.anim"), "-o", path("in.pc2"), "--json"});
    QCOMPARE(decode.json().value("frames").toInt(), 4);
    QCOMPARE(decode.json().value("vertices").toInt(), 96);
}

void TestDecode::pointCacheIsExactlyItsFormat()
{
    // Frames that are not encoded come through bit for bit, so the whole file is known.
    SANDREEL_RUN(run, 0, {"decode", path("in"), "-o", path("exact.PC2")});
    tests::writePc2(path("expected.pc2"), *mWave);
    QVERIFY(tests::readFile(path("exact.PC2")) == tests::readFile(path("expected.pc2")));
    QCOMPARE(tests::readFile(path("in.pc2")).left(32), tests::readFile(path("expected.pc2")).left(32));
}

void TestDecode::framesAgreeWithThePointCache_data()
{
    QTest::addColumn<QString>("ending");
    for (const char *ending : {"obj", "off", "ply"})
        QTest::newRow(ending) << QString::fromLatin1(ending);
}

void TestDecode::framesAgreeWithThePointCache()
{
    QFETCH(const QString, ending);
    const QString folder = mFolder.filePath("deep/" + ending);
    SANDREEL_RUN(decode, 0, {"decode", path("in.anim"), "-o", folder, "--format", ending});
    QStringList expected;
    for (int i = 1; i <= 4; ++i)
        expected << QStringLiteral("frame_000%1.%2").arg(i).arg(ending);
    QCOMPARE(tests::contentsOf(folder), expected);
    if (ending != QLatin1String("obj"))
        return; // what is in them is the business of the writers' tests

    const auto cache = tests::readPc2(path("in.pc2"));
    QVERIFY(cache.has_value());
    for (int frame = 0; frame < 4; ++frame) {
        std::size_t vertex = 0;
        int faces = 0;
        for (const QByteArray &line : tests::readFile(folder + '/' + expected[frame]).split('\n')) {
            const QList<QByteArray> words = line.simplified().split(' ');
            if (words[0] == "f")
                ++faces;
            if (words[0] != "v")
                continue;
            const model::Vec3f p{words[1].toFloat(), words[2].toFloat(), words[3].toFloat()};
            QVERIFY(p == cache->frames[std::size_t(frame)].at(vertex++));
        }
        QCOMPARE(vertex, std::size_t(96));
        QCOMPARE(faces, 192);
    }
}

void TestDecode::baseMeshIsTheFirstFrame()
{
    SANDREEL_RUN(run, 0, {"decode", path("in.anim"), "-o", path("m.pc2"), "--mesh", path("m.obj")});
    SANDREEL_RUN(frames, 0, {"decode", path("in.anim"), "-o", path("m_frames")});
    QVERIFY(!tests::readFile(path("m.obj")).isEmpty());
    QCOMPARE(tests::readFile(path("m.obj")), tests::readFile(path("m_frames/frame_0001.obj")));
}

void TestDecode::pointCacheIsReadBack()
{
    // With its mesh beside it, and with one that is named.
    SANDREEL_RUN(write, 0, {"decode", path("in.anim"), "-o", path("back.pc2"), "--mesh", path("back.obj")});
    SANDREEL_RUN(beside, 0, {"--json", "compare", path("in.anim"), path("back.pc2")});
    QCOMPARE(beside.json().value("max_vertex_error").toDouble(-1), 0.0);
    SANDREEL_RUN(named, 0, {"--json", "info", path("in.pc2"), "--base-mesh", path("back.obj")});
    QCOMPARE(named.json().value("triangles").toInt(), 192);
    QCOMPARE(named.json().value("frames").toInt(), 4);
    SANDREEL_RUN(none, 3, {"info", path("in.pc2")});
    QVERIFY2(none.err.contains("in.pc2") && none.err.contains("point cache"), none.err.constData());
}

void TestDecode::framesAlreadyThereAreKept()
{
    QDir().mkpath(path("full"));
    tests::writeFile(path("full/frame_0002.obj"), "mine");
    SANDREEL_RUN(run, 4, {"decode", path("in.anim"), "-o", path("full")});
    QCOMPARE(tests::contentsOf(path("full")), QStringList{"frame_0002.obj"});
    QCOMPARE(tests::readFile(path("full/frame_0002.obj")), QByteArray("mine"));
}

/// Frames of another format would not be in the way of one another, but nobody could tell the two animations apart.
void TestDecode::inputFolderIsNoOutput()
{
    SANDREEL_RUN(write, 0, {"decode", path("in.anim"), "-o", path("both"), "--format", "off"});
    const QStringList before = tests::contentsOf(path("both"));
    for (const QString &target : {path("both"), path("both/"), path("both/../both")}) {
        SANDREEL_RUN(run, 2, {"decode", path("both"), "-o", target, "--format", "obj"});
        QVERIFY2(run.err.contains("a folder that is not the input"), run.err.constData());
        QCOMPARE(tests::contentsOf(path("both")), before);
    }
}

void TestDecode::outputThatCannotBeWritten_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("cache in a missing folder") << QStringList{"-o", path("missing/x.pc2")};
    QTest::newRow("cache in a read-only file system") << QStringList{"-o", "/proc/x.pc2"};
    QTest::newRow("folder in a read-only file system") << QStringList{"-o", "/proc/x"};
    QTest::newRow("folder below a file") << QStringList{"-o", path("in.anim/x")};
    QTest::newRow("folder that is a file") << QStringList{"-o", path("in.txt")};
    QTest::newRow("mesh in a missing folder") << QStringList{"-o", path("x.pc2"), "--mesh", path("missing/x.obj")};
    QTest::newRow("mesh written, frames not") << QStringList{"--mesh", path("x.obj"), "-o", "/proc/x"};
}

void TestDecode::outputThatCannotBeWritten()
{
    QFETCH(const QStringList, arguments);
    const QStringList before = tests::contentsOf(mFolder.path());
    const QByteArray permutation = tests::readFile(path("in.txt"));
    SANDREEL_RUN(run, 4, QStringList{"decode", path("in.anim")} + arguments);
    QVERIFY2(run.err.contains(arguments.last().toUtf8()), run.err.constData());
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
    QCOMPARE(tests::readFile(path("in.txt")), permutation);
}

SANDREEL_TEST(TestDecode)
#include "tst_decode.moc"
