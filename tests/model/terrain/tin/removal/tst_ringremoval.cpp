// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/cgaljudge.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <map>

using namespace model::terrain;

namespace {

constexpr OwnerId Fence = 3;

/// A star of `corners` points, every other one drawn in, as constrained edges; gives the vertices along it.
std::vector<VertexId> star(TinEdit &edit, Point2 centre, double radius, int corners, double drawnIn)
{
    std::vector<VertexId> tips;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, r = i % 2 ? radius * drawnIn : radius;
        tips.push_back(edit.insert({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)}));
    }
    std::multimap<VertexId, VertexId> edges;
    for (std::size_t i = 0; i < tips.size(); ++i)
        if (!edit.constrain(tips[i], tips[(i + 1) % tips.size()], Fence, Crossing::Split))
            qFatal("the star was refused");
    for (const ConstraintRecord &record : edit.tin().arrays().records.values())
        if (record.a != None && record.owner == Fence) {
            edges.emplace(record.a, record.b);
            edges.emplace(record.b, record.a);
        }
    // From tip to tip through what lies on the line; the second tip says which way.
    std::vector<VertexId> ring;
    const auto next = [&](VertexId v, VertexId before, VertexId to) {
        const auto [first, last] = edges.equal_range(v);
        const Point2 p = edit.tin().arrays().points[v], q = edit.tin().arrays().points[to];
        VertexId best = None;
        double cosine = -2;
        for (auto e = first; e != last; ++e) {
            const Point2 r = edit.tin().arrays().points[e->second];
            const double along = ((q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y)) /
                                 (std::hypot(q.x - p.x, q.y - p.y) * std::hypot(r.x - p.x, r.y - p.y));
            if (e->second != before && along > cosine) {
                cosine = along;
                best = e->second;
            }
        }
        return best;
    };
    for (std::size_t i = 0; i < tips.size(); ++i) {
        VertexId before = None;
        for (VertexId v = tips[i]; v != tips[(i + 1) % tips.size()];) {
            ring.push_back(v);
            const VertexId after = next(v, before, tips[(i + 1) % tips.size()]);
            before = v;
            v = after;
        }
    }
    return ring;
}

} // namespace

class TestRingRemoval final : public QObject
{
    Q_OBJECT

private slots:
    void theRestIsCgalsTriangulation_data()
    {
        QTest::addColumn<int>("ground");
        QTest::addColumn<int>("corners");
        QTest::addColumn<double>("drawnIn");
        for (const tests::Ground ground : tests::EveryGround)
            for (const int corners : {3, 12, 40})
                for (const double drawnIn : {1.0, 0.6, 0.2})
                    QTest::addRow("%s, %d corners to %g", tests::nameOf(ground), corners, drawnIn)
                        << int(ground) << corners << drawnIn;
    }
    void theRestIsCgalsTriangulation()
    {
        QFETCH(int, ground);
        QFETCH(int, corners);
        QFETCH(double, drawnIn);
        tests::PointSource source(tests::Ground(ground), 12);
        auto built = buildTin(source.points(600), source.domain());
        const Rectangle &domain = source.domain();
        const double size = std::min(domain.high.x - domain.low.x, domain.high.y - domain.low.y);
        const Point2 centre{(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
        std::vector<VertexId> ring;
        {
            TinEdit edit(built->tin, VolumeRule::Keep);
            ring = star(edit, centre, 0.37 * size, corners, drawnIn);
            edit.commit();
        }
        Tin &tin = built->tin;
        Tin one = tin;
        const std::uint64_t before = tin.fingerprint();
        const double volume = tin.volume();
        TinEdit edit(tin, VolumeRule::Keep);
        const std::uint32_t count = tin.vertexCount();
        const bool isDone = edit.removeInside(ring);
        QVERIFY(std::abs(edit.leak() - (tin.volume() - volume)) <= 1e-12 * std::abs(volume) + 1e-14);
        Edit done = edit.commit();
        QCOMPARE(isDone, tin.vertexCount() < count);
        QVERIFY(validate(tin));
        QCOMPARE(tests::differenceFromCgal(tin), std::string());

        // One by one: whatever is inside the ring, by its winding number.
        TinEdit slow(one, VolumeRule::Keep);
        const TinArrays &arrays = one.arrays();
        for (VertexId v = 0; v < arrays.vertexSlots(); ++v) {
            if (!arrays.isVertex(v) || arrays.constraints[v] != None)
                continue;
            double turned = 0;
            const Point2 p = arrays.points[v];
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point2 a = arrays.points[ring[i]], b = arrays.points[ring[(i + 1) % ring.size()]];
                turned += std::atan2((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x),
                                     (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y));
            }
            if (turned > M_PI && slow.canRemove(v))
                slow.remove(v);
        }
        slow.commit();
        QCOMPARE(tin.vertexCount(), one.vertexCount());
        QCOMPARE(tin.triangleCount(), one.triangleCount());
        QVERIFY(std::abs(tin.volume() - one.volume()) <= 1e-12 * std::abs(volume) + 1e-14);

        const std::uint64_t after = tin.fingerprint();
        tin.swap(done);
        QCOMPARE(tin.fingerprint(), before);
        tin.swap(done);
        QCOMPARE(tin.fingerprint(), after);
    }

    void whatCannotGoAtOnceStays_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : {"a side without constraint", "clockwise", "a constraint inside", "a constraint across",
                                 "a void inside", "a vertex twice", "two vertices"})
            QTest::newRow(what) << what;
    }
    void whatCannotGoAtOnceStays()
    {
        QFETCH(QString, what);
        tests::PointSource source(tests::Ground::Random, 4);
        auto built = buildTin(source.points(300), source.domain());
        Tin &tin = built->tin;
        TinEdit edit(tin, VolumeRule::Keep);
        std::vector<VertexId> ring = star(edit, {0.5, 0.5}, 0.3, 8, 1);
        if (what == "a side without constraint")
            edit.releaseAll(ring[0], ring[1]);
        else if (what == "clockwise")
            std::reverse(ring.begin(), ring.end());
        else if (what == "a constraint inside")
            QVERIFY(edit.constrain(edit.insert({0.45, 0.5}), edit.insert({0.55, 0.5}), 9));
        else if (what == "a constraint across")
            QVERIFY(edit.constrain(ring[0], ring[4], 9));
        else if (what == "a void inside")
            edit.setVoid(std::vector{tin.triangleAt({0.5, 0.5})}, true);
        else if (what == "a vertex twice")
            ring.push_back(ring[2]);
        else
            ring.resize(2);
        const std::uint64_t before = tin.fingerprint();
        QVERIFY(!edit.removeInside(ring));
        QCOMPARE(tin.fingerprint(), before);
    }

    /// A ring may share sides with the border.
    void theWholeDomainCanBeEmptied()
    {
        tests::PointSource source(tests::Ground::Random, 4);
        auto built = buildTin(source.points(300), source.domain());
        TinEdit edit(built->tin);
        const std::vector<VertexId> corners{0, 1, 2, 3};
        QVERIFY(edit.removeInside(corners));
        edit.commit();
        QVERIFY(validate(built->tin));
        QCOMPARE(built->tin.vertexCount(), 4u);
        QCOMPARE(built->tin.triangleCount(), 2u);
    }
};

SANDREEL_TEST(TestRingRemoval)
#include "tst_ringremoval.moc"
