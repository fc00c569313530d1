// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/latest.h"
#include "model/haptics/snapshot/triplebuffer.h"
#include "tests/model/haptics/grounds.h"
#include "tests/support/testmain.h"

#include <thread>

using namespace model;
using namespace model::haptics;
using terrain::Point2;

class TestSnapshot final : public QObject
{
    Q_OBJECT

    static double hills(double x, double y) { return 5 + 0.3 * std::sin(5 * x) * std::cos(7 * y); }

private slots:
    void patchSaysWhatTheTerrainSays_data()
    {
        QTest::addColumn<double>("spacing");
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("a few triangles") << 0.1 << 0.3 << 1e-6;
        QTest::newRow("two") << 2.0 << 0.3 << 1e-6;
        QTest::newRow("too many: sampled") << 0.02 << 0.5 << 0.02;
    }
    void patchSaysWhatTheTerrainSays()
    {
        QFETCH(double, spacing);
        QFETCH(double, radius);
        QFETCH(double, tolerance);
        const terrain::Terrain ground = tests::groundOf(spacing, hills);
        PatchBuilder builder;
        TerrainPatch patch;
        const Point2 centre{0.123, -0.2};
        builder.build(ground, centre, radius, patch);
        QVERIFY(patch.triangleCount > 0);
        std::mt19937 random(1);
        std::uniform_real_distribution<> any(-radius, radius);
        for (int i = 0; i < 5000; ++i) {
            const Point2 p{centre.x + any(random), centre.y + any(random)};
            const Ground found = patch.groundAt(p);
            QVERIFY(found.isKnown);
            QVERIFY(std::abs(found.height - ground.tin.heightAt(p)) < tolerance);
            if (tolerance < 1e-5 && i % 10 == 0) {
                const Ground east = patch.groundAt({p.x + 1e-7, p.y});
                if (east.isKnown && east.slopeX == found.slopeX)
                    QVERIFY(std::abs(east.height - found.height - 1e-7 * found.slopeX) < 1e-12);
            }
        }
        QVERIFY(!patch.groundAt({centre.x + 1.01 * radius, centre.y}).isKnown);
        QVERIFY(!patch.groundAt({std::nan(""), 0}).isKnown);
    }

    /// Vertices and edges of the triangles belong to somebody.
    void hasNoGaps()
    {
        const terrain::Terrain ground = tests::groundOf(0.1, hills);
        PatchBuilder builder;
        TerrainPatch patch;
        builder.build(ground, {0, 0}, 0.35, patch);
        for (int j = -34; j <= 34; ++j)
            for (int i = -34; i <= 34; ++i)
                QVERIFY2(patch.groundAt({i * 0.01, j * 0.01}).isKnown, qPrintable(QString("%1 %2").arg(i).arg(j)));
    }

    void nothingIsKnownOutsideTheDomain()
    {
        const terrain::Terrain ground = tests::groundOf(0.5, hills);
        PatchBuilder builder;
        TerrainPatch patch;
        builder.build(ground, {1.5, 0}, 0.3, patch);
        QVERIFY(!patch.groundAt({1.5, 0}).isKnown);
        builder.build(ground, {0.95, 0}, 0.3, patch);
        QVERIFY(patch.groundAt({0.99, 0}).isKnown);
        QVERIFY(!patch.groundAt({1.1, 0}).isKnown);
    }

    void manySliversAreSampled()
    {
        // 500 long thin triangles through every cell would need a large index.
        TerrainPatch patch;
        patch.radius = 1;
        patch.triangleCount = 500;
        for (std::uint32_t i = 0; i < 500; ++i)
            patch.triangles[i] = {Vec3f{-1, -1, 0}, Vec3f{1, float(0.9 + i * 1e-4), 0},
                                  Vec3f{1, float(0.9001 + i * 1e-4), 0}};
        QVERIFY(!patch.index());
        QVERIFY(!patch.groundAt({0, 0}).isKnown);
    }

    void feelsTheLayerOnTop()
    {
        terrain::Terrain ground = tests::groundOf(0.5, hills);
        PatchBuilder builder;
        TerrainPatch patch;
        builder.build(ground, {0, 0}, 0.3, patch);
        QCOMPARE(patch.feel, feelOf(terrain::material(terrain::MaterialPreset::DrySand), 0));
    }

    void readerSeesTheNewestOrWhatItHas()
    {
        TripleBuffer<int> buffer;
        QVERIFY(!buffer.take());
        buffer.writable() = 1;
        buffer.publish();
        buffer.writable() = 2;
        buffer.publish();
        QVERIFY(buffer.hasNews());
        QVERIFY(buffer.take());
        QCOMPARE(buffer.readable(), 2);
        QVERIFY(!buffer.take());
        QCOMPARE(buffer.readable(), 2);
    }

    /// Two threads, no value torn, none older than the one before.
    void valuesArriveWhole()
    {
        struct Value
        {
            std::array<std::uint64_t, 512> words{};
        };
        TripleBuffer<Value> buffer;
        constexpr std::uint64_t Last = 20000;
        std::thread writer([&] {
            for (std::uint64_t i = 1; i <= Last; ++i) {
                buffer.writable().words.fill(i);
                buffer.publish();
            }
        });
        std::uint64_t before = 0;
        bool isWhole = true, ascends = true;
        while (before < Last) {
            if (!buffer.take()) {
                std::this_thread::yield();
                continue;
            }
            const auto &words = buffer.readable().words;
            for (const std::uint64_t word : words)
                isWhole = isWhole && word == words[0];
            ascends = ascends && words[0] > before;
            before = words[0];
        }
        writer.join();
        QVERIFY(isWhole);
        QVERIFY(ascends);
    }

    void latestValueIsWhole()
    {
        struct Value
        {
            std::array<std::uint64_t, 8> words{};
        };
        Latest<Value> latest;
        std::atomic<bool> isOver = false;
        std::thread writer([&] {
            Value value;
            for (std::uint64_t i = 1; i <= 50000; ++i) {
                value.words.fill(i);
                latest.set(value);
            }
            isOver = true;
        });
        bool isWhole = true;
        Value value;
        while (!isOver)
            if (latest.read(value))
                for (const std::uint64_t word : value.words)
                    isWhole = isWhole && word == value.words[0];
        writer.join();
        QVERIFY(latest.read(value));
        QCOMPARE(value.words[7], 50000u);
        QVERIFY(isWhole);
    }
};

SANDREEL_TEST(TestSnapshot)
#include "tst_snapshot.moc"
