// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/container/container.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/plain/plaindecoder.h"
#include "tests/support/rows.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <QFile>
#include <QRegularExpression>

#include <cmath>

using namespace model;
using namespace model::codec;

namespace {

QString readText(const char *path)
{
    QFile file(QStringLiteral(SANDREEL_SOURCE "/") + QLatin1String(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The lines between ```name and ```.
QStringList fenced(const QString &document, const QString &name)
{
    const QStringList parts = document.split("```" + name + "\n");
    return parts.size() < 2 ? QStringList() : parts[1].split("```")[0].split('\n', Qt::SkipEmptyParts);
}

Bytes exampleOf(const QString &document, const QString &name)
{
    QByteArray hex;
    for (const QString &line : fenced(document, name))
        hex += line.section('#', 0, 0).toLatin1();
    const QByteArray raw = QByteArray::fromHex(hex);
    return {raw.begin(), raw.end()};
}

std::vector<double> numbersOf(const QStringList &lines)
{
    std::vector<double> numbers;
    for (const QString &line : lines)
        for (const QString &number : line.split(QRegularExpression("[ ,]+"), Qt::SkipEmptyParts))
            numbers.push_back(number.toDouble());
    return numbers;
}

void compareWithPlainDecoder(const Bytes &file)
{
    const auto product = decodeAnimation(file);
    QVERIFY(product.has_value());
    const DecodedAnimation &a = **product;
    const tests::PlainAnim b = tests::decodePlainly(file);
    QCOMPARE(b.error, std::string());
    QCOMPARE(std::uint64_t(a.vertexCount()), b.vertices);
    QCOMPARE(std::uint64_t(a.frameCount()), b.frames);
    QCOMPARE(std::uint64_t(a.basisSize()), b.rank);
    QCOMPARE(std::uint64_t(std::get<PcaSettings>(a.settings().method).basisSize), b.wanted);
    QCOMPARE(std::get<PcaSettings>(a.settings().method).resolution, b.resolution);
    QCOMPARE(a.frameRate(), b.rate);
    QCOMPARE(a.name(), b.name);
    QCOMPARE(a.creator(), b.creator);
    QCOMPARE(std::uint64_t(a.connectivity().triangles.size()), b.triangleCount);
    for (std::size_t t = 0; t < b.triangleCount; ++t)
        for (std::size_t c = 0; c < 3; ++c)
            QCOMPARE(qint64(a.connectivity().triangles[t][c]), qint64(b.triangles[t][c]));
    for (std::uint32_t f = 0; f < a.frameCount(); ++f) {
        const auto frame = a.frame(f);
        for (std::uint32_t v = 0; v < a.vertexCount(); ++v) {
            const float p[3] = {frame[v].x, frame[v].y, frame[v].z};
            for (unsigned axis = 0; axis < 3; ++axis) {
                const double expected = b.coordinate(f, v, axis);
                double size = std::fabs(double(b.means[3 * f + axis]) / b.resolution);
                for (std::size_t k = 0; k < b.rank; ++k)
                    size += std::fabs(double(b.basis[k][3 * f + axis]) / b.resolution *
                                      (double(b.coefficients[k][v]) / b.resolution));
                QVERIFY(std::fabs(double(p[axis]) - expected) <= std::ldexp(size, -20));
            }
        }
    }
}

} // namespace

class TestFormatDoc final : public QObject
{
    Q_OBJECT

private slots:
    void versionIsThatOfTheCode()
    {
        const QString document = readText("model/codec/FORMAT.md");
        const QString version = QStringLiteral("%1.%2").arg(FormatMajor).arg(FormatMinor);
        QVERIFY(document.contains("Format version **" + version + "**"));
        const QString table = document.section("## 2.", 0, 0);
        const auto rows =
            QRegularExpression("^\\| (\\d+\\.\\d+) \\|", QRegularExpression::MultilineOption).globalMatch(table);
        QString last;
        for (auto it = rows; it.hasNext();)
            last = it.next().captured(1);
        QCOMPARE(last, version);
    }

    void workedExampleDecodes_data()
    {
        QTest::addColumn<QString>("hex");
        QTest::addColumn<QString>("positions");
        QTest::newRow("pca") << "hex"
                             << "positions";
        QTest::newRow("direct") << "direct-hex"
                                << "direct-positions";
        QTest::newRow("reel") << "reel-hex"
                              << "reel-positions";
        QTest::newRow("coddyac") << "coddyac-hex"
                                 << "coddyac-positions";
    }
    void workedExampleDecodes()
    {
        QFETCH(QString, hex);
        QFETCH(QString, positions);
        const QString document = readText("model/codec/FORMAT.md");
        const Bytes file = exampleOf(document, hex);
        QVERIFY(!file.empty());
        const auto decoded = decodeAnimation(file);
        QVERIFY2(decoded.has_value(), decoded ? "" : decoded.error().args.at(0).c_str());
        const auto expected = numbersOf(fenced(document, positions));
        std::vector<double> found;
        for (std::uint32_t f = 0; f < (*decoded)->frameCount(); ++f)
            for (const Vec3f p : (*decoded)->frame(f))
                for (const float x : {p.x, p.y, p.z})
                    found.push_back(double(x));
        QCOMPARE(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            QVERIFY2(std::fabs(found[i] - expected[i]) < 1e-5,
                     qPrintable(QString("%1: %2, not %3").arg(i).arg(found[i]).arg(expected[i])));
        if ((*decoded)->settings().codec() == CodecId::Pca)
            compareWithPlainDecoder(file);
    }

    void workedExampleOfConnectivityDecodes()
    {
        const QString document = readText("model/codec/FORMAT.md");
        const Bytes stream = exampleOf(document, "clrs-hex");
        const std::vector<double> expected = numbersOf(fenced(document, "clrs-triangles"));
        QVERIFY(!stream.empty());
        QCOMPARE(expected.size(), std::size_t(8 * 3));
        Chunk chunk;
        chunk.payload = stream;
        const auto decoded = decodeConnectivity(chunk, 6, 8, std::uint64_t(1) << 20, Progress());
        QVERIFY(decoded.has_value());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(int(decoded->connectivity.triangles[i / 3][i % 3]), int(expected[i]));
    }

    void plainDecoderAgrees_data()
    {
        tests::addRows(tests::animationTable());
        QTest::newRow("several streams") << -1;
    }
    void plainDecoderAgrees()
    {
        QFETCH(int, row);
        const auto source = row >= 0 ? *tests::animationTable()[std::size_t(row)].animation : tests::waves(4, 40000, 9);
        for (const double resolution : {30.0, 1e4, 1e6}) {
            const CompressionSettings settings{PcaSettings{9, resolution}};
            compareWithPlainDecoder(encodeAnimation(source, settings)->bytes);
            if (row < 0)
                return;
        }
    }

    // Files of released versions: they must decode for ever, to what they decoded to then.
    void goldenFilesDecode_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("1.0") << "wave-1.0";
        QTest::newRow("direct 1.0") << "direct-1.0";
        QTest::newRow("direct, deflate 1.0") << "direct-deflate-1.0";
        QTest::newRow("coddyac 1.0") << "wave-coddyac-1.0";
        QTest::newRow("coddyac, in order 1.0") << "wave-coddyac-ordered-1.0";
    }
    void goldenFilesDecode()
    {
        QFETCH(QString, name);
        QFile file(QStringLiteral(SANDREEL_SOURCE "/tests/data/anim/") + name + ".anim");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray raw = file.readAll();
        const auto decoded = decodeAnimation(Bytes(raw.begin(), raw.end()));
        QVERIFY(decoded.has_value());
        const auto expected =
            numbersOf(readText(qPrintable("tests/data/anim/" + name + ".txt")).split('\n', Qt::SkipEmptyParts));
        QVERIFY(!expected.empty());
        std::size_t i = 0;
        for (std::uint32_t f = 0; f < (*decoded)->frameCount(); ++f)
            for (const Vec3f p : (*decoded)->frame(f))
                for (const float x : {p.x, p.y, p.z})
                    QVERIFY(std::fabs(double(x) - expected.at(i++)) < 1e-5);
        QCOMPARE(i, expected.size());
        if (name == "wave-coddyac-1.0") { // in the coder's order
            QCOMPARE((*decoded)->connectivity().triangles.size(), tests::strip((*decoded)->vertexCount()).size());
        } else {
            QVERIFY(tests::canonical((*decoded)->connectivity().triangles) ==
                    tests::canonical(tests::strip((*decoded)->vertexCount())));
        }
        QCOMPARE((*decoded)->name(), std::string("plain"));
    }
};

SANDREEL_TEST(TestFormatDoc)
#include "tst_formatdoc.moc"
