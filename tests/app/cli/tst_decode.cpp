// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
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
    void firstBytesShowTheFirstTrajectories();
    void tooFewBytesAreRefused();
    void cutFilesCanBeDecodedInPart();
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

void TestDecode::firstBytesShowTheFirstTrajectories()
{
    SANDREEL_RUN(
        encode, 0,
        {"encode", path("in"), "-o", path("fine.anim"), "--step", "0.0005", "--permutation", path("fine.txt")});
    SANDREEL_RUN(info, 0, {"info", path("fine.anim"), "--json"});
    const int basis = info.json().value("basis").toInt();
    QVERIFY(basis > 1);
    const QJsonArray prefixes = info.json().value("prefixes").toArray();
    QCOMPARE(prefixes.size(), qsizetype(basis + 1));
    SANDREEL_RUN(text, 0, {"info", path("fine.anim")});
    QVERIFY2(text.out.contains("first picture after " +
                               QByteArray::number(prefixes[0].toObject().value("bytes").toInt()) + " bytes"),
             text.out.constData());
    const tests::Frames original = tests::framesOf(*mWave);
    const std::vector<std::uint32_t> permutation = tests::readPermutation(path("fine.txt"));
    const qint64 size = QFileInfo(path("fine.anim")).size();
    double before = 1e9;
    for (int k = 0; k <= basis; ++k) {
        QCOMPARE(prefixes[k].toObject().value("basis").toInt(), k);
        const int bytes = prefixes[k].toObject().value("bytes").toInt();
        SANDREEL_RUN(
            part, 0,
            {"decode", path("fine.anim"), "-o", path("part.pc2"), "--json", "--bytes", QString::number(bytes)});
        QCOMPARE(part.json().value("basis").toInt(), k);
        QCOMPARE(part.json().value("basis_in_file").toInt(), basis);
        QCOMPARE(part.json().value("bytes").toInt(), bytes);
        QCOMPARE(part.json().value("file_bytes").toInt(), int(size));
        // It is nearer to the original with each trajectory.
        const auto cache = tests::readPc2(path("part.pc2"));
        QVERIFY(cache.has_value());
        const double error = tests::errorsBetween(original, cache->frames, permutation).kgPercent;
        QVERIFY2(error < before, qPrintable(QString("%1 after %2").arg(error).arg(before)));
        before = error;
        if (k > 0) {
            SANDREEL_RUN(
                less, 0,
                {"decode", path("fine.anim"), "-o", path("less.pc2"), "--json", "--bytes", QString::number(bytes - 1)});
            QCOMPARE(less.json().value("basis").toInt(), k - 1);
        }
    }
    // More than there is: the whole file.
    SANDREEL_RUN(all, 0, {"decode", path("fine.anim"), "-o", path("all.pc2"), "--bytes", "1000000"});
    QVERIFY2(all.err.contains(QStringLiteral("from %1 of %1 bytes with %2 of %2").arg(size).arg(basis).toLatin1()),
             all.err.constData());
    SANDREEL_RUN(whole, 0, {"decode", path("fine.anim"), "-o", path("whole.pc2")});
    QVERIFY(tests::readFile(path("all.pc2")) == tests::readFile(path("whole.pc2")));
}

void TestDecode::tooFewBytesAreRefused()
{
    SANDREEL_RUN(info, 0, {"info", path("in.anim"), "--json"});
    const int needed = info.json().value("prefixes").toArray().at(0).toObject().value("bytes").toInt();
    QVERIFY(needed > 20);
    for (const int bytes : {1, 20, needed - 1}) {
        SANDREEL_RUN(run, 2, {"decode", path("in.anim"), "-o", path("few.pc2"), "--bytes", QString::number(bytes)});
        QVERIFY2(run.err.contains(QByteArray::number(needed) + " or more"), run.err.constData());
        QVERIFY(!QFileInfo::exists(path("few.pc2")));
    }
    SANDREEL_RUN(none, 2, {"decode", path("in.anim"), "-o", path("few.pc2"), "--bytes", "0"});
    SANDREEL_RUN(frames, 2, {"decode", path("in"), "-o", path("few.pc2"), "--bytes", "1000"});
    QVERIFY2(frames.err.contains("codec reel"), frames.err.constData());
    SANDREEL_RUN(encode, 0, {"encode", path("in"), "-o", path("pca.anim"), "--codec", "pca"});
    SANDREEL_RUN(pca, 2, {"decode", path("pca.anim"), "-o", path("few.pc2"), "--bytes", "300"});
    QVERIFY2(pca.err.contains("codec reel"), pca.err.constData());
}

void TestDecode::cutFilesCanBeDecodedInPart()
{
    const QByteArray whole = tests::readFile(path("in.anim"));
    tests::writeFile(path("cut.anim"), whole.left(whole.size() - 20));
    SANDREEL_RUN(run, 3, {"decode", path("cut.anim"), "-o", path("cut.pc2")});
    QVERIFY2(run.err.contains("too early") && run.err.contains("--bytes " + QByteArray::number(whole.size() - 20)),
             run.err.constData());
    SANDREEL_RUN(part, 0, {"decode", path("cut.anim"), "-o", path("cut.pc2"), "--json", "--bytes", "1000000"});
    QCOMPARE(part.json().value("bytes").toInt(), int(whole.size() - 20));
    QCOMPARE(part.json().value("file_bytes").toInt(), int(whole.size()));
    QVERIFY(part.json().value("basis").toInt() < part.json().value("basis_in_file").toInt());
    // Nothing that could be shown.
    tests::writeFile(path("short.anim"), whole.left(60));
    SANDREEL_RUN(none, 3, {"decode", path("short.anim"), "-o", path("none.pc2")});
    QVERIFY2(!none.err.contains("--bytes"), none.err.constData());
    SANDREEL_RUN(early, 3, {"decode", path("short.anim"), "-o", path("none.pc2"), "--bytes", "50"});
    QVERIFY2(early.err.contains("too early"), early.err.constData());
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
