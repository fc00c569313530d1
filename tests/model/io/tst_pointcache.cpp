// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/pointcache.h"

#include "model/io/animationreader.h"
#include "model/io/animationwriter.h"
#include "tests/model/io/iotest.h"
#include "tests/support/testmain.h"

#include <QDir>

using namespace model;
using namespace model::io;
using tests::contents;
using tests::put;
using tests::WavyFrames;

namespace {

QByteArray bigEndian(std::uint32_t value)
{
    QByteArray bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += char(value >> shift);
    return bytes;
}

QByteArray bigEndian(float value)
{
    return bigEndian(std::bit_cast<std::uint32_t>(value));
}

QByteArray mdd(const FrameSource &source, double rate)
{
    QByteArray bytes = bigEndian(source.frameCount()) + bigEndian(source.vertexCount());
    for (std::uint32_t frame = 0; frame < source.frameCount(); ++frame)
        bytes += bigEndian(float(frame / rate));
    for (std::uint32_t frame = 0; frame < source.frameCount(); ++frame)
        for (const Vec3f &p : source.frame(frame))
            bytes += bigEndian(p.x) + bigEndian(p.y) + bigEndian(p.z);
    return bytes;
}

} // namespace

class TestPointCache final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void init()
    {
        makeFolder();
        QVERIFY(writeMesh(path("walk.obj"), mFrames.frame(0), mFrames.connectivity(), MeshFormat::Obj).has_value());
        QVERIFY(writePc2(path("walk.pc2"), mFrames).has_value());
        put(path("walk.mdd"), mdd(mFrames, 24));
    }

    void comesBackBitForBit()
    {
        for (const char *const name : {"walk.pc2", "walk.mdd"}) {
            double last = 0;
            const auto read = readAnimation(path(name), {}, Progress([&](double fraction) { last = fraction; }));
            QVERIFY(read.has_value());
            QCOMPARE(last, 1.0);
            QCOMPARE((*read)->frameCount(), 7u);
            QCOMPARE((*read)->name(), std::string("walk"));
            QVERIFY((*read)->connectivity() == mFrames.connectivity());
            for (std::uint32_t frame = 0; frame < 7; ++frame)
                QVERIFY((*read)->frame(frame) == mFrames.frame(frame));
        }
    }

    void rateComesFromTheTimes_data()
    {
        QTest::addColumn<double>("rate");
        for (const double rate : {24.0, 25.0, 30.0, 60.0, 23.976, 12.5, 1.0})
            QTest::newRow(qPrintable(QString::number(rate))) << rate;
    }
    void rateComesFromTheTimes()
    {
        QFETCH(double, rate);
        put(path("walk.mdd"), mdd(mFrames, rate));
        QCOMPARE((*readAnimation(path("walk.mdd")))->frameRate(), rate);
        QCOMPARE((*readAnimation(path("walk.mdd"), {{}, 48, 0}))->frameRate(), 48.0);
        QCOMPARE((*readAnimation(path("walk.pc2")))->frameRate(), 25.0);
    }

    void uselessTimesAreIgnored()
    {
        for (const double rate : {1e300, -25.0}) {
            put(path("walk.mdd"), mdd(mFrames, rate));
            QCOMPARE((*readAnimation(path("walk.mdd")))->frameRate(), 25.0);
        }
    }

    void baseMeshIsChosenOrFound()
    {
        QVERIFY(QFile::rename(path("walk.obj"), path("other.obj")));
        const auto without = readAnimation(path("walk.pc2"));
        SANDREEL_COMPARE_ERROR(without, ErrorCode::MissingBaseMesh);
        QCOMPARE(without.error().file, path("walk.pc2").toStdString());
        QVERIFY(readAnimation(path("walk.pc2"), {path("other.obj"), 0, 0}).has_value());
        QVERIFY(QFile::rename(path("other.obj"), path("walk.OBJ")));
        QVERIFY(readAnimation(path("walk.pc2")).has_value());
        SANDREEL_COMPARE_ERROR(readAnimation(path("walk.pc2"), {path("none.obj"), 0, 0}), ErrorCode::NotFound);
        put(path("bad.obj"), "v 1 2\n");
        QCOMPARE(readAnimation(path("walk.pc2"), {path("bad.obj"), 0, 0}).error().file, path("bad.obj").toStdString());
    }

    void otherBaseMeshIsRefused()
    {
        put(path("walk.obj"), "v 0 0 0\nv 1 0 0\n");
        for (const char *const name : {"walk.pc2", "walk.mdd"}) {
            const auto read = readAnimation(path(name));
            SANDREEL_COMPARE_ERROR(read, ErrorCode::VertexCountDiffers);
            QCOMPARE(read.error().file, path(name).toStdString());
            QCOMPARE(tests::argsOf(read.error()), QStringList({"20", "2", path("walk.obj")}));
        }
    }

    void everyShorterFileIsTruncated()
    {
        for (const char *const name : {"walk.pc2", "walk.mdd"}) {
            const QByteArray whole = contents(path(name));
            for (qsizetype length = 0; length < whole.size(); length += length < 64 ? 1 : 97) {
                put(path(name), whole.left(length));
                const auto read = readAnimation(path(name));
                SANDREEL_COMPARE_ERROR(read, ErrorCode::Truncated);
                QCOMPARE(read.error().offset, std::uint64_t(length));
                QCOMPARE(read.error().args.at(1), std::to_string(length));
            }
        }
    }

    void longerFileIsRefused()
    {
        for (const char *const name : {"walk.pc2", "walk.mdd"}) {
            const QByteArray whole = contents(path(name));
            put(path(name), whole + "abc");
            const auto read = readAnimation(path(name));
            SANDREEL_COMPARE_ERROR(read, ErrorCode::TrailingBytes);
            QCOMPARE(read.error().offset, std::uint64_t(whole.size()));
            QCOMPARE(tests::argsOf(read.error()), QStringList("3"));
        }
    }

    void badHeaders_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("at");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("offset");
        const auto row = [](const char *what, const char *name, int at, const QByteArray &bytes, ErrorCode code,
                            int offset) { QTest::newRow(what) << QString(name) << at << bytes << int(code) << offset; };
        const QByteArray zero(4, '\0'), huge = "\xff\xff\xff\x7f", negative = "\xff\xff\xff\xff";
        const QByteArray hugeBig = "\x7f\xff\xff\xff";
        row("magic", "walk.pc2", 3, "X", ErrorCode::BadMagic, 0);
        row("version", "walk.pc2", 12, "\2", ErrorCode::UnsupportedVersion, 12);
        row("no points", "walk.pc2", 16, zero, ErrorCode::BadValue, 16);
        row("negative points", "walk.pc2", 16, negative, ErrorCode::BadValue, 16);
        row("no samples", "walk.pc2", 28, zero, ErrorCode::BadValue, 28);
        row("huge counts", "walk.pc2", 16, huge + QByteArray(8, '\0') + huge, ErrorCode::Truncated, 32 + 7 * 240);
        row("MDD: no frames", "walk.mdd", 0, zero, ErrorCode::BadValue, 0);
        row("MDD: no points", "walk.mdd", 4, zero, ErrorCode::BadValue, 4);
        row("MDD: negative points", "walk.mdd", 4, negative, ErrorCode::BadValue, 4);
        row("MDD: huge counts", "walk.mdd", 0, hugeBig + hugeBig, ErrorCode::Truncated, 8 + 7 * 244);
        row("infinite", "walk.pc2", 32 + 240 + 12 * 5 + 4, QByteArray("\0\0\x80\x7f", 4), ErrorCode::NonFinite,
            32 + 240 + 12 * 5);
        row("MDD: nan", "walk.mdd", 8 + 28 + 12 * 3, QByteArray("\x7f\xc0\0\0", 4), ErrorCode::NonFinite,
            8 + 28 + 12 * 3);
    }
    void badHeaders()
    {
        QFETCH(QString, name);
        QFETCH(int, at);
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QFETCH(int, offset);
        put(path(name), contents(path(name)).replace(at, bytes.size(), bytes));
        const auto read = readAnimation(path(name));
        SANDREEL_COMPARE_ERROR(read, code);
        QCOMPARE(read.error().file, path(name).toStdString());
        QCOMPARE(read.error().offset, std::uint64_t(offset));
    }

    void cancelStops()
    {
        Progress progress([&](double fraction) {
            if (fraction > 0.3)
                progress.cancel();
        });
        SANDREEL_COMPARE_ERROR(readAnimation(path("walk.mdd"), {}, progress), ErrorCode::Cancelled);
    }

private:
    const WavyFrames mFrames{20, 7};
};

SANDREEL_TEST(TestPointCache)
#include "tst_pointcache.moc"
