// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/metrics.h"
#include "model/base/parallel.h"
#include "tests/model/animation/permuted.h"
#include "tests/support/meshes.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

using namespace model;
using tests::isNear;
using tests::Permutation;
using tests::permuted;
using tests::shuffled;

namespace {

Sequence points(std::uint32_t vertexCount, std::vector<Vec3f> positions)
{
    return Sequence({vertexCount, {}}, std::move(positions));
}

/// The definitions of metrics.h written down plainly: matrices, one formula after the other, long double.
ComparisonResult slowReference(const Sequence &v, const Sequence &w)
{
    const std::uint32_t vertices = v.vertexCount(), frames = v.frameCount();
    const auto at = [](const Sequence &s, std::uint32_t f, std::uint32_t i, int axis) -> long double {
        const Vec3f p = s.frameView(f)[i];
        return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    };
    ComparisonResult result;
    long double error = 0, spread = 0, largest = -1;
    std::vector<long double> lengths(frames);
    long double low[3], high[3];
    for (int axis = 0; axis < 3; ++axis)
        low[axis] = high[axis] = at(v, 0, 0, axis);
    for (std::uint32_t f = 0; f < frames; ++f) {
        long double frameError = 0, frameSpread = 0, frameLargest = -1;
        FrameError own;
        for (int axis = 0; axis < 3; ++axis) {
            long double mean = 0;
            for (std::uint32_t i = 0; i < vertices; ++i)
                mean += at(v, f, i, axis) / vertices;
            for (std::uint32_t i = 0; i < vertices; ++i) {
                frameSpread += std::pow(at(v, f, i, axis) - mean, 2.0L);
                low[axis] = std::min(low[axis], at(v, f, i, axis));
                high[axis] = std::max(high[axis], at(v, f, i, axis));
            }
        }
        for (std::uint32_t i = 0; i < vertices; ++i) {
            long double squared = 0;
            for (int axis = 0; axis < 3; ++axis)
                squared += std::pow(at(v, f, i, axis) - at(w, f, i, axis), 2.0L);
            frameError += squared;
            lengths[f] += std::sqrt(squared);
            if (squared > frameLargest) {
                frameLargest = squared;
                own.worstVertex = i;
            }
        }
        own.kgErrorPercent = double(100 * std::sqrt(frameError) / (frameSpread > 0 ? std::sqrt(frameSpread) : 1));
        own.rmse = double(std::sqrt(frameError / vertices));
        own.maxVertexError = double(std::sqrt(frameLargest));
        result.frames.push_back(own);
        error += frameError;
        spread += frameSpread;
        if (frameLargest > largest) {
            largest = frameLargest;
            result.worstFrame = f;
            result.worstVertex = own.worstVertex;
        }
    }
    long double diagonal = 0;
    for (int axis = 0; axis < 3; ++axis)
        diagonal += std::pow(high[axis] - low[axis], 2.0L);
    result.diagonal = double(std::sqrt(diagonal));
    for (std::uint32_t f = 0; f < frames; ++f) {
        const long double own = lengths[f] / vertices / (diagonal > 0 ? std::sqrt(diagonal) : 1);
        result.frames[f].daError = double(own);
        result.daError += double(own / frames);
    }
    result.kgErrorPercent = double(100 * std::sqrt(error) / (spread > 0 ? std::sqrt(spread) : 1));
    result.rmse = double(std::sqrt(error / vertices / frames));
    result.maxVertexError = double(std::sqrt(largest));
    result.psnrDb = double(20 * std::log10(std::sqrt(diagonal) / std::sqrt(error / vertices / frames)));
    return result;
}

} // namespace

class TestMetrics final : public QObject
{
    Q_OBJECT

private slots:
    /// Two frames of a 3-4-5 kind: every number below was computed with pencil.
    void byHand()
    {
        // Frame 0: (0,0,0), (2,0,0), mean (1,0,0), spread 1 + 1 = 2. Frame 1: (0,0,0), (0,6,0), spread 9 + 9 = 18.
        const Sequence reference = points(2, {{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 6, 0}});
        // Errors: frame 0: 1 at vertex 0; frame 1: (3,4,0), length 5, at vertex 1. Sum of squares 26, spread 20.
        const Sequence test = points(2, {{0, 0, 1}, {2, 0, 0}, {0, 0, 0}, {3, 10, 0}});
        // The same with the vertices exchanged.
        const Sequence exchanged = points(2, {{2, 0, 0}, {0, 0, 1}, {3, 10, 0}, {0, 0, 0}});
        const Permutation exchange{1, 0};
        for (const auto &result :
             {compareAnimations(reference, test), compareAnimations(reference, exchanged, exchange)}) {
            QVERIFY(result.has_value());
            QCOMPARE(result->kgErrorPercent, 100 * std::sqrt(26.0) / std::sqrt(20.0));
            QCOMPARE(result->rmse, std::sqrt(26.0 / 4));
            QCOMPARE(result->daError, (1.0 + 5.0) / 4 / std::sqrt(40.0)); // lengths of the errors over the diagonal
            QCOMPARE(result->frames[0].daError, 0.5 / std::sqrt(40.0));
            QCOMPARE(result->frames[1].daError, 2.5 / std::sqrt(40.0));
            QCOMPARE(result->diagonal, std::sqrt(40.0)); // box (0,0,0)..(2,6,0)
            QCOMPARE(result->psnrDb, 10 * std::log10(40.0 / 6.5));
            QCOMPARE(result->maxVertexError, 5.0);
            QCOMPARE(result->worstFrame, 1u);
            QCOMPARE(result->worstVertex, 1u);
            QCOMPARE(result->frames.size(), std::size_t(2));
            QCOMPARE(result->frames[0].kgErrorPercent, 100 / std::sqrt(2.0));
            QCOMPARE(result->frames[0].rmse, std::sqrt(0.5));
            QCOMPARE(result->frames[0].maxVertexError, 1.0);
            QCOMPARE(result->frames[0].worstVertex, 0u);
            QCOMPARE(result->frames[1].kgErrorPercent, 500 / std::sqrt(18.0));
            QCOMPARE(result->frames[1].maxVertexError, 5.0);
            QCOMPARE(result->frames[1].worstVertex, 1u);
        }
    }

    void asTheSlowReferenceSays_data() { tests::addRows(tests::namedAnimations()); }
    void asTheSlowReferenceSays()
    {
        QFETCH(int, row);
        const Sequence &reference = *tests::namedAnimations()[std::size_t(row)].sequence;
        std::vector<Vec3f> positions(reference.allPositions().begin(), reference.allPositions().end());
        std::mt19937 random(7);
        for (Vec3f &p : positions)
            p = p +
                Vec3f{float(random() % 1000) * 1e-5f, float(random() % 1000) * 1e-5f, float(random() % 1000) * -1e-5f};
        const Sequence test({reference.vertexCount(), {}}, positions);
        const ComparisonResult expected = slowReference(reference, test);

        const Permutation permutation = shuffled(reference.vertexCount(), 3);
        for (const auto &result : {compareAnimations(reference, test),
                                   compareAnimations(reference, *permuted(test, permutation), permutation)}) {
            QVERIFY(result.has_value());
            QVERIFY(isNear(result->kgErrorPercent, expected.kgErrorPercent));
            QVERIFY(isNear(result->rmse, expected.rmse));
            QVERIFY(isNear(result->daError, expected.daError));
            QVERIFY(isNear(result->maxVertexError, expected.maxVertexError));
            QVERIFY(isNear(result->diagonal, expected.diagonal));
            QVERIFY(result->psnrDb == expected.psnrDb || isNear(result->psnrDb, expected.psnrDb));
            QCOMPARE(result->worstFrame, expected.worstFrame);
            QCOMPARE(result->worstVertex, expected.worstVertex);
            QCOMPARE(result->frames.size(), expected.frames.size());
            for (std::size_t f = 0; f < expected.frames.size(); ++f) {
                QVERIFY(isNear(result->frames[f].kgErrorPercent, expected.frames[f].kgErrorPercent));
                QVERIFY(isNear(result->frames[f].rmse, expected.frames[f].rmse));
                QVERIFY(isNear(result->frames[f].daError, expected.frames[f].daError));
                QVERIFY(isNear(result->frames[f].maxVertexError, expected.frames[f].maxVertexError));
                QCOMPARE(result->frames[f].worstVertex, expected.frames[f].worstVertex);
            }
        }
    }

    void equalAnimationsHaveNoError()
    {
        const auto animation = tests::noise(tests::torus());
        const auto result = compareAnimations(*animation, *animation);
        QVERIFY(result.has_value());
        QCOMPARE(result->kgErrorPercent, 0.0);
        QCOMPARE(result->rmse, 0.0);
        QCOMPARE(result->maxVertexError, 0.0);
        QVERIFY(std::isinf(result->psnrDb) && result->psnrDb > 0);
        QCOMPARE(result->worstFrame, 0u);
        QCOMPARE(result->worstVertex, 0u);
    }

    /// Of equally bad vertices and frames the first is named, whatever order the test animation has them in.
    void theFirstOfEqualsIsTheWorst()
    {
        const Sequence reference = points(3, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
        const Sequence test = points(3, {{2, 0, 1}, {1, 0, 1}, {0, 0, 0}, {2, 0, 1}, {1, 0, 1}, {0, 0, 0}});
        const auto result = compareAnimations(reference, test, Permutation{2, 1, 0});
        QVERIFY(result.has_value());
        QCOMPARE(result->worstFrame, 0u);
        QCOMPARE(result->worstVertex, 1u);
        QCOMPARE(result->frames[1].worstVertex, 1u);
    }

    /// One vertex has no spread: its denominator counts as 1.
    void zeroDenominators()
    {
        const auto result = compareAnimations(points(1, {{1, 1, 1}, {5, 1, 1}}), points(1, {{1, 1, 4}, {5, 5, 1}}));
        QVERIFY(result.has_value());
        QCOMPARE(result->kgErrorPercent, 500.0); // 100 * sqrt(9 + 16)
        QCOMPARE(result->frames[0].kgErrorPercent, 300.0);
        QCOMPARE(result->daError, 3.5 / 4);
        QCOMPARE(result->frames[1].kgErrorPercent, 400.0);
        QCOMPARE(result->diagonal, 4.0);

        const auto flat = compareAnimations(points(1, {{1, 1, 1}}), points(1, {{1, 1, 1}}));
        QVERIFY(flat.has_value());
        QCOMPARE(flat->kgErrorPercent, 0.0);
        QVERIFY(std::isinf(flat->psnrDb) && flat->psnrDb > 0);

        const auto point = compareAnimations(points(1, {{1, 1, 1}}), points(1, {{1, 1, 2}}));
        QVERIFY(std::isinf(point->psnrDb) && point->psnrDb < 0);
        QCOMPARE(point->daError, 1.0);
    }

    /// Far from the origin sums of squares in float, or a one-pass variance, would lose everything.
    void farFromTheOrigin()
    {
        const Sequence reference = points(2, {{1e6f, 0, 0}, {1e6f + 2, 0, 0}});
        const auto result = compareAnimations(reference, points(2, {{1e6f, 0, 1}, {1e6f + 2, 0, 0}}));
        QCOMPARE(result->kgErrorPercent, 100 / std::sqrt(2.0));
        QCOMPARE(result->diagonal, 2.0);
    }

    void resultDoesNotDependOnThreads()
    {
        const auto reference = tests::noise(tests::torus(), 60, 1);
        const auto test = tests::noise(tests::torus(), 60, 2);
        setThreadCount(1);
        const ComparisonResult one = *compareAnimations(*reference, *test);
        for (const unsigned threads : {2u, 5u}) {
            setThreadCount(threads);
            const ComparisonResult many = *compareAnimations(*reference, *test);
            QVERIFY(many.kgErrorPercent == one.kgErrorPercent);
            QVERIFY(many.rmse == one.rmse);
            QVERIFY(many.psnrDb == one.psnrDb);
            QCOMPARE(many.worstFrame, one.worstFrame);
            QCOMPARE(many.worstVertex, one.worstVertex);
        }
        setThreadCount(0);
    }

    void connectivityDoesNotMatter()
    {
        const TriangleMesh mesh = tests::cube();
        const Sequence other({mesh.connectivity.vertexCount, {}}, mesh.positions);
        const auto result = compareAnimations(*tests::oneFrame(mesh), other);
        QVERIFY(result.has_value());
        QCOMPARE(result->rmse, 0.0);
    }

    void otherCountsAreRefused()
    {
        const auto reference = tests::wave(tests::cube(), 4);
        const auto vertices = compareAnimations(*reference, *tests::wave(tests::tetrahedron(), 4));
        QVERIFY(!vertices && vertices.error().code == ErrorCode::MeshesDiffer);
        QVERIFY(vertices.error().args == std::vector<std::string>({"vertices", "8", "4"}));
        const auto frames = compareAnimations(*reference, *tests::wave(tests::cube(), 5));
        QVERIFY(!frames && frames.error().code == ErrorCode::MeshesDiffer);
        QVERIFY(frames.error().args == std::vector<std::string>({"frames", "4", "5"}));
    }

    void whatIsNoPermutationIsRefused_data()
    {
        QTest::addColumn<QList<quint32>>("permutation");
        QTest::addColumn<QString>("reason");
        QTest::newRow("short") << QList<quint32>{0, 1, 2} << "3 entries for 4 vertices";
        QTest::newRow("long") << QList<quint32>{0, 1, 2, 3, 0} << "5 entries for 4 vertices";
        QTest::newRow("outside") << QList<quint32>{0, 1, 2, 4} << "vertex 4 of 4";
        QTest::newRow("far outside") << QList<quint32>{0, 0xffffffff, 2, 3} << "vertex 4294967295 of 4";
        QTest::newRow("twice") << QList<quint32>{0, 1, 2, 1} << "vertex 1 twice";
    }
    void whatIsNoPermutationIsRefused()
    {
        QFETCH(QList<quint32>, permutation);
        QFETCH(QString, reason);
        const auto animation = tests::wave(tests::tetrahedron());
        const auto result =
            compareAnimations(*animation, *animation, Permutation(permutation.begin(), permutation.end()));
        QVERIFY(!result && result.error().code == ErrorCode::BadPermutation);
        QCOMPARE(QString::fromStdString(result.error().args.at(0)), reason);
    }

    void cancelStops()
    {
        const auto animation = tests::wave(tests::cube(), 200);
        Progress progress; // cancels itself when a tenth is done
        std::atomic<int> reports = 0;
        Progress *self = &progress;
        progress = Progress([&](double fraction) {
            ++reports;
            if (fraction > 0.1)
                self->cancel();
        });
        const auto result = compareAnimations(*animation, *animation, {}, progress);
        QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
        QVERIFY(reports > 0 && reports < 100);
    }
};

SANDREEL_TEST(TestMetrics)
#include "tst_metrics.moc"
