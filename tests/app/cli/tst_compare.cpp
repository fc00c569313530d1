// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/hausdorff.h"
#include "model/animation/metrics.h"
#include "model/animation/sted.h"
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>

class TestCompare : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void figuresAreThoseOfTheDefinition();
    void permutationOfEncodeIsTaken();
    void verticesMayComeInAnotherOrder();
    void equalAnimationsHaveNoError();
    void normalisesTheReference();
    void csvHoldsTheFrames();
    void everyMetricIsPrinted();
    void onlyTheMetricsWanted_data();
    void onlyTheMetricsWanted();
    void badMetricsAreRefused();
    void differentMeshesAreRefused();
    void badPermutations_data();
    void badPermutations();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
    tests::Frames mReference, mTest;
};

void TestCompare::initTestCase()
{
    const auto reference = tests::wave(tests::torus(), 6);
    const auto test = tests::noise(tests::torus(), 6);
    tests::writeObjFolder(path("reference"), *reference);
    tests::writeObjFolder(path("test"), *test);
    mReference = tests::framesOf(*reference);
    mTest = tests::framesOf(*test);
}

void TestCompare::figuresAreThoseOfTheDefinition()
{
    SANDREEL_RUN(run, 0, {"--json", "compare", path("reference"), path("test")});
    const QJsonObject json = run.json();
    const tests::Errors whole = tests::errorsBetween(mReference, mTest, {});
    QCOMPARE(json.value("kg_error_percent").toDouble(), whole.kgPercent);
    QCOMPARE(json.value("rmse").toDouble(), whole.rmse);
    QCOMPARE(json.value("psnr_db").toDouble(), whole.psnr);
    QCOMPARE(json.value("max_vertex_error").toDouble(), whole.largest);

    const QJsonArray frames = json.value("frames").toArray();
    QCOMPARE(frames.size(), 6);
    double largest = 0;
    int worstFrame = 0;
    for (int i = 0; i < 6; ++i) {
        const QJsonObject frame = frames[i].toObject();
        const std::size_t f = std::size_t(i);
        const tests::Errors one = tests::errorsBetween({mReference[f]}, {mTest[f]}, {}, tests::diagonalOf(mReference));
        QCOMPARE(frame.value("frame").toInt(), i + 1);
        QCOMPARE(frame.value("kg_error_percent").toDouble(), one.kgPercent);
        QCOMPARE(frame.value("rmse").toDouble(), one.rmse);
        QCOMPARE(frame.value("psnr_db").toDouble(), one.psnr);
        QCOMPARE(frame.value("max_vertex_error").toDouble(), one.largest);
        const auto vertex = std::size_t(frame.value("worst_vertex").toInt());
        QCOMPARE(length(mReference[f][vertex] - mTest[f][vertex]), float(one.largest));
        if (one.largest > largest) {
            largest = one.largest;
            worstFrame = i + 1;
        }
    }
    QCOMPARE(json.value("worst_frame").toInt(), worstFrame);
}

void TestCompare::permutationOfEncodeIsTaken()
{
    SANDREEL_RUN(encode, 0,
                 {"encode", path("test"), "-o", path("p.anim"), "--codec", "pca", "--basis", "3", "--permutation",
                  path("p.txt")});
    SANDREEL_RUN(decode, 0, {"decode", path("p.anim"), "-o", path("p.pc2")});
    const auto cache = tests::readPc2(path("p.pc2"));
    QVERIFY(cache.has_value());
    const tests::Errors errors = tests::errorsBetween(mTest, cache->frames, tests::readPermutation(path("p.txt")));
    SANDREEL_RUN(run, 0, {"--json", "compare", path("test"), path("p.anim"), "--permutation", path("p.txt")});
    QCOMPARE(run.json().value("kg_error_percent").toDouble(), errors.kgPercent);
    QCOMPARE(run.json().value("max_vertex_error").toDouble(), errors.largest);

    // As an editor on another system may leave the file.
    QByteArray text = tests::readFile(path("p.txt"));
    tests::writeFile(path("crlf.txt"), text.replace("\n", "\r\n").chopped(2));
    SANDREEL_RUN(crlf, 0, {"--json", "compare", path("test"), path("p.anim"), "--permutation", path("crlf.txt")});
    QCOMPARE(crlf.out, run.out);
}

void TestCompare::verticesMayComeInAnotherOrder()
{
    const auto original = tests::noise(tests::torus(), 6);
    std::vector<model::Vec3f> positions;
    QByteArray order;
    for (std::uint32_t i = 0; i < 6 * 96; ++i) {
        const std::uint32_t vertex = (5 * i + 3) % 96;
        positions.push_back(original->frameView(i / 96)[vertex]);
        if (i < 96)
            order += QByteArray::number(vertex) + '\n';
    }
    tests::writeObjFolder(path("shuffled"), model::Sequence({96, {}}, std::move(positions)));
    tests::writeFile(path("order.txt"), order);
    SANDREEL_RUN(jumble, 0, {"--json", "compare", path("test"), path("shuffled")});
    QVERIFY(jumble.json().value("kg_error_percent").toDouble() > 50);
    SANDREEL_RUN(sorted, 0, {"--json", "compare", path("test"), path("shuffled"), "--permutation", path("order.txt")});
    QCOMPARE(sorted.json().value("max_vertex_error").toDouble(-1), 0.0);
}

void TestCompare::equalAnimationsHaveNoError()
{
    SANDREEL_RUN(run, 0, {"--json", "compare", path("test"), path("test")});
    const QJsonObject json = run.json();
    QCOMPARE(json.value("kg_error_percent").toDouble(-1), 0.0);
    QCOMPARE(json.value("rmse").toDouble(-1), 0.0);
    QCOMPARE(json.value("max_vertex_error").toDouble(-1), 0.0);
    QVERIFY(json.contains("psnr_db") && json.value("psnr_db").isNull());
    const QJsonObject frame = json.value("frames").toArray().at(5).toObject();
    QVERIFY(frame.contains("psnr_db") && frame.value("psnr_db").isNull());
    SANDREEL_RUN(text, 0, {"compare", path("test"), path("test")});
    QVERIFY2(text.out.contains("infinite") && !text.out.contains("inf dB"), text.out.constData());
}

void TestCompare::normalisesTheReference()
{
    SANDREEL_RUN(encode, 0,
                 {"encode", path("test"), "-o", path("n.anim"), "--normalize", "all", "--codec", "pca", "--basis",
                  "100", "--permutation", path("n.txt")});
    const QStringList arguments{"--json", "compare", path("test"), path("n.anim"), "--permutation", path("n.txt")};
    SANDREEL_RUN(apart, 0, arguments);
    QVERIFY(apart.json().value("kg_error_percent").toDouble() > 10);
    SANDREEL_RUN(alike, 0, arguments + QStringList{"--normalize", "all"});
    QVERIFY(alike.json().value("kg_error_percent").toDouble() < 0.1);
}

void TestCompare::csvHoldsTheFrames()
{
    SANDREEL_RUN(run, 0, {"--json", "compare", path("reference"), path("test"), "--csv", path("frames.csv")});
    const QList<QByteArray> lines = tests::readFile(path("frames.csv")).trimmed().split('\n');
    QCOMPARE(lines.size(), 7);
    QCOMPARE(lines[0], QByteArray("frame,kg_error_percent,rmse,max_vertex_error,worst_vertex,da_error,sted_spatial,"
                                  "sted_temporal,hausdorff"));
    const QJsonArray frames = run.json().value("frames").toArray();
    for (int i = 1; i < 7; ++i) {
        const QList<QByteArray> cells = lines[i].split(',');
        QCOMPARE(cells.size(), 9);
        const QJsonObject frame = frames[i - 1].toObject();
        QCOMPARE(cells[0].toInt(), i);
        QCOMPARE(cells[1].toDouble(), frame.value("kg_error_percent").toDouble());
        QCOMPARE(cells[3].toDouble(), frame.value("max_vertex_error").toDouble());
        QCOMPARE(cells[4].toInt(), frame.value("worst_vertex").toInt());
        QCOMPARE(cells[5].toDouble(), frame.value("da_error").toDouble());
        QCOMPARE(cells[6].toDouble(), frame.value("sted_spatial").toDouble());
        QCOMPARE(cells[7].toDouble(), frame.value("sted_temporal").toDouble());
        QCOMPARE(cells[7].isEmpty(), i == 1); // no step leads to the first frame
        QCOMPARE(cells[8].toDouble(), frame.value("hausdorff").toDouble());
    }
    SANDREEL_RUN(full, 4, {"compare", path("reference"), path("test"), "--csv", path("missing/frames.csv")});
    QCOMPARE(full.out, QByteArray());
}

/// As the model measures the same files.
void TestCompare::everyMetricIsPrinted()
{
    const auto reference = tests::wave(tests::torus(), 6), test = tests::noise(tests::torus(), 6);
    const model::StedResult sted = *model::spatioTemporalDifference(*reference, *test);
    const model::HausdorffResult hausdorff = *model::hausdorffDistance(*reference, *test);
    SANDREEL_RUN(run, 0, {"--json", "compare", path("reference"), path("test")});
    const QJsonObject json = run.json();
    const auto near = [](const QJsonObject &object, const char *key, double expected) {
        return std::abs(object.value(QLatin1String(key)).toDouble(-1) - expected) <= 1e-12 * expected;
    };
    QVERIFY(near(json, "da_error", model::compareAnimations(*reference, *test)->daError));
    QVERIFY(near(json, "sted", sted.sted));
    QVERIFY(near(json, "sted_spatial", sted.spatial));
    QVERIFY(near(json, "sted_temporal", sted.temporal));
    QVERIFY(near(json, "hausdorff", hausdorff.distance));
    QVERIFY(near(json, "hausdorff_from_reference", hausdorff.fromReference));
    QVERIFY(near(json, "hausdorff_from_test", hausdorff.fromTest));
    QCOMPARE(json.value("hausdorff_worst_frame").toInt(), int(hausdorff.worstFrame) + 1);
    const QJsonArray frames = json.value("frames").toArray();
    for (int i = 0; i < 6; ++i) {
        const QJsonObject frame = frames[i].toObject();
        const auto f = std::size_t(i);
        QVERIFY(near(frame, "sted_spatial", sted.frames[f].spatial));
        QVERIFY(near(frame, "hausdorff", hausdorff.frames[f].distance()));
        QVERIFY(frame.contains("sted_temporal"));
        if (i == 0)
            QVERIFY(frame.value("sted_temporal").isNull());
        else
            QVERIFY(near(frame, "sted_temporal", sted.frames[f].temporal));
    }
    SANDREEL_RUN(text, 0, {"compare", path("reference"), path("test")});
    for (const char *name : {"KG error", "DA error", "STED", "RMSE", "PSNR", "largest vertex error", "Hausdorff"})
        QVERIFY2(text.out.contains(name), name);
    SANDREEL_RUN(
        dense, 0,
        {"--json", "compare", path("reference"), path("test"), "--surface-samples", "0", "--metrics", "hausdorff"});
    QVERIFY(near(dense.json(), "hausdorff", model::hausdorffDistance(*reference, *test, {}, 0)->distance));
}

void TestCompare::onlyTheMetricsWanted_data()
{
    QTest::addColumn<QString>("metrics");
    QTest::addColumn<bool>("sted");
    QTest::addColumn<bool>("hausdorff");
    QTest::newRow("kg") << "kg" << false << false;
    QTest::newRow("sted") << "sted" << true << false;
    QTest::newRow("hausdorff") << "hausdorff" << false << true;
    QTest::newRow("several, in capitals") << "KG,STED,Hausdorff" << true << true;
}

void TestCompare::onlyTheMetricsWanted()
{
    QFETCH(const QString, metrics);
    QFETCH(const bool, sted);
    QFETCH(const bool, hausdorff);
    SANDREEL_RUN(run, 0,
                 {"--json", "compare", path("reference"), path("test"), "--metrics", metrics, "--csv", path("m.csv")});
    const QJsonObject json = run.json();
    const QByteArray header = tests::readFile(path("m.csv")).split('\n').first();
    QVERIFY(json.contains("kg_error_percent") && header.contains("kg_error_percent"));
    for (const char *key : {"sted", "sted_spatial", "sted_temporal"})
        QCOMPARE(json.contains(QLatin1String(key)), sted);
    QCOMPARE(json.contains("hausdorff"), hausdorff);
    QCOMPARE(header.contains("sted_spatial"), sted);
    QCOMPARE(header.contains("hausdorff"), hausdorff);
    const QJsonObject frame = json.value("frames").toArray().at(2).toObject();
    QCOMPARE(frame.contains("sted_temporal"), sted);
    QCOMPARE(frame.contains("hausdorff"), hausdorff);
    SANDREEL_RUN(text, 0, {"compare", path("reference"), path("test"), "--metrics", metrics});
    QCOMPARE(text.out.contains("STED"), sted);
    QCOMPARE(text.out.contains("Hausdorff"), hausdorff);
}

void TestCompare::badMetricsAreRefused()
{
    SANDREEL_RUN(name, 2, {"compare", path("reference"), path("test"), "--metrics", "kg,nonsense"});
    QVERIFY2(name.err.contains("nonsense"), name.err.constData());
    for (const char *samples : {"-1", "nan", "1e9", "many"}) {
        SANDREEL_RUN(number, 2, {"compare", path("reference"), path("test"), "--surface-samples", samples});
    }
}

void TestCompare::differentMeshesAreRefused()
{
    tests::writeObjFolder(path("fewer"), *tests::wave(tests::torus(), 5));
    tests::writeObjFolder(path("other"), *tests::wave(tests::cube(), 6));
    SANDREEL_RUN(frames, 3, {"compare", path("reference"), path("fewer")});
    QVERIFY2(frames.err.contains("frames is 6 in one and 5"), frames.err.constData());
    SANDREEL_RUN(vertices, 3, {"compare", path("reference"), path("other")});
    QVERIFY2(vertices.err.contains("vertices is 96 in one and 8"), vertices.err.constData());
}

void TestCompare::badPermutations_data()
{
    QByteArray identity;
    for (int i = 0; i < 96; ++i)
        identity += QByteArray::number(i) + '\n';
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");
    QTest::newRow("empty") << QByteArray() << "empty";
    QTest::newRow("word") << identity + "x\n"
                          << "line 97";
    QTest::newRow("negative") << "-1\n" + identity << "line 1";
    QTest::newRow("two numbers in a line") << "1 2\n" + identity << "line 1";
    QTest::newRow("too short") << identity.chopped(3) << "95 entries for 96";
    QTest::newRow("too long") << identity + "96\n"
                              << "97 entries for 96";
    QTest::newRow("out of range") << identity.chopped(3) + "96\n"
                                  << "vertex 96 of 96";
    QTest::newRow("twice") << identity.chopped(3) + "7\n"
                           << "vertex 7 twice";
    QTest::newRow("beyond 32 bits") << identity.chopped(3) + "4294967297\n"
                                    << "line 96";
}

void TestCompare::badPermutations()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QString, words);
    tests::writeFile(path("bad.txt"), text);
    SANDREEL_RUN(run, 3, {"compare", path("reference"), path("test"), "--permutation", path("bad.txt")});
    QVERIFY2(run.err.contains(words.toUtf8()) && run.err.contains("bad.txt"), run.err.constData());
    QCOMPARE(run.out, QByteArray());
}

SANDREEL_TEST(TestCompare)
#include "tst_compare.moc"
