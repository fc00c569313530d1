// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/hausdorff.h"
#include "model/animation/metrics.h"
#include "model/base/parallel.h"
#include "model/mesh/surfacedistance.h"
#include "model/mesh/surfacesamples.h"
#include "tests/model/animation/permuted.h"
#include "tests/support/meshes.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <atomic>
#include <cmath>
#include <limits>

using namespace model;
using tests::isNear;

namespace {

std::vector<Triangle> withLoneVertices(const Connectivity &connectivity)
{
    std::vector<Triangle> triangles = connectivity.triangles;
    for (std::uint32_t v = 0; v < connectivity.vertexCount; ++v)
        if (std::ranges::none_of(connectivity.triangles, [v](const Triangle &t) { return std::ranges::count(t, v); }))
            triangles.push_back({v, v, v});
    return triangles;
}

/// Every sample against every triangle.
double slowDistance(const Sequence &from, const Sequence &to, std::uint32_t frame, double samplesPerTriangle)
{
    const std::span<const Vec3f> here = from.frameView(frame), there = to.frameView(frame);
    const std::vector<Triangle> triangles = withLoneVertices(from.connectivity());
    const std::vector<Triangle> others = withLoneVertices(to.connectivity());
    std::vector<Vec3d> samples(here.begin(), here.end());
    const VertexEdges edges(from.connectivity());
    const SampleCounts counts = countSamples(here, triangles, edges.edges(), samplesPerTriangle);
    for (std::size_t e = 0; e < edges.edges().size(); ++e)
        for (std::uint32_t k = 1; k <= counts.onEdge[e]; ++k) {
            const double share = k / (counts.onEdge[e] + 1.0);
            const auto [a, b] = edges.edges()[e];
            samples.push_back(Vec3d(here[a]) * (1 - share) + Vec3d(here[b]) * share);
        }
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < counts.onTriangle[t]; ++k) {
            const auto [u, v, w] = triangleSample(k);
            samples.push_back(Vec3d(here[triangles[t][0]]) * u + Vec3d(here[triangles[t][1]]) * v +
                              Vec3d(here[triangles[t][2]]) * w);
        }
    double farthest = 0;
    for (const Vec3d &sample : samples) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Triangle &t : others)
            nearest = std::min(nearest, squaredDistanceToTriangle(sample, {there[t[0]], there[t[1]], there[t[2]]}));
        farthest = std::max(farthest, nearest);
    }
    return std::sqrt(farthest);
}

/// A square in the plane z = 0 whose corners 1 and 3 are lifted by 1: the diagonal decides what it looks like.
Sequence folded(bool along02)
{
    const std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    const Connectivity one{4, {{0, 1, 2}, {0, 2, 3}}}, other{4, {{0, 1, 3}, {1, 2, 3}}};
    return Sequence(along02 ? one : other, corners);
}

} // namespace

class TestHausdorff final : public QObject
{
    Q_OBJECT

private slots:
    void byHand()
    {
        const Connectivity triangle{3, {{0, 1, 2}}};
        const Vec3f a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
        const Sequence reference(triangle, {a, b, c, a, b, c});
        // First a slides into the triangle, then it is lifted off it.
        const Sequence test(triangle, {Vec3f{1, 1, 0}, b, c, Vec3f{0, 0, 3}, b, c});
        for (const double samples : {0.0, 1.0, 100.0}) {
            const auto result = hausdorffDistance(reference, test, {}, samples);
            QVERIFY(result.has_value());
            // The smaller triangle is a part of the larger; the corner (0, 0) is nearest to (1, 1).
            QCOMPARE(result->frames[0].fromReference, std::sqrt(2.0));
            QCOMPARE(result->frames[0].fromTest, 0.0);
            // The foot of (0, 0, 0) on the plane x/4 + y/4 + z/3 = 1 lies inside: 1 / sqrt(1/16 + 1/16 + 1/9).
            QCOMPARE(result->frames[1].fromReference, std::sqrt(72.0 / 17));
            QCOMPARE(result->frames[1].fromTest, 3.0);
            QCOMPARE(result->frames[1].distance(), 3.0);
            QCOMPARE(result->fromReference, std::sqrt(72.0 / 17));
            QCOMPARE(result->fromTest, 3.0);
            QCOMPARE(result->distance, 3.0);
            QCOMPARE(result->worstFrame, 1u);
        }
    }

    /// All vertices are where they were, yet the surfaces differ: only samples between the vertices see it. The middle
    /// of the edge from 1 to 3 is 1 above that from 0 to 2, 1 / sqrt(3) from either triangle there.
    void betweenTheVertices()
    {
        const Sequence valley = folded(true), ridge = folded(false);
        QCOMPARE(hausdorffDistance(valley, ridge, {}, 0)->distance, 0.0);
        const HausdorffResult result = *hausdorffDistance(valley, ridge, {}, 1000);
        QVERIFY(result.distance <= 1 / std::sqrt(3.0));
        QVERIFY(result.distance > 0.98 / std::sqrt(3.0));
        QVERIFY(isNear(result.fromReference, result.fromTest, 0.02));
        QCOMPARE(compareAnimations(valley, ridge)->maxVertexError, 0.0);
    }

    void asTheSlowReferenceSays_data() { tests::addRows(tests::namedAnimations()); }
    void asTheSlowReferenceSays()
    {
        QFETCH(int, row);
        const Sequence &reference = *tests::namedAnimations()[std::size_t(row)].sequence;
        const auto test = tests::shaken(reference, 0.2f);
        const tests::Permutation permutation = tests::shuffled(reference.vertexCount(), 3);
        constexpr double Samples = 2;
        const auto result = hausdorffDistance(reference, *test, {}, Samples);
        const auto reordered = hausdorffDistance(reference, *tests::permuted(*test, permutation), permutation, 0);
        const auto vertices = hausdorffDistance(reference, *test, {}, 0);
        QVERIFY(result && reordered && vertices);
        const ComparisonResult errors = *compareAnimations(reference, *test);
        double fromReference = 0, fromTest = 0;
        for (std::uint32_t f = 0; f < reference.frameCount(); ++f) {
            const double there = slowDistance(reference, *test, f, Samples);
            const double back = slowDistance(*test, reference, f, Samples);
            fromReference = std::max(fromReference, there);
            fromTest = std::max(fromTest, back);
            QVERIFY(isNear(result->frames[f].fromReference, there, 1e-9));
            QVERIFY(isNear(result->frames[f].fromTest, back, 1e-9));
            QVERIFY(result->frames[f].distance() <= errors.frames[f].maxVertexError * (1 + 1e-9));
            // Triangles in another order get other samples, vertices do not.
            QVERIFY(isNear(reordered->frames[f].distance(), vertices->frames[f].distance(), 1e-9));
        }
        QVERIFY(isNear(result->fromReference, fromReference, 1e-9));
        QVERIFY(isNear(result->fromTest, fromTest, 1e-9));
        QCOMPARE(result->distance, std::max(result->fromReference, result->fromTest));
        QCOMPARE(result->frames[result->worstFrame].distance(), result->distance);
    }

    /// Nothing is known of triangles that only one of them has.
    void otherTriangles()
    {
        const auto reference = tests::noise(tests::torus(), 3);
        Connectivity fewer = reference->connectivity();
        fewer.triangles.resize(fewer.triangles.size() / 2);
        const Sequence test(fewer, {reference->allPositions().begin(), reference->allPositions().end()});
        const HausdorffResult result = *hausdorffDistance(*reference, test, {}, 5);
        for (std::uint32_t f = 0; f < 3; ++f) {
            QVERIFY(isNear(result.frames[f].fromReference, slowDistance(*reference, test, f, 5), 1e-9));
            QVERIFY(isNear(result.frames[f].fromTest, slowDistance(test, *reference, f, 5), 1e-9));
        }
        QVERIFY(result.fromReference > 0.05 && result.fromTest < 1e-6);
    }

    void equalAnimationsHaveNoError()
    {
        const auto animation = tests::noise(tests::torus());
        QCOMPARE(hausdorffDistance(*animation, *animation)->distance, 0.0);
    }

    void resultDoesNotDependOnThreads()
    {
        const auto reference = tests::noise(tests::torus(), 20, 1), test = tests::noise(tests::torus(), 20, 2);
        setThreadCount(1);
        const HausdorffResult one = *hausdorffDistance(*reference, *test);
        setThreadCount(4);
        const HausdorffResult four = *hausdorffDistance(*reference, *test);
        setThreadCount(0);
        QVERIFY(one.distance == four.distance && one.worstFrame == four.worstFrame);
        for (std::size_t f = 0; f < 20; ++f)
            QVERIFY(one.frames[f].distance() == four.frames[f].distance());
    }

    void whatCannotBeComparedIsRefused()
    {
        const auto four = tests::wave(tests::cube(), 4);
        const auto frames = hausdorffDistance(*four, *tests::wave(tests::cube(), 5));
        QVERIFY(!frames && frames.error().code == ErrorCode::MeshesDiffer);
        const auto order = hausdorffDistance(*four, *four, tests::Permutation{0, 1});
        QVERIFY(!order && order.error().code == ErrorCode::BadPermutation);
    }

    void cancelStops()
    {
        const auto animation = tests::wave(tests::cube(), 200);
        std::atomic<int> reports = 0;
        Progress progress, *self = &progress;
        progress = Progress([&](double fraction) {
            ++reports;
            if (fraction > 0.1)
                self->cancel();
        });
        const auto result = hausdorffDistance(*animation, *animation, {}, 10, progress);
        QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
        QVERIFY(reports > 0 && reports < 100);
    }
};

SANDREEL_TEST(TestHausdorff)
#include "tst_hausdorff.moc"
