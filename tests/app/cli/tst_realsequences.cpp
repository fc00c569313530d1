// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

/// Real sequences go through the program as a user takes them there.
class TestRealSequences : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void encodeInfoDecodeCompare_data();
    void encodeInfoDecodeCompare();

private:
    QTemporaryDir mFolder;
};

void TestRealSequences::initTestCase()
{
    SANDREEL_REQUIRE_DATA();
}

void TestRealSequences::encodeInfoDecodeCompare_data()
{
    QTest::addColumn<int>("vertexCount");
    QTest::addColumn<int>("triangleCount");
    QTest::addColumn<int>("frameCount");
    QTest::addColumn<double>("kgBound"); // per cent, at basis 10
    QTest::newRow("chicken") << 3030 << 5664 << 400 << 10.0;
    QTest::newRow("cow") << 2904 << 5804 << 204 << 8.0;
    QTest::newRow("dance") << 7061 << 14118 << 201 << 4.0;
    QTest::newRow("samba") << 9971 << 19938 << 175 << 5.0;
    QTest::newRow("horse-gallop") << 8431 << 16843 << 48 << 4.0;
}

void TestRealSequences::encodeInfoDecodeCompare()
{
    QFETCH(const int, vertexCount);
    QFETCH(const int, triangleCount);
    QFETCH(const int, frameCount);
    QFETCH(const double, kgBound);
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    const QString folder = tests::sequenceFolder(name);
    const QString cache = folder + '/' + name + ".pc2";
    const QString input = QFile::exists(cache) ? cache : folder;
    const QString anim = mFolder.filePath(name + ".anim"), order = mFolder.filePath(name + ".txt"),
                  decoded = mFolder.filePath(name + ".pc2"), mesh = mFolder.filePath(name + ".obj");

    SANDREEL_RUN(encode, 0,
                 {"encode", input, "-o", anim, "--codec", "pca", "--basis", "10", "--normalize", "first",
                  "--permutation", order, "--json"});
    SANDREEL_RUN(info, 0, {"--json", "info", anim});
    QCOMPARE(info.json().value("vertices").toInt(), vertexCount);
    QCOMPARE(info.json().value("triangles").toInt(), triangleCount);
    QCOMPARE(info.json().value("frames").toInt(), frameCount);
    QCOMPARE(info.json().value("basis").toInt(), 10);
    QCOMPARE(info.json().value("bytes").toDouble(), double(QFile(anim).size()));
    QVERIFY(info.json().value("ratio").toDouble() > 10);

    SANDREEL_RUN(decode, 0, {"decode", anim, "-o", decoded, "--mesh", mesh});
    QCOMPARE(QFile(decoded).size(), 32 + qint64(12) * vertexCount * frameCount);
    SANDREEL_RUN(compare, 0, {"--json", "compare", input, decoded, "--permutation", order, "--normalize", "first"});
    const double kg = compare.json().value("kg_error_percent").toDouble(-1);
    qInfo("%s: %.0f bytes, KG %.3f %%", qPrintable(name), info.json().value("bytes").toDouble(), kg);
    QVERIFY(kg > 0 && kg < kgBound);

    if (input != cache)
        return;
    // A point cache that is only passed on keeps every bit.
    const QString copy = mFolder.filePath("copy.pc2");
    SANDREEL_RUN(pass, 0, {"decode", input, "-o", copy});
    QVERIFY(tests::readFile(copy).mid(32) == tests::readFile(cache).mid(32));
}

SANDREEL_TEST(TestRealSequences)
#include "tst_realsequences.moc"
