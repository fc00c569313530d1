// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/sted.h"
#include "model/base/parallel.h"
#include "tests/model/animation/permuted.h"
#include "tests/support/meshes.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <atomic>
#include <cmath>
#include <set>

using namespace model;
using tests::isNear;

namespace {

using Real = long double;

Real lengthOf(Vec3f a, Vec3f b)
{
    const Real x = Real(a.x) - b.x, y = Real(a.y) - b.y, z = Real(a.z) - b.z;
    return std::sqrt(x * x + y * y + z * z);
}

/// The formulas of sted.h, one after the other, in long double, with sets and without any thought of time.
StedResult slowReference(const Sequence &v, const Sequence &w)
{
    const std::uint32_t V = v.vertexCount(), F = v.frameCount();
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle &t : v.connectivity().triangles)
        for (int i = 0; i < 3; ++i)
            if (t[std::size_t(i)] != t[std::size_t((i + 1) % 3)])
                edges.insert(std::minmax(t[std::size_t(i)], t[std::size_t((i + 1) % 3)]));
    StedResult result;
    result.frames.resize(F);
    Real spatial = 0, temporal = 0;
    for (std::uint32_t f = 0; f < F; ++f) {
        Real frameSum = 0;
        for (std::uint32_t i = 0; i < V; ++i) {
            std::set<std::uint32_t> ring{i};
            for (const auto &[a, b] : edges)
                if (a == i || b == i)
                    ring.insert({a, b});
            Real sumL = 0, sumDl = 0, sumSquares = 0;
            for (const bool second : {false, true}) {
                const Real mu = second ? sumDl / sumL : 0;
                for (const auto &[a, b] : edges) {
                    if (!ring.contains(a) && !ring.contains(b))
                        continue;
                    const Real l = lengthOf(v.frameView(f)[a], v.frameView(f)[b]);
                    const Real d = l > 0 ? (l - lengthOf(w.frameView(f)[a], w.frameView(f)[b])) / l : 0;
                    if (second) {
                        sumSquares += l * (d - mu) * (d - mu);
                    } else {
                        sumL += l;
                        sumDl += d * l;
                    }
                }
            }
            if (sumL > 0)
                frameSum += std::sqrt(sumSquares / sumL);
        }
        result.frames[f].spatial = double(frameSum / V);
        spatial += frameSum / V / F;
    }

    Real D = 0;
    for (const Vec3f &a : v.frameView(0))
        for (const Vec3f &b : v.frameView(0))
            D = std::max(D, lengthOf(a, b));
    if (D == 0)
        D = 1;
    const auto step = [&](const Sequence &s, std::uint32_t i, std::uint32_t f) {
        const Real l = lengthOf(s.frameView(f - 1)[i], s.frameView(f)[i]);
        return std::sqrt(l * l / (D * D) + Real(0.0003) * Real(0.0003));
    };
    for (std::uint32_t f = 1; f < F; ++f) {
        Real frameSum = 0;
        for (std::uint32_t i = 0; i < V; ++i) {
            Real sum = 0;
            int count = 0;
            for (int g = 1; g < int(F); ++g) // as the authors' program has it: the window belongs to g
                if (int(f) >= std::max(0, g - 5) && int(f) < std::min(int(F), g + 5)) {
                    sum += step(v, i, std::uint32_t(g));
                    ++count;
                }
            frameSum += std::abs((step(w, i, f) - step(v, i, f)) / (sum / count));
        }
        result.frames[f].temporal = double(frameSum / V);
        temporal += frameSum / V / (F - 1);
    }
    result.spatial = double(spatial);
    result.temporal = double(temporal);
    result.sted = double(std::sqrt(spatial * spatial + Real(9.144e-5) * Real(9.144e-5) * temporal * temporal));
    return result;
}

void compareWithSlowReference(const Sequence &reference, const Sequence &test)
{
    const StedResult expected = slowReference(reference, test);
    const tests::Permutation permutation = tests::shuffled(reference.vertexCount(), 3);
    for (const auto &result : {spatioTemporalDifference(reference, test),
                               spatioTemporalDifference(reference, *tests::permuted(test, permutation), permutation)}) {
        QVERIFY(result.has_value());
        QVERIFY(isNear(result->spatial, expected.spatial));
        QVERIFY(isNear(result->temporal, expected.temporal));
        QVERIFY(isNear(result->sted, expected.sted));
        QCOMPARE(result->frames.size(), expected.frames.size());
        for (std::size_t f = 0; f < expected.frames.size(); ++f) {
            QVERIFY(isNear(result->frames[f].spatial, expected.frames[f].spatial));
            QVERIFY(isNear(result->frames[f].temporal, expected.frames[f].temporal));
        }
    }
}

} // namespace

class TestSted final : public QObject
{
    Q_OBJECT

private slots:
    /// A triangle of sides 3, 4 and 5 rests for two frames; in the second frame of the test one corner has fallen onto
    /// another.
    void byHand()
    {
        const Connectivity triangle{3, {{0, 1, 2}}};
        const Vec3f a{0, 0, 0}, b{3, 0, 0}, c{0, 4, 0};
        const Sequence reference(triangle, {a, b, c, a, b, c});
        const Sequence test(triangle, {a, b, c, a, b, a});
        const auto result = spatioTemporalDifference(reference, test);
        QVERIFY(result.has_value());
        // Lengths 3, 4, 5 become 3, 0, 3: d = 0, 1, 0.4; all edges are around every vertex, mu = (4 + 2) / 12 = 0.5;
        // dev^2 = (3 * 0.25 + 4 * 0.25 + 5 * 0.01) / 12 = 0.15.
        QCOMPARE(result->frames[0].spatial, 0.0);
        QCOMPARE(result->frames[1].spatial, std::sqrt(0.15));
        QCOMPARE(result->spatial, std::sqrt(0.15) / 2);
        // D = 5. Nothing moves but c in the test, by 4: s' = sqrt(0.64 + t^2), s = a = t = 0.0003, one vertex of three.
        const double temporal = (std::sqrt(0.64 + 9e-8) - 0.0003) / 0.0003 / 3;
        QCOMPARE(result->frames[0].temporal, 0.0);
        QCOMPARE(result->frames[1].temporal, temporal);
        QCOMPARE(result->temporal, temporal);
        QCOMPARE(result->sted, std::hypot(std::sqrt(0.15) / 2, 9.144e-5 * temporal));
    }

    void asTheSlowReferenceSays_data() { tests::addRows(tests::namedAnimations()); }
    void asTheSlowReferenceSays()
    {
        QFETCH(int, row);
        const Sequence &reference = *tests::namedAnimations()[std::size_t(row)].sequence;
        compareWithSlowReference(reference, *tests::shaken(reference, 0.05f));
    }

    /// More frames than are worked on at a time: windows go over the seams.
    void longAnimations()
    {
        for (const std::uint32_t frames : {2u, 5u, 63u, 64u, 65u, 130u}) {
            const auto reference = tests::wave(tests::tetrahedron(), frames);
            compareWithSlowReference(*reference, *tests::shaken(*reference, 0.01f));
        }
    }

    /// More vertices than one thread takes at a time.
    void largeMeshes()
    {
        const auto reference = tests::wave(tests::grid(60, 40), 2);
        const auto test = tests::shaken(*reference, 0.002f);
        const StedResult result = *spatioTemporalDifference(*reference, *test);
        double spatial = 0;
        for (std::uint32_t f = 0; f < 2; ++f)
            spatial += result.frames[f].spatial / 2;
        QVERIFY(isNear(result.spatial, spatial));
        QVERIFY(result.spatial > 0.01 && result.spatial < 0.2);
        for (const unsigned threads : {1u, 2u, 5u}) {
            setThreadCount(threads);
            const StedResult again = *spatioTemporalDifference(*reference, *test);
            QVERIFY(again.sted == result.sted && again.spatial == result.spatial && again.temporal == result.temporal);
        }
        setThreadCount(0);
    }

    /// What moves along, turns along or grows evenly looks right.
    void whatEyesForgiveCountsForNothing()
    {
        const auto reference = tests::wave(tests::torus(), 6);
        std::vector<Vec3f> moved;
        for (const Vec3f &p : reference->allPositions())
            moved.push_back(Vec3f{-p.y, p.x, p.z} * 2 + Vec3f{8, 0, 0}); // exact in float
        const auto result = spatioTemporalDifference(*reference, Sequence(reference->connectivity(), moved));
        QVERIFY(result->spatial < 1e-6); // the shift rounds
        QVERIFY(result->temporal > 0.1); // twice as large is twice as fast
    }

    void equalAnimationsHaveNoError()
    {
        const auto animation = tests::noise(tests::torus());
        const auto result = spatioTemporalDifference(*animation, *animation);
        QVERIFY(result->sted == 0 && result->spatial == 0 && result->temporal == 0);
    }

    void whatCannotBeComparedIsRefused()
    {
        const auto four = tests::wave(tests::cube(), 4);
        const auto frames = spatioTemporalDifference(*four, *tests::wave(tests::cube(), 5));
        QVERIFY(!frames && frames.error().code == ErrorCode::MeshesDiffer);
        const auto order = spatioTemporalDifference(*four, *four, tests::Permutation{0, 1});
        QVERIFY(!order && order.error().code == ErrorCode::BadPermutation);
    }

    void cancelStops()
    {
        const auto animation = tests::wave(tests::cube(), 2000);
        std::atomic<int> reports = 0;
        Progress progress, *self = &progress;
        progress = Progress([&](double fraction) {
            ++reports;
            if (fraction > 0.1)
                self->cancel();
        });
        const auto result = spatioTemporalDifference(*animation, *animation, {}, progress);
        QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
        QVERIFY(reports > 0 && reports < 10);
        Progress cancelled;
        cancelled.cancel();
        QVERIFY(!spatioTemporalDifference(*animation, *animation, {}, cancelled));
    }
};

SANDREEL_TEST(TestSted)
#include "tst_sted.moc"
