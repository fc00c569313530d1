// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/scarcity.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>

#include <cmath>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

const QString DataFolder = QStringLiteral(SANDREEL_SOURCE "/tests/data/");

Bytes readFile(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray raw = file.readAll();
    return {raw.begin(), raw.end()};
}

QStringList filesIn(const QString &folder)
{
    return QDir(DataFolder + folder).entryList({"*.anim"}, QDir::Files, QDir::Name);
}

/// What any bytes must lead to: a named error with its place, or positions that are finite; and no more memory than
/// the caller allows. \returns what is wrong, or nothing
QString complaintAbout(const Bytes &file, const DecodeLimits &limits = DecodeLimits())
{
    tests::AllocationMeter meter;
    QString complaint;
    const auto decoded = decodeAnimation(Bytes(file), Progress(), limits);
    if (!decoded) {
        const Error &error = decoded.error();
        if (error.offset == Error::None || error.offset > file.size())
            complaint = QString("error %1 has no place in the file").arg(int(error.code));
    } else {
        const DecodedAnimation &animation = **decoded;
        for (const std::uint32_t frame : {0u, animation.frameCount() / 2, animation.frameCount() - 1})
            for (const Vec3f &p : animation.frame(frame))
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                    complaint = QString("frame %1 is not finite").arg(frame);
        if (const auto rest = animation.check(Progress()); !rest && rest.error().code != ErrorCode::CorruptStream)
            complaint = QString("check: error %1").arg(int(rest.error().code));
    }
    if (const std::uint64_t limit = limits.bytesFor(file.size()); meter.peak() > limit)
        complaint = QString("%1 bytes of memory, %2 allowed").arg(meter.peak()).arg(limit);
    return complaint;
}

/// Each once, one thread: starting threads takes longer than files of this size.
class OneThread
{
public:
    OneThread() { setThreadCount(1); }
    ~OneThread() { setThreadCount(0); }
};

/// The values that replace a byte.
std::vector<std::uint8_t> replacements(std::uint8_t byte)
{
    return {std::uint8_t(byte ^ 1), std::uint8_t(byte ^ 0x80), 0, 255};
}

Bytes varUint(std::uint64_t value)
{
    ByteWriter writer;
    writer.varUint(value);
    return writer.take();
}

/// The fields of HEAD that are counts.
enum Count { Vertices, Triangles, Frames };
const char *const CountNames[]{"vertices", "triangles", "frames"};

/// The file with another count; the checksum is right.
Bytes withCount(const Bytes &file, Count count, std::uint64_t value)
{
    return tests::withPayload(file, "HEAD", [&](Bytes &payload) {
        ByteReader reader(payload);
        reader.bytes(2); // version
        reader.varUint();
        reader.u8();
        for (int i = 0; i < count; ++i)
            reader.varUint();
        const auto begin = std::ptrdiff_t(reader.offset());
        reader.varUint();
        payload.erase(payload.begin() + begin, payload.begin() + std::ptrdiff_t(reader.offset()));
        const Bytes coded = varUint(value);
        payload.insert(payload.begin() + begin, coded.begin(), coded.end());
    });
}

enum Shape { Sheet, Fan, Apart, Repeated, Linked, Alone };

Connectivity meshOf(Shape shape, std::uint32_t triangles)
{
    Connectivity mesh;
    const std::uint32_t side = std::uint32_t(std::sqrt(triangles / 2.0));
    switch (shape) {
    case Sheet:
        return tests::sheet(side, side);
    case Fan:
        mesh.vertexCount = triangles + 2;
        for (std::uint32_t t = 0; t < triangles; ++t)
            mesh.triangles.push_back({0, t + 1, t + 2});
        return mesh;
    case Apart:
        mesh.vertexCount = 3 * triangles;
        for (std::uint32_t t = 0; t < triangles; ++t)
            mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        return mesh;
    case Repeated:
        return {3, std::vector<Triangle>(triangles, Triangle{0, 1, 2})};
    case Linked:
        mesh.vertexCount = 2 * side;
        for (std::uint32_t a = 0; a < mesh.vertexCount; ++a)
            for (std::uint32_t b = 0; b < a; ++b)
                mesh.triangles.push_back({a, b, (a * 7 + b * 3) % mesh.vertexCount});
        return mesh;
    case Alone:
        mesh.vertexCount = triangles;
        return mesh;
    }
    return mesh;
}

// What a caller may ask for; keeps the tests quick.
const DecodeLimits LittleMemory{std::uint64_t(10) << 20};

ErrorCode codeOf(const Bytes &file, const DecodeLimits &limits = DecodeLimits())
{
    const auto decoded = decodeAnimation(Bytes(file), Progress(), limits);
    return decoded ? ErrorCode(0xffff) : decoded.error().code;
}

} // namespace

/// Files that somebody has made or damaged on purpose. Golden files are what is damaged: they use all that was ever
/// written. The fuzzers (tests/fuzz) go on where this ends.
class TestHostile final : public QObject
{
    Q_OBJECT

    static void addGoldenRows()
    {
        QTest::addColumn<QString>("name");
        for (const QString &name : filesIn("anim"))
            QTest::newRow(qPrintable(name)) << name;
        QVERIFY(!filesIn("anim").isEmpty());
    }

    static void check(const Bytes &file, const QString &what, const DecodeLimits &limits = DecodeLimits())
    {
        const QString complaint = complaintAbout(file, limits);
        QVERIFY2(complaint.isEmpty(), qPrintable(what + ": " + complaint));
    }

private slots:
    void everyPrefixIsRefused_data() { addGoldenRows(); }
    void everyPrefixIsRefused()
    {
        QFETCH(QString, name);
        const OneThread one;
        const Bytes file = readFile(DataFolder + "anim/" + name);
        QVERIFY(!file.empty());
        for (std::size_t length = 0; length < file.size(); ++length) {
            const Bytes prefix(file.begin(), file.begin() + std::ptrdiff_t(length));
            QVERIFY2(codeOf(prefix) == (length == 0 ? ErrorCode::BadMagic : ErrorCode::Truncated),
                     qPrintable(QString::number(length)));
            check(prefix, QString::number(length));
        }
    }

    void everyPrefixOfAChunkIsSurvived_data() { addGoldenRows(); }
    void everyPrefixOfAChunkIsSurvived()
    {
        QFETCH(QString, name);
        const OneThread one;
        const auto chunks = tests::takeApart(readFile(DataFolder + "anim/" + name));
        for (std::size_t i = 0; i + 1 < chunks.size(); ++i)
            for (std::size_t length = 0; length < chunks[i].second.size(); ++length) {
                auto damaged = chunks;
                damaged[i].second.resize(length);
                // A shorter stream may happen to be a whole one: the checksum is there to tell.
                check(tests::putTogether(damaged), QString("%1 of %2").arg(length).arg(chunks[i].first.c_str()));
            }
    }

    void everyChangedByteIsRefused_data() { addGoldenRows(); }
    void everyChangedByteIsRefused()
    {
        QFETCH(QString, name);
        const OneThread one;
        const Bytes file = readFile(DataFolder + "anim/" + name);
        for (std::size_t i = 0; i < file.size(); ++i)
            for (const std::uint8_t value : replacements(file[i])) {
                if (value == file[i])
                    continue;
                Bytes damaged = file;
                damaged[i] = value;
                const QString what = QString("byte %1 = %2").arg(i).arg(value);
                QVERIFY2(codeOf(damaged) != ErrorCode(0xffff), qPrintable(what));
                check(damaged, what);
            }
    }

    // With the checksum of its chunk mended, so that the stage itself meets it.
    void everyChangedByteIsSurvived_data() { addGoldenRows(); }
    void everyChangedByteIsSurvived()
    {
        QFETCH(QString, name);
        const OneThread one;
        const auto chunks = tests::takeApart(readFile(DataFolder + "anim/" + name));
        // Of the long chunks one value for each byte instead of all: chosen by this, the same each time.
        std::minstd_rand random(20261122);
        for (std::size_t c = 0; c < chunks.size(); ++c)
            for (std::size_t i = 0; i < chunks[c].second.size(); ++i) {
                auto values = replacements(chunks[c].second[i]);
                if (chunks[c].second.size() > 64)
                    values = {values[random() % values.size()]};
                for (const std::uint8_t value : values) {
                    auto damaged = chunks;
                    damaged[c].second[i] = value;
                    check(tests::putTogether(damaged),
                          QString("byte %1 of %2 = %3").arg(i).arg(chunks[c].first.c_str()).arg(value));
                }
            }
    }

    void countsBeyondTheLimitsAreRefused_data() { addGoldenRows(); }
    void countsBeyondTheLimitsAreRefused()
    {
        QFETCH(QString, name);
        const Bytes file = readFile(DataFolder + "anim/" + name);
        const std::uint64_t limits[]{1u << 30, 1u << 30, 1u << 26};
        for (const Count count : {Vertices, Triangles, Frames}) {
            for (const std::uint64_t value :
                 {limits[count] + 1, std::uint64_t(1) << 32, ~std::uint64_t(0) >> 1, ~std::uint64_t(0)})
                QVERIFY2(codeOf(withCount(file, count, value)) == ErrorCode::BadValue, CountNames[count]);
            // What the format allows is more than a file of this size may need. Frames of `direct` need nothing until
            // they are asked for; its groups are not there.
            const ErrorCode most = codeOf(withCount(file, count, limits[count]));
            if (count == Frames && name.startsWith("direct"))
                QVERIFY(most == ErrorCode::Truncated || most == ErrorCode::CorruptStream ||
                        most == ErrorCode::BadValue);
            else
                QVERIFY2(most == ErrorCode::LimitExceeded, CountNames[count]);
            for (const std::uint64_t value : {limits[count], limits[count] + 1, ~std::uint64_t(0)})
                check(withCount(file, count, value), CountNames[count]);
        }
        QCOMPARE(int(codeOf(withCount(file, Vertices, 0))), int(ErrorCode::BadValue));
        QCOMPARE(int(codeOf(withCount(file, Frames, 0))), int(ErrorCode::BadValue));
    }

    // The most that passes the check of memory before anything is decoded: it must have told the truth.
    void largestCountsKeepToTheMemory_data() { addGoldenRows(); }
    void largestCountsKeepToTheMemory()
    {
        QFETCH(QString, name);
        const OneThread one;
        const Bytes file = readFile(DataFolder + "anim/" + name);
        for (const Count count : {Vertices, Triangles, Frames}) {
            std::uint64_t accepted = 1, refused = 1u << 26;
            while (refused - accepted > 1) {
                const std::uint64_t middle = (accepted + refused) / 2;
                (codeOf(withCount(file, count, middle), LittleMemory) == ErrorCode::LimitExceeded ? refused
                                                                                                  : accepted) = middle;
            }
            QVERIFY2(accepted > 1000, CountNames[count]);
            check(withCount(file, count, accepted), QString("%1 %2").arg(accepted).arg(CountNames[count]),
                  LittleMemory);
        }
    }

    // Meshes of every proportion between vertices, triangles and edges, as many as are accepted: a few bits may stand
    // for much.
    void meshesKeepToTheMemory_data()
    {
        QTest::addColumn<int>("shape");
        QTest::newRow("sheet") << int(Sheet);
        QTest::newRow("fan") << int(Fan);
        QTest::newRow("triangles apart") << int(Apart);
        QTest::newRow("one triangle again and again") << int(Repeated);
        QTest::newRow("everything linked") << int(Linked);
        QTest::newRow("vertices alone") << int(Alone);
    }
    void meshesKeepToTheMemory()
    {
        QFETCH(int, shape);
        const OneThread one;
        const CompressionSettings all[]{{ReelSettings{0.1, 1}},
                                        {ReelSettings{0.1, 1}, true},
                                        {CoddyacSettings{1, 0.1, 0.1}},
                                        {CoddyacSettings{1, 0.1, 0.1}, true},
                                        {PcaSettings{1, 10}},
                                        {DirectSettings{10}},
                                        {DirectSettings{10, Predictor::Still, Entropy::Deflate}}};
        for (const CompressionSettings &settings : all) {
            bool isRefused = false;
            for (std::uint32_t triangles = 2000; !isRefused; triangles = triangles * 3 / 2) {
                const Connectivity mesh = meshOf(Shape(shape), triangles);
                const tests::PlainAnimation source(2, mesh.vertexCount, mesh.triangles,
                                                   [](std::uint32_t f, std::uint32_t v) {
                                                       return Vec3f{float(v % 7), float(v % 11), float(f)};
                                                   });
                const Bytes file = encodeAnimation(source, settings)->bytes;
                check(file, QString("%1 triangles, codec %2").arg(triangles).arg(int(settings.codec())), LittleMemory);
                const auto decoded = decodeAnimation(file, Progress(), LittleMemory);
                isRefused = !decoded;
                QVERIFY(decoded || decoded.error().code == ErrorCode::LimitExceeded);
            }
        }
    }

    // What the fuzzers found, see its README.
    void findingsStayMended_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString &name : filesIn("hostile"))
            QTest::newRow(qPrintable(name)) << name;
    }
    void findingsStayMended()
    {
        QFETCH(QString, name);
        const Bytes file = readFile(DataFolder + "hostile/" + name);
        QVERIFY(!file.empty());
        check(file, name);
    }
};

SANDREEL_TEST(TestHostile)
#include "tst_hostile.moc"
