// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/animations.h"
#include "tests/model/codec/container/hostilefile.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;
using namespace model::codec;

namespace {

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

} // namespace

/// Counts that promise much, and meshes whose few bits stand for many triangles.
class TestMemoryLimit final : public QObject
{
    Q_OBJECT

private slots:
    void countsBeyondTheLimitsAreRefused_data() { tests::addGoldenRows(); }
    void countsBeyondTheLimitsAreRefused()
    {
        QFETCH(QString, name);
        const Bytes file = tests::dataFile("anim/" + name);
        const std::uint64_t limits[]{1u << 30, 1u << 30, 1u << 26};
        for (const Count count : {Vertices, Triangles, Frames}) {
            for (const std::uint64_t value :
                 {limits[count] + 1, std::uint64_t(1) << 32, ~std::uint64_t(0) >> 1, ~std::uint64_t(0)})
                QVERIFY2(tests::codeOf(withCount(file, count, value)) == ErrorCode::BadValue, CountNames[count]);
            // What the format allows is more than a file of this size may need. Frames of `direct` need nothing until
            // they are asked for; its groups are not there.
            const ErrorCode most = tests::codeOf(withCount(file, count, limits[count]));
            if (count == Frames && name.startsWith("direct"))
                QVERIFY(most == ErrorCode::Truncated || most == ErrorCode::CorruptStream ||
                        most == ErrorCode::BadValue);
            else
                QVERIFY2(most == ErrorCode::LimitExceeded, CountNames[count]);
            for (const std::uint64_t value : {limits[count], limits[count] + 1, ~std::uint64_t(0)})
                tests::checkHostile(withCount(file, count, value), CountNames[count]);
        }
        QCOMPARE(int(tests::codeOf(withCount(file, Vertices, 0))), int(ErrorCode::BadValue));
        QCOMPARE(int(tests::codeOf(withCount(file, Frames, 0))), int(ErrorCode::BadValue));
    }

    // The most that passes the check of memory before anything is decoded: it must have told the truth.
    void largestCountsKeepToTheMemory_data() { tests::addGoldenRows(); }
    void largestCountsKeepToTheMemory()
    {
        QFETCH(QString, name);
        const tests::OneThread one;
        const Bytes file = tests::dataFile("anim/" + name);
        for (const Count count : {Vertices, Triangles, Frames}) {
            std::uint64_t accepted = 1, refused = 1u << 26;
            while (refused - accepted > 1) {
                const std::uint64_t middle = (accepted + refused) / 2;
                (tests::codeOf(withCount(file, count, middle), LittleMemory) == ErrorCode::LimitExceeded ? refused
                                                                                                         : accepted) =
                    middle;
            }
            QVERIFY2(accepted > 1000, CountNames[count]);
            tests::checkHostile(withCount(file, count, accepted), QString("%1 %2").arg(accepted).arg(CountNames[count]),
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
        const tests::OneThread one;
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
                tests::checkHostile(file, QString("%1 triangles, codec %2").arg(triangles).arg(int(settings.codec())),
                                    LittleMemory);
                const auto decoded = decodeAnimation(file, Progress(), LittleMemory);
                isRefused = !decoded;
                QVERIFY(decoded || decoded.error().code == ErrorCode::LimitExceeded);
            }
        }
    }
};

SANDREEL_TEST(TestMemoryLimit)
#include "tst_memorylimit.moc"
