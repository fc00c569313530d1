// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/erosion/heaps.h"
#include "tests/support/testmain.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

constexpr double Degree = M_PI / 180;

Erosion makeErosion(const ErosionSettings &settings = {})
{
    return *Erosion::create(settings, {});
}

double relativeDrift(const Tin &tin, double before)
{
    return std::abs(tin.volume() - before) / before;
}

/// Of the cone of this volume at the angle of repose.
struct Cone
{
    double radius, height;

    Cone(double volume, double degrees)
        : radius(std::cbrt(3 * volume / (M_PI * std::tan(degrees * Degree))))
        , height(radius * std::tan(degrees * Degree))
    {}
};

} // namespace

class TestErosion final : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setThreadCount(0); }

    void aColumnBecomesTheConeOfItsVolume()
    {
        Tin tin = tests::column(40000);
        const double volume = tin.volume();
        Erosion erosion = makeErosion();
        ErosionStatistics statistics;
        tests::settle(tin, erosion, &statistics);
        QVERIFY(validate(tin));
        QVERIFY(tests::steepestFace(tin) <= 30.1);
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        QVERIFY(statistics.isAtRest && statistics.transfers > 1000);
        const Cone cone(volume, 30);
        double top = 0, covered = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            top = std::max(top, tin.arrays().heights[v]);
            if (tin.arrays().heights[v] > 1e-9)
                covered += dualArea(tin.arrays(), v);
        }
        QVERIFY2(std::abs(top / cone.height - 1) < 0.03, qPrintable(QString::number(top / cone.height)));
        const double radius = std::sqrt(covered / M_PI);
        QVERIFY2(std::abs(radius / cone.radius - 1) < 0.03, qPrintable(QString::number(radius / cone.radius)));
        double difference = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            const Point2 p = tin.arrays().points[v];
            const double ideal = std::max(0.0, cone.height * (1 - std::hypot(p.x - 0.5, p.y - 0.5) / cone.radius));
            difference += dualArea(tin.arrays(), v) * std::abs(tin.arrays().heights[v] - ideal);
        }
        QVERIFY2(difference < 0.03 * volume, qPrintable(QString::number(difference / volume)));
        // What lies elsewhere now: what the column has outside the cone.
        QVERIFY(std::abs(statistics.movedVolume - tin.ledger().moved.value()) < 1e-15);
        QVERIFY(statistics.movedVolume > 0.5 * volume && statistics.movedVolume < volume);
    }

    void threadsAndRepetitionChangeNoByte_data()
    {
        QTest::addColumn<bool>("isCoarse");
        QTest::addColumn<int>("rule");
        QTest::addColumn<int>("layers");
        QTest::newRow("face") << false << int(ErosionRule::Face) << 0;
        QTest::newRow("edge") << false << int(ErosionRule::Edge) << 0;
        QTest::newRow("coarse pass") << true << int(ErosionRule::Face) << 0;
        QTest::newRow("one layer") << false << int(ErosionRule::Face) << 1;
        QTest::newRow("two layers") << false << int(ErosionRule::Face) << 2;
    }
    void threadsAndRepetitionChangeNoByte()
    {
        QFETCH(bool, isCoarse);
        QFETCH(int, rule);
        QFETCH(int, layers);
        const Material sand = material(MaterialPreset::DrySand);
        std::string first;
        for (const unsigned threads : {1u, 2u, 3u, 1u}) {
            setThreadCount(threads);
            Tin tin = layers ? tests::layeredColumn(6000, std::uint32_t(layers)) : tests::column(6000);
            ErosionSettings settings;
            settings.hasCoarsePass = isCoarse;
            settings.rule = ErosionRule(rule);
            settings.longestEdge = 0.015;
            settings.flatError = 1e-4;
            Erosion erosion = *Erosion::create(settings, std::span(&sand, 1));
            ErosionStatistics statistics;
            tests::settle(tin, erosion, &statistics);
            QVERIFY(statistics.addedVertices > 100 && statistics.removedVertices > 10);
            QVERIFY(validate(tin));
            if (first.empty())
                first = tests::bytesOf(tin);
            QVERIFY(tests::bytesOf(tin) == first);
        }
    }

    void undoIsExact()
    {
        Tin tin = tests::layeredColumn(3000, 2);
        const std::string before = tests::bytesOf(tin);
        const Material sand = material(MaterialPreset::DrySand);
        ErosionSettings settings;
        settings.longestEdge = 0.02;
        settings.flatError = 1e-3;
        Erosion erosion = *Erosion::create(settings, std::span(&sand, 1));
        Edit edit = tests::settle(tin, erosion);
        const std::string after = tests::bytesOf(tin);
        tin.swap(edit);
        QVERIFY(tests::bytesOf(tin) == before);
        tin.swap(edit);
        QVERIFY(tests::bytesOf(tin) == after);
    }

    void runsComeToRestWhereSettlingDoes()
    {
        Tin tin = tests::column(3000);
        const double volume = tin.volume();
        ErosionSettings settings;
        settings.startAngle = 1.5;
        Erosion erosion = makeErosion(settings);
        erosion.activateAll(tin);
        QVERIFY(!erosion.isAtRest());
        int frames = 0;
        for (; !erosion.isAtRest() && frames < 10000; ++frames) {
            TinEdit edit(tin);
            const auto ran = erosion.run(edit, 1.0 / 60);
            QVERIFY(ran && ran->sweeps <= 2);
            edit.commit();
        }
        QVERIFY(frames > 20 && frames < 10000);
        QVERIFY(tests::steepestFace(tin) <= 31.6); // what does not move starts later
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        QVERIFY(validate(tin));
    }

    void whatIsLeftOfASweepCountsNextTime()
    {
        for (const int portions : {1, 3, 16, 128}) {
            Tin tin = tests::column(2000);
            Erosion erosion = makeErosion(); // 120 sweeps a second
            erosion.activateAll(tin);
            std::uint64_t sweeps = 0;
            for (int k = 0; k < portions; ++k) {
                TinEdit edit(tin);
                sweeps += erosion.run(edit, 0.25 / portions)->sweeps;
                edit.commit();
            }
            QVERIFY(sweeps == 30 || sweeps == 29); // but for rounding of the portions
        }
    }

    void aBudgetEndsARunAndTheNextGoesOn()
    {
        Tin tin = tests::column(8000);
        Erosion erosion = makeErosion();
        erosion.activateAll(tin);
        TinEdit edit(tin);
        const auto first = erosion.run(edit, 1e6, {100, INFINITY});
        QVERIFY(first && first->transfers >= 100 && first->sweeps == 1 && !first->isAtRest);
        const auto none = erosion.run(edit, 1e6, {1000000000, 0});
        QVERIFY(none && none->sweeps == 1);
        const auto rest = erosion.run(edit, 1e300);
        QVERIFY(rest && rest->isAtRest && rest->sweeps > 10);
        QCOMPARE(erosion.run(edit, 1)->transfers, std::uint64_t(0));
    }

    /// Without any time at all, each run still gives the next lot its turn, and no more than that.
    void whatIsTooMuchForTheTimeTakesTurns()
    {
        Tin tin = tests::column(30000);
        const double volume = tin.volume();
        const std::string before = tests::bytesOf(tin);
        Erosion erosion = makeErosion();
        erosion.activateAll(tin);
        erosion.activateAll(tin);
        const std::size_t all = erosion.activeCount();
        QCOMPARE(all, std::size_t(tin.triangleCount()));
        std::vector<Edit> edits;
        std::uint64_t most = 0;
        bool isAtRest = false;
        for (int frame = 0; !isAtRest && frame < 20000; ++frame) {
            TinEdit edit(tin);
            const auto ran = erosion.run(edit, 1, {.milliseconds = 0});
            QVERIFY(ran && ran->sweeps <= 1);
            most = std::max(most, ran->visits);
            isAtRest = ran->isAtRest;
            edits.push_back(edit.commit());
            QVERIFY(erosion.activeCount() <= all); // each of them once
        }
        QVERIFY(isAtRest && erosion.isAtRest());
        QVERIFY2(most < all / 4, qPrintable(QString::number(most)));
        QVERIFY(edits.size() > 20);
        QVERIFY(tests::steepestFace(tin) <= 31.6);
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        QVERIFY(validate(tin));
        const std::string after = tests::bytesOf(tin);
        for (std::size_t i = edits.size(); i-- > 0;)
            tin.swap(edits[i]);
        QVERIFY(tests::bytesOf(tin) == before);
        for (Edit &edit : edits)
            tin.swap(edit);
        QVERIFY(tests::bytesOf(tin) == after);
    }

    /// Long enough for all of it, a time changes nothing.
    void enoughTimeIsAsGoodAsNoLimit()
    {
        Tin limited = tests::column(1500), free = limited;
        for (Tin *const tin : {&limited, &free}) {
            Erosion erosion = makeErosion();
            erosion.activateAll(*tin);
            for (int frame = 0; frame < 20; ++frame) {
                TinEdit edit(*tin);
                QVERIFY(tin == &free ? erosion.run(edit, 0.05) : erosion.run(edit, 0.05, {.milliseconds = 1e9}));
                edit.commit();
            }
        }
        QVERIFY(tests::bytesOf(limited) == tests::bytesOf(free));
    }

    void onlyWhatIsActiveSlides()
    {
        Tin tin = tests::column(2000);
        const std::string before = tests::bytesOf(tin);
        Erosion erosion = makeErosion();
        {
            TinEdit edit(tin);
            QVERIFY(erosion.run(edit, 1)->isAtRest);
            edit.commit();
        }
        QVERIFY(tests::bytesOf(tin) == before);
        // A brush raises a vertex far from the column: its surroundings slide, the column does not.
        TinEdit brush(tin);
        const VertexId v = brush.insert({0.1, 0.1}, 0.2);
        const Edit edit = brush.commit();
        erosion.activate(tin, edit);
        const double far = tin.heightAt({0.5, 0.5});
        TinEdit slide(tin);
        const auto ran = erosion.run(slide, 100);
        QVERIFY(ran && ran->isAtRest && ran->transfers > 10);
        QVERIFY(tin.arrays().heights[v] < 0.1);
        QCOMPARE(tin.heightAt({0.5, 0.5}), far);
        QVERIFY(tests::steepestFace(tin) > 80); // the column's wall
    }

    void theEdgeRuleLevelsEdgesAndLeavesFacesSteep()
    {
        Tin tin = tests::column(4000);
        const double volume = tin.volume();
        ErosionSettings settings;
        settings.rule = ErosionRule::Edge;
        Erosion erosion = makeErosion(settings);
        tests::settle(tin, erosion);
        QVERIFY(tests::steepestEdge(tin) <= 30.1);
        QVERIFY(tests::steepestFace(tin) > 32);
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
    }

    void voidsAndBordersAreWalls()
    {
        Tin tin = tests::column(4000);
        TinEdit edit(tin);
        std::vector<TriangleId> east;
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            if (tin.arrays().pointAt(cornerOf(t, 0)).x > 0.65)
                east.push_back(t);
        edit.setVoid(east, true);
        edit.commit();
        const TinArrays before = tin.arrays();
        const double volume = tin.volume();
        Erosion erosion = makeErosion();
        tests::settle(tin, erosion);
        QVERIFY(validate(tin));
        QVERIFY(tests::steepestFace(tin) <= 30.1);
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        double piled = 0;
        for (VertexId v = 0; v < before.vertexSlots(); ++v) {
            if (dualArea(before, v) == 0)
                QCOMPARE(tin.arrays().heights[v], before.heights[v]); // within the void
            else if (before.constraints[v] != None)
                piled = std::max(piled, tin.arrays().heights[v]);
        }
        QVERIFY(piled > 0.05); // against the wall
    }

    void levelGroundAndOneTriangleAreAtRest()
    {
        Tin flat(Rectangle{{0, 0}, {1, 1}});
        Erosion erosion = makeErosion();
        ErosionStatistics statistics;
        tests::settle(flat, erosion, &statistics);
        QVERIFY(statistics.isAtRest);
        QCOMPARE(statistics.transfers, std::uint64_t(0));
        // A tilted square: two triangles, each too steep.
        TinEdit edit(flat);
        edit.setHeight(0, 2);
        edit.setHeight(3, 2);
        QVERIFY(erosion.settle(edit));
        QVERIFY(tests::steepestFace(flat) <= 30.1);
        QVERIFY(std::abs(flat.volume() - 1) < 1e-15);
    }

    void theCoarsePassKeepsVolumeAndCone()
    {
        Tin tin = tests::column(12000);
        const double volume = tin.volume();
        ErosionSettings settings;
        Erosion plain = makeErosion(settings);
        settings.hasCoarsePass = true;
        Erosion coarse = makeErosion(settings);
        ErosionStatistics with, without;
        Tin other = tin;
        tests::settle(tin, coarse, &with);
        tests::settle(other, plain, &without);
        QVERIFY(tests::steepestFace(tin) <= 30.1);
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        QVERIFY(with.transfers < without.transfers);
        double difference = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            difference += dualArea(tin.arrays(), v) * std::abs(tin.arrays().heights[v] - other.arrays().heights[v]);
        QVERIFY2(difference < 0.1 * volume, qPrintable(QString::number(difference / volume)));
    }

    void cancellingLeavesTheEditToBeRolledBack()
    {
        Tin tin = tests::column(8000);
        const std::string before = tests::bytesOf(tin);
        Erosion erosion = makeErosion();
        for (const double at : {0.0, 0.3}) {
            Progress *handle = nullptr;
            Progress progress([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            handle = &progress;
            if (at == 0)
                progress.cancel();
            TinEdit edit(tin);
            const auto settled = erosion.settle(edit, progress);
            QVERIFY(!settled);
            QCOMPARE(settled.error().code, ErrorCode::Cancelled);
            edit.rollBack();
            QVERIFY(tests::bytesOf(tin) == before);
        }
        tests::settle(tin, erosion); // and nothing is left over
        QVERIFY(tests::steepestFace(tin) <= 30.1);
    }

    /// Ten thousand edits, each followed by erosion, with constraints, removals and undo between them.
    void mixedEditsWithErosionKeepTheBooks()
    {
        Tin tin = tests::column(800);
        TinEdit lift(tin);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            lift.setHeight(v, tin.arrays().heights[v] + 1);
        lift.commit();
        ErosionSettings settings;
        settings.flatError = 1e-3;
        Erosion erosion = makeErosion(settings);
        std::mt19937 random(3);
        const auto unit = [&] { return double(random()) / 4294967296.0; };
        const auto someVertex = [&] {
            for (;;)
                if (const VertexId v = VertexId(random() % tin.arrays().vertexSlots()); tin.arrays().isVertex(v))
                    return v;
        };
        double worst = 0;
        for (int i = 0; i < 10000; ++i) {
            TinEdit edit(tin, i % 3 ? VolumeRule::GiveBack : VolumeRule::Keep);
            const VertexId v = edit.insert({unit(), unit()});
            switch (i % 5) {
            case 0:
                (void)edit.constrain(v, v == 3 ? 2 : 3, OwnerId(i), Crossing::Split);
                break;
            case 1:
                edit.releaseOwner(OwnerId(i - 1));
                break;
            case 2:
                if (const VertexId w = someVertex(); edit.canRemove(w))
                    edit.remove(w);
                break;
            default:
                edit.setHeight(v, tin.arrays().heights[v] + unit() * 0.1 - 0.05);
            }
            Edit done = edit.commit();
            erosion.activate(tin, done);
            if (i % 64 == 63) {
                tin.swap(done);
                tin.swap(done);
            }
            TinEdit slide(tin);
            QVERIFY(erosion.run(slide, 0.02));
            slide.commit();
            if (i % 100 == 0)
                worst = std::max(worst, relativeDrift(tin, tin.ledger().expected()));
        }
        QVERIFY(tin.ledger().moved.value() > 0 && tin.ledger().added.value() > 0.1);
        worst = std::max(worst, relativeDrift(tin, tin.ledger().expected()));
        QVERIFY2(worst < 1e-10, QByteArray::number(worst).constData());
        QVERIFY(validate(tin));
    }

    void settingsOutOfRangeAreNamed()
    {
        const struct
        {
            const char *name;
            std::function<void(ErosionSettings &)> spoil;
        } rows[] = {
            {"rule", [](ErosionSettings &s) { s.rule = ErosionRule(7); }},
            {"relaxation", [](ErosionSettings &s) { s.relaxation = 2; }},
            {"relaxation", [](ErosionSettings &s) { s.relaxation = 0; }},
            {"startAngle", [](ErosionSettings &s) { s.startAngle = NAN; }},
            {"sweepsPerSecond", [](ErosionSettings &s) { s.sweepsPerSecond = 0; }},
            {"longestEdge", [](ErosionSettings &s) { s.longestEdge = -1; }},
            {"flatError", [](ErosionSettings &s) { s.flatError = INFINITY; }},
            {"flatAngle", [](ErosionSettings &s) { s.flatAngle = 91; }},
            {"material.criticalAngles[0].degrees",
             [](ErosionSettings &s) {
                 s.material.criticalAngles = {{0, 0}};
             }},
            {"material.criticalAngles[0].degrees",
             [](ErosionSettings &s) {
                 s.material.criticalAngles = {{0, 90}};
             }},
            {"material.humidity", [](ErosionSettings &s) { s.material.humidity = 1.5; }},
        };
        for (const auto &row : rows) {
            ErosionSettings settings;
            row.spoil(settings);
            const auto created = Erosion::create(settings, {});
            QVERIFY2(!created, row.name);
            QCOMPARE(created.error().code, ErrorCode::BadSetting);
            QCOMPARE(created.error().args[0], std::string(row.name));
        }
        std::vector<Material> materials(2);
        materials[1].liquidity = 9;
        const auto created = Erosion::create({}, materials);
        QVERIFY(!created);
        QCOMPARE(created.error().args[0], std::string("materials[1].liquidity"));
    }

    void timeThatIsNoneIsNamedOrDoesNothing()
    {
        Tin tin = tests::column(500);
        const std::string before = tests::bytesOf(tin);
        Erosion erosion = makeErosion();
        erosion.activateAll(tin);
        TinEdit edit(tin);
        for (const double seconds : {-1.0, double(NAN), double(-INFINITY)}) {
            const auto ran = erosion.run(edit, seconds);
            QVERIFY(!ran);
            QCOMPARE(ran.error().code, ErrorCode::BadSetting);
            QCOMPARE(ran.error().args[0], std::string("seconds"));
        }
        QCOMPARE(erosion.run(edit, 0)->sweeps, std::uint64_t(0));
        QCOMPARE(erosion.run(edit, 1e-9)->sweeps, std::uint64_t(0));
        edit.commit();
        QVERIFY(tests::bytesOf(tin) == before);
        TinEdit ever(tin);
        QVERIFY(erosion.run(ever, INFINITY)->isAtRest);
        ever.commit();
        QVERIFY(validate(tin));
    }

    /// Points on constrained lines, but for their rounding: triangles whose height is that of an atom, which no heights
    /// that are rounded make as level as they should be.
    void sliversComeToRest_data()
    {
        QTest::addColumn<ErosionRule>("rule");
        QTest::newRow("face") << ErosionRule::Face;
        QTest::newRow("edge") << ErosionRule::Edge;
    }
    void sliversComeToRest()
    {
        QFETCH(ErosionRule, rule);
        std::mt19937 random(20261122);
        std::uniform_real_distribution<double> place(0.05, 0.95), height(0, 0.3);
        std::vector<Point3> points;
        for (int i = 0; i < 400; ++i)
            points.push_back({place(random), place(random), height(random)});
        Tin tin = buildTin(points, {{0, 0}, {1, 1}})->tin;
        TinEdit lines(tin);
        for (OwnerId owner = 1; owner <= 25; ++owner) {
            const Point2 a{place(random), place(random)}, b{place(random), place(random)};
            const VertexId first = lines.insert(a, height(random)), last = lines.insert(b, height(random));
            if (!lines.constrain(first, last, owner, Crossing::Release))
                continue;
            for (int i = 1; i < 20; ++i) {
                const double s = i / 20.0;
                lines.insert({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}, height(random));
            }
        }
        lines.commit();
        const TinArrays &arrays = tin.arrays();
        // The least height of a triangle: its double area by its longest edge.
        const auto thicknessOf = [&](TriangleId t) {
            double longest = 0;
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Point2 p = arrays.pointAt(next(c)), q = arrays.pointAt(previous(c));
                longest = std::max(longest, std::hypot(p.x - q.x, p.y - q.y));
            }
            const Point2 a = arrays.pointAt(cornerOf(t, 0)), b = arrays.pointAt(cornerOf(t, 1)),
                         c = arrays.pointAt(cornerOf(t, 2));
            return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / longest;
        };
        int slivers = 0;
        for (TriangleId t = 0; t < arrays.triangleSlots(); ++t)
            slivers += arrays.isTriangle(t) && thicknessOf(t) < 1e-12;
        QVERIFY2(slivers > 50, qPrintable(QString::number(slivers)));

        const double volume = tin.volume();
        ErosionSettings settings;
        settings.rule = rule;
        Erosion erosion = makeErosion(settings);
        const Progress progress;
        TinEdit edit(tin);
        auto settled = std::async(std::launch::async, [&] { return erosion.settle(edit, progress).has_value(); });
        const bool isInTime = settled.wait_for(std::chrono::seconds(60)) == std::future_status::ready;
        progress.cancel();
        QVERIFY(settled.get() && isInTime);
        edit.commit();
        QVERIFY(relativeDrift(tin, volume) < 1e-12);
        if (rule == ErosionRule::Face)
            for (TriangleId t = 0; t < arrays.triangleSlots(); ++t)
                if (arrays.isTriangle(t) && thicknessOf(t) > 1e-5) {
                    const Gradient g = gradientOf(arrays, t);
                    QVERIFY(std::atan(std::hypot(g.x, g.y)) / Degree <= 30.1);
                }
    }

    void anglesAtTheirLimitsComeToRest()
    {
        for (const double degrees : {SmallestCriticalAngle, LargestCriticalAngle}) {
            Tin tin = tests::column(300);
            const double volume = tin.volume();
            ErosionSettings settings;
            settings.material.criticalAngles = {{0, degrees}};
            settings.startAngle = 10;
            Erosion erosion = makeErosion(settings);
            tests::settle(tin, erosion);
            QVERIFY(tests::steepestFace(tin) <= degrees + 0.1);
            QVERIFY(relativeDrift(tin, volume) < 1e-12);
        }
    }
};

SANDREEL_TEST(TestErosion)
#include "tst_erosion.moc"
