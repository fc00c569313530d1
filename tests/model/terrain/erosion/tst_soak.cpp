// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/refine.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/erosion/heaps.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::terrain;

/// Redundancy removal and erosion by turns on the same ground, as a long session has it: in the work that this program
/// follows, that left a triangle without its neighbour and ended in a crash. SANDREEL_SOAK=1000000 in the environment
/// makes it a million of each.
class TestSoak final : public QObject
{
    Q_OBJECT

private slots:
    void removalAndErosionByTurns()
    {
        const std::uint64_t wanted = std::max(1500, qEnvironmentVariableIntValue("SANDREEL_SOAK"));
        Tin tin = tests::column(2000);
        TinEdit lift(tin);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            lift.setHeight(v, tin.arrays().heights[v] * 0.1 + 1);
        lift.commit();
        ErosionSettings settings;
        settings.longestEdge = 0.06;
        settings.flatError = 2e-3;
        Erosion erosion = *Erosion::create(settings, {});
        std::mt19937 random(2);
        const auto unit = [&] { return double(random()) / 4294967296.0; };
        std::uint64_t transfers = 0, removed = 0, rounds = 0;
        std::vector<Edit> history;
        for (; transfers < wanted || removed < wanted; ++rounds) {
            // A dab: a few new vertices in a small disc, raised or dug.
            TinEdit dab(tin);
            const Point2 centre{0.1 + 0.8 * unit(), 0.1 + 0.8 * unit()};
            const double height = 0.06 * (unit() - 0.5);
            for (int i = 0; i < 24; ++i) {
                const double angle = 6.283185307179586 * unit(), radius = 0.06 * std::sqrt(unit());
                const VertexId v =
                    dab.insert({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
                dab.setHeight(v, tin.arrays().heights[v] + height);
            }
            if (rounds % 5 == 0)
                (void)dab.constrain(random() % 4, VertexId(4 + random() % 4), OwnerId(rounds), Crossing::Split);
            if (rounds % 5 == 4)
                dab.releaseOwner(OwnerId(rounds - 4));
            const Edit change = dab.commit();
            erosion.activate(tin, change);
            TinEdit slide(tin);
            const auto ran = erosion.run(slide, 0.1);
            QVERIFY(ran);
            transfers += ran->transfers;
            removed += ran->removedVertices;
            // And some of what is flat now, wherever it is, before the next run goes on with what it had in mind.
            std::vector<VertexId> some;
            for (int i = 0; i < 200; ++i)
                some.push_back(VertexId(random() % tin.arrays().vertexSlots()));
            removed += removeRedundant(slide, some, settings.flatError, 5);
            history.push_back(slide.commit());
            if (rounds % 7 == 3) { // the erosion's list outlives an undo, and names triangles that are gone
                tin.swap(history.back());
                if (rounds % 2)
                    tin.swap(history.back());
            }
            history.clear();
            if (wanted < 10000 || rounds % 256 == 0) {
                const auto valid = validate(tin);
                QVERIFY2(valid, valid ? "" : valid.error().args[0].c_str());
                QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) < 1e-10);
            }
            if (rounds % 4096 == 4095)
                qInfo("%llu rounds, %llu transfers, %llu vertices removed", (unsigned long long)rounds + 1,
                      (unsigned long long)transfers, (unsigned long long)removed);
        }
        QVERIFY(validate(tin));
        QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) < 1e-10);
        qInfo("%llu rounds, %llu transfers, %llu vertices removed, %u left, drift %g", (unsigned long long)rounds,
              (unsigned long long)transfers, (unsigned long long)removed, tin.vertexCount(),
              tin.volume() / tin.ledger().expected() - 1);
    }
};

SANDREEL_TEST(TestSoak)
#include "tst_soak.moc"
