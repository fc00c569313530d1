// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

class TestEncode : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void encodesEveryAnimation_data();
    void encodesEveryAnimation();
    void sameInputSameBytes();
    void infoAgreesWithTheFile();
    void infoOfFrames();
    void measuresWhatWasLost();
    void normalisesIntoTheCube_data();
    void normalisesIntoTheCube();
    void rateAndNameAreKept();
    void anAnimWithTheSameSettingsKeepsItsStream();
    void moreBasisIsMoreExact();
    void directIsEncoded();
    void targetsAreMet_data();
    void targetsAreMet();
    void outputThatCannotBeWritten_data();
    void outputThatCannotBeWritten();
    void failedOutputLeavesTheOldFile();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
    tests::SequencePtr mTorus;
};

void TestEncode::initTestCase()
{
    mTorus = tests::noise(tests::torus(), 20);
    tests::writeObjFolder(path("torus"), *mTorus);
    QDir().mkpath(path("folder"));
    SANDREEL_RUN(run, 0, {"encode", path("torus"), "-o", path("torus.anim")});
}

void TestEncode::encodesEveryAnimation_data()
{
    QTest::addColumn<int>("index");
    for (const char *name :
         {"wave of cube", "wave of two parts", "wave of degenerate", "wave of non-manifold", "wave of isolated vertex",
          "noisy tetrahedron, more frames than coordinates", "one frame of one vertex"}) {
        const auto &all = tests::namedAnimations();
        const auto found = std::ranges::find(all, name, &tests::NamedAnimation::name);
        QTest::newRow(name) << int(found - all.begin());
    }
}

/// Encoded finely, decoded to a point cache and put back in order, each vertex is where it was.
void TestEncode::encodesEveryAnimation()
{
    QFETCH(const int, index);
    QVERIFY(index < int(tests::namedAnimations().size()));
    const model::Sequence &original = *tests::namedAnimations()[std::size_t(index)].sequence;
    const QString base = mFolder.filePath(QStringLiteral("shape%1").arg(index));
    tests::writeObjFolder(base, original);
    SANDREEL_RUN(encode, 0,
                 {"encode", base, "-o", base + ".anim", "--codec", "pca", "--basis", "200", "--resolution", "1e6",
                  "--permutation", base + ".txt"});
    SANDREEL_RUN(decode, 0, {"decode", base + ".anim", "-o", base + ".pc2"});

    const auto order = tests::readPermutation(base + ".txt");
    auto sorted = order;
    std::ranges::sort(sorted);
    QCOMPARE(sorted.size(), std::size_t(original.vertexCount()));
    for (std::size_t i = 0; i < sorted.size(); ++i)
        QCOMPARE(sorted[i], std::uint32_t(i));
    const auto cache = tests::readPc2(base + ".pc2");
    QVERIFY(cache.has_value());
    QCOMPARE(cache->frames.size(), std::size_t(original.frameCount()));
    QVERIFY(tests::errorsBetween(tests::framesOf(original), cache->frames, order).largest < 2e-3);
}

void TestEncode::sameInputSameBytes()
{
    SANDREEL_RUN(again, 0, {"encode", path("torus"), "-o", path("again.anim")});
    QVERIFY(!tests::readFile(path("torus.anim")).isEmpty());
    QVERIFY(tests::readFile(path("again.anim")) == tests::readFile(path("torus.anim")));
}

void TestEncode::infoAgreesWithTheFile()
{
    SANDREEL_RUN(encode, 0,
                 {"encode", path("torus"), "-o", path("i.anim"), "--codec", "pca", "--basis", "7", "--resolution",
                  "5000", "--fps", "12", "--name", "Tōrus", "--json"});
    SANDREEL_RUN(info, 0, {"--json", "info", path("i.anim")});
    const QJsonObject json = info.json();
    const double bytes = double(tests::readFile(path("i.anim")).size());
    QCOMPARE(json.value("bytes").toDouble(), bytes);
    QCOMPARE(encode.json().value("bytes").toDouble(), bytes);
    QCOMPARE(json.value("raw_bytes").toDouble(), 12.0 * 96 * 20);
    QCOMPARE(json.value("ratio").toDouble(), 12.0 * 96 * 20 / bytes);
    QCOMPARE(json.value("bpfv").toDouble(), 8 * bytes / (96 * 20));
    QCOMPARE(json.value("vertices").toInt(), 96);
    QCOMPARE(json.value("triangles").toInt(), 192);
    QCOMPARE(json.value("frames").toInt(), 20);
    QCOMPARE(json.value("frame_rate").toDouble(), 12.0);
    QCOMPARE(json.value("duration_seconds").toDouble(), 20 / 12.0);
    QCOMPARE(json.value("basis").toInt(), 7);
    QCOMPARE(json.value("resolution").toDouble(), 5000.0);
    QCOMPARE(json.value("codec").toString(), QStringLiteral("pca"));
    QCOMPARE(json.value("name").toString(), QString::fromUtf8("Tōrus"));
    double chunks = 0;
    const QJsonObject sizes = json.value("chunks").toObject();
    for (const QJsonValue &size : sizes)
        chunks += size.toDouble();
    QVERIFY(chunks > 0.5 * bytes && chunks <= bytes);
    SANDREEL_RUN(text, 0, {"info", path("i.anim")});
    QVERIFY2(text.out.contains("basis 7, resolution 5000") && text.out.contains("20 at 12 per second"),
             text.out.constData());
}

void TestEncode::infoOfFrames()
{
    SANDREEL_RUN(info, 0, {"--json", "info", path("torus")});
    const QJsonObject json = info.json();
    QVERIFY(!json.contains("codec"));
    QCOMPARE(json.value("name").toString(), QStringLiteral("torus"));
    float largest = -100;
    for (const model::Vec3f &p : mTorus->allPositions())
        largest = std::max(largest, p.x);
    QCOMPARE(json.value("box").toObject().value("max").toArray().at(0).toDouble(), double(largest));
}

void TestEncode::measuresWhatWasLost()
{
    SANDREEL_RUN(encode, 0,
                 {"encode", path("torus"), "-o", path("m.anim"), "--codec", "pca", "--basis", "4", "--permutation",
                  path("m.txt"), "--measure", "--json"});
    SANDREEL_RUN(decode, 0, {"decode", path("m.anim"), "-o", path("m.pc2")});
    const auto cache = tests::readPc2(path("m.pc2"));
    QVERIFY(cache.has_value());
    const tests::Errors errors =
        tests::errorsBetween(tests::framesOf(*mTorus), cache->frames, tests::readPermutation(path("m.txt")));
    QVERIFY(errors.kgPercent > 0.1); // noise of full rank on four vectors: there is something to measure
    QCOMPARE(encode.json().value("kg_error_percent").toDouble(), errors.kgPercent);
    QCOMPARE(encode.json().value("rmse").toDouble(), errors.rmse);
    QCOMPARE(encode.json().value("psnr_db").toDouble(), errors.psnr);
    QCOMPARE(encode.json().value("max_vertex_error").toDouble(), errors.largest);
}

void TestEncode::normalisesIntoTheCube_data()
{
    QTest::addColumn<int>("framesInCube"); // 0: left as it was
    QTest::newRow("none") << 0;
    QTest::newRow("first") << 1;
    QTest::newRow("all") << 20;
}

void TestEncode::normalisesIntoTheCube()
{
    QFETCH(const int, framesInCube);
    SANDREEL_RUN(encode, 0,
                 {"encode", path("torus"), "-o", path("n.anim"), "--codec", "pca", "--basis", "100", "--resolution",
                  "1e6", "--normalize", QTest::currentDataTag()});
    SANDREEL_RUN(decode, 0, {"decode", path("n.anim"), "-o", path("n.pc2")});
    auto cache = tests::readPc2(path("n.pc2"));
    QVERIFY(cache.has_value());
    if (framesInCube == 0) {
        QVERIFY(std::abs(tests::diagonalOf(cache->frames) - tests::diagonalOf(tests::framesOf(*mTorus))) < 1e-3);
        return;
    }
    cache->frames.resize(std::size_t(framesInCube));
    float largest = 0;
    for (const auto &frame : cache->frames)
        for (const model::Vec3f &p : frame)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    QVERIFY2(std::abs(largest - 1) < 1e-4, qPrintable(QString::number(double(largest))));
}

void TestEncode::rateAndNameAreKept()
{
    SANDREEL_RUN(first, 0, {"encode", path("torus"), "-o", path("r.anim"), "--fps", "48", "--name", "Wheel"});
    SANDREEL_RUN(again, 0, {"encode", path("r.anim"), "-o", path("r2.anim"), "--codec", "pca", "--basis", "5"});
    SANDREEL_RUN(info, 0, {"--json", "info", path("r2.anim")});
    QCOMPARE(info.json().value("frame_rate").toDouble(), 48.0);
    QCOMPARE(info.json().value("name").toString(), QStringLiteral("Wheel"));
}

void TestEncode::anAnimWithTheSameSettingsKeepsItsStream()
{
    SANDREEL_RUN(rated, 0,
                 {"encode", path("torus.anim"), "-o", path("k.anim"), "--fps", "12", "--permutation", path("k.txt"),
                  "--measure", "--json"});
    QCOMPARE(rated.json().value("max_vertex_error").toDouble(), 0.0);
    QVERIFY(rated.json().value("psnr_db").isNull());
    const auto order = tests::readPermutation(path("k.txt"));
    QVERIFY(std::ranges::is_sorted(order) && order.size() == 96);
    SANDREEL_RUN(back, 0, {"encode", path("k.anim"), "-o", path("k2.anim"), "--fps", "25"});
    QVERIFY(tests::readFile(path("k2.anim")) == tests::readFile(path("torus.anim")));
}

void TestEncode::moreBasisIsMoreExact()
{
    double before = 1000;
    for (const char *basis : {"1", "10", "60"}) {
        SANDREEL_RUN(
            run, 0,
            {"encode", path("torus"), "-o", path("b.anim"), "--codec", "pca", "--basis", basis, "--measure", "--json"});
        const double error = run.json().value("kg_error_percent").toDouble();
        QVERIFY(error < before);
        before = error;
    }
    QVERIFY(before < 0.05);
}

void TestEncode::outputThatCannotBeWritten_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("missing folder") << QStringList{"-o", path("missing/x.anim")};
    QTest::newRow("read-only file system") << QStringList{"-o", "/proc/x.anim"};
    QTest::newRow("permutation into a missing folder")
        << QStringList{"-o", path("x.anim"), "--permutation", path("missing/x.txt")};
    QTest::newRow("permutation into a device") << QStringList{"-o", path("x.anim"), "--permutation", "/dev/null"};
    QTest::newRow("permutation into a folder") << QStringList{"-o", path("x.anim"), "--permutation", path("folder")};
    QTest::newRow("permutation into a read-only file system")
        << QStringList{"-o", path("x.anim"), "--permutation", "/proc/x.txt"};
}

void TestEncode::outputThatCannotBeWritten()
{
    QFETCH(const QStringList, arguments);
    const QStringList before = tests::contentsOf(mFolder.path());
    SANDREEL_RUN(run, 4, QStringList{"encode", path("torus")} + arguments);
    QVERIFY2(run.err.contains(arguments.last().toUtf8()), run.err.constData());
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
}

void TestEncode::failedOutputLeavesTheOldFile()
{
    tests::writeFile(path("old.anim"), "precious");
    tests::writeObjFolder(path("bad"), *tests::oneFrame(tests::cube()));
    tests::writeFile(path("bad/frame_1.obj"), "v 1 2\n");
    SANDREEL_RUN(run, 3, {"encode", path("bad"), "-o", path("old.anim")});
    QCOMPARE(tests::readFile(path("old.anim")), QByteArray("precious"));
}

void TestEncode::directIsEncoded()
{
    SANDREEL_RUN(run, 0,
                 {"encode", path("torus"), "-o", path("direct.anim"), "--codec", "direct", "--resolution", "1000",
                  "--predictor", "b", "--entropy", "deflate", "--measure", "--json"});
    SANDREEL_RUN(info, 0, {"--json", "info", path("direct.anim")});
    const QJsonObject box = info.json().value("box").toObject();
    double longest = 0;
    for (int axis = 0; axis < 3; ++axis)
        longest = std::max(longest,
                           box.value("max").toArray()[axis].toDouble() - box.value("min").toArray()[axis].toDouble());
    const double halfDiagonal = longest / 1000 * std::sqrt(3.0) / 2;
    const double largest = run.json().value("max_vertex_error").toDouble();
    QVERIFY2(largest > halfDiagonal / 2 && largest < 1.01 * halfDiagonal, qPrintable(QString::number(largest)));
    QCOMPARE(info.json().value("codec").toString(), QString("direct"));
    QCOMPARE(info.json().value("resolution").toInt(), 1000);
    QCOMPARE(info.json().value("predictor").toString(), QString("B"));
    QCOMPARE(info.json().value("entropy").toString(), QString("deflate"));
    QVERIFY(!info.json().contains("basis"));
    SANDREEL_RUN(text, 0, {"info", path("direct.anim")});
    QVERIFY2(text.out.contains("direct, resolution 1000, predictor B, entropy deflate"), text.out.constData());
}

void TestEncode::targetsAreMet_data()
{
    QTest::addColumn<QStringList>("target");
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("most");
    for (const char *codec : {"direct", "pca"}) {
        const auto row = [codec](const char *option, const char *value, const char *key, double most) {
            QTest::addRow("%s %s", codec, option) << QStringList{"--codec", codec, option, value} << key << most;
        };
        row("--quality", "0.5", "kg_error_percent", 0.7072);
        row("--max-kg-error", "2", "kg_error_percent", 2);
        row("--max-vertex-error", "0.01", "max_vertex_error", 0.0745); // the diagonal is 7.45
        row("--max-bytes", "4000", "bytes", 4000);
    }
}

void TestEncode::targetsAreMet()
{
    QFETCH(const QStringList, target);
    QFETCH(const QString, key);
    QFETCH(const double, most);
    SANDREEL_RUN(run, 0,
                 QStringList{"encode", path("torus"), "-o", path("target.anim"), "--measure", "--json"} + target);
    const double reached = run.json().value(key).toDouble();
    QVERIFY2(reached > 0.5 * most && reached <= most, qPrintable(QString::number(reached)));
    QVERIFY(run.json().value("settings").toString().startsWith(target[1]));
}

SANDREEL_TEST(TestEncode)
#include "tst_encode.moc"
