// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/refine.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/erosion/heaps.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numeric>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

/// Gentle hills of random vertices.
Tin hills(std::size_t count, double roughness)
{
    std::mt19937_64 random(11);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = 1 + 0.05 * std::sin(6 * p.x) * std::cos(5 * p.y) + roughness * unit();
    }
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

std::vector<VertexId> everyVertex(const Tin &tin)
{
    std::vector<VertexId> all(tin.arrays().vertexSlots());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// The two surfaces differ most where an edge of the one crosses an edge of the other, or at a vertex: looked at along
/// all edges of both, at many points.
double largestDifference(const Tin &a, const Tin &b)
{
    double largest = 0;
    for (const Tin *tin : {&a, &b}) {
        const TinArrays &arrays = tin->arrays();
        for (TriangleId t = 0; t < arrays.triangleSlots(); ++t)
            for (Corner c = cornerOf(t, 0); arrays.isTriangle(t) && c <= cornerOf(t, 2); ++c) {
                const Point2 p = arrays.pointAt(next(c)), q = arrays.pointAt(previous(c));
                for (int i = 0; i <= 16; ++i) {
                    const double s = i / 16.0;
                    const Point2 at{p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)};
                    largest = std::max(largest, std::abs(a.heightAt(at) - b.heightAt(at)));
                }
            }
    }
    return largest;
}

} // namespace

class TestRefine final : public QObject
{
    Q_OBJECT

private slots:
    void theErrorIsWithinItsBound_data()
    {
        QTest::addColumn<double>("roughness");
        QTest::addColumn<double>("error");
        QTest::addColumn<double>("used"); // how much of the bound at least
        QTest::newRow("smooth") << 0.0 << 2e-3 << 0.1;
        QTest::newRow("rough") << 5e-4 << 2e-3 << 0.1;
        QTest::newRow("tight") << 0.0 << 2e-4 << 0.1;
        QTest::newRow("loose") << 0.0 << 5e-2 << 0.01;
    }
    void theErrorIsWithinItsBound()
    {
        QFETCH(double, roughness);
        QFETCH(double, error);
        QFETCH(double, used);
        Tin tin = hills(3000, roughness);
        const Tin before = tin;
        TinEdit edit(tin);
        const std::uint32_t removed = removeRedundant(edit, everyVertex(tin), error, 10);
        edit.commit();
        QVERIFY2(removed > 200, qPrintable(QString::number(removed)));
        QCOMPARE(tin.vertexCount() + removed, before.vertexCount());
        QVERIFY(validate(tin));
        const double difference = largestDifference(tin, before);
        QVERIFY2(difference <= error, qPrintable(QString::number(difference)));
        QVERIFY2(difference > used * error, qPrintable(QString::number(difference)));
        QVERIFY(std::abs(tin.volume() - before.volume()) < 1e-13);
    }

    void theAngleSaysWhatIsFlat()
    {
        Tin tin = hills(2000, 5e-4);
        TinEdit edit(tin);
        const std::uint32_t byAngle = removeRedundant(edit, everyVertex(tin), 1, 0.01);
        QVERIFY(byAngle < 20); // rougher than that nearly everywhere
        QVERIFY(removeRedundant(edit, everyVertex(tin), 1, 10) > 1000);
    }

    void constraintsCornersAndVoidsStay()
    {
        Tin tin = hills(1500, 0);
        TinEdit edit(tin);
        const VertexId a = edit.insert({0.2, 0.2}), b = edit.insert({0.8, 0.7});
        QVERIFY(edit.constrain(a, b, 5));
        std::vector<TriangleId> some;
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            if (tin.arrays().isTriangle(t) && tin.arrays().pointAt(cornerOf(t, 0)).x > 0.9)
                some.push_back(t);
        edit.setVoid(some, true);
        const std::uint32_t voids = std::uint32_t(
            std::count_if(some.begin(), some.end(), [&](TriangleId t) { return tin.arrays().isVoid(t); }));
        QVERIFY(removeRedundant(edit, everyVertex(tin), 1, 10) > 500);
        QVERIFY(tin.arrays().isVertex(0) && tin.arrays().isVertex(3) && tin.arrays().isVertex(a));
        edit.commit();
        QVERIFY(validate(tin));
        std::uint32_t left = 0;
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            left += tin.arrays().isTriangle(t) && tin.arrays().isVoid(t);
        QCOMPARE(left, voids);
    }

    void noEdgeIsLongerThanAsked()
    {
        for (const double longest : {0.2, 0.05, 0.013}) {
            Tin tin = tests::column(200);
            const double volume = tin.volume();
            TinEdit edit(tin);
            std::vector<TriangleId> all(tin.arrays().triangleSlots());
            std::iota(all.begin(), all.end(), 0u);
            std::uint32_t added = 0;
            splitLongEdges(edit, all, longest, 1000000, added);
            edit.commit();
            QVERIFY(added > 0);
            for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
                if (tin.arrays().isTriangle(t))
                    QVERIFY(!hasLongEdge(tin.arrays(), t, longest));
            QVERIFY(validate(tin));
            QVERIFY(std::abs(tin.volume() - volume) < 1e-13);
        }
    }

    void splittingStopsAtItsLimit()
    {
        Tin tin = tests::column(200);
        TinEdit edit(tin);
        const std::vector<TriangleId> one{0};
        std::uint32_t added = 0;
        QVERIFY(!splitLongEdges(edit, one, 1e-6, 50, added).empty());
        QCOMPARE(added, 50u);
        edit.commit();
        QVERIFY(validate(tin));
    }

    /// What a vertex of the coarse ground spreads goes to ground as fine as the settings say.
    void materialMovesOverShortEdges()
    {
        Tin tin(Rectangle{{0, 0}, {1, 1}});
        TinEdit edit(tin);
        edit.insert({0.5, 0.5}, 0.2);
        const double volume = tin.volume() + edit.areaOf(4) * 0;
        ErosionSettings settings;
        settings.longestEdge = 0.05;
        Erosion erosion = *Erosion::create(settings, {});
        QVERIFY(erosion.settle(edit));
        edit.commit();
        QVERIFY(tests::steepestFace(tin) <= 30.1);
        QVERIFY(tin.vertexCount() < 5000);
        QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) < 1e-13 && volume > 0);
    }
};

SANDREEL_TEST(TestRefine)
#include "tst_refine.moc"
