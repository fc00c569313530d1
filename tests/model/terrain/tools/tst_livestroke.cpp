// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/livestroke.h"
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <memory>

using namespace model;
using namespace model::terrain;

namespace {

const std::vector<PathPoint> Bent{
    {{0.2, 0.25}, 0.5, 0}, {{0.75, 0.3}, 1, 2}, {{0.5, 0.7}, 0.75, 1}, {{0.1, 0.7}, 1, 0}};

struct Drawn
{
    std::vector<Edit> edits;
    StrokeReport report;
};

/// Points one by one, an edit for every `most` stamps, as an editor does it.
Drawn drawLive(Tin &tin, const Stroke &stroke, std::size_t most)
{
    Drawn drawn;
    ToolMemory memory;
    auto live = LiveStroke::begin(tin, stroke.tool, stroke.symmetry, 1);
    const auto draw = [&] {
        while (live->isDue()) {
            TinEdit edit(tin, VolumeRule::Keep);
            [&] { QVERIFY(live->draw(edit, memory, most)); }();
            drawn.edits.push_back(edit.commit());
            live->note(drawn.edits.back());
        }
    };
    for (const PathPoint &point : stroke.path) {
        [&] { QVERIFY(live->add(point)); }();
        draw();
    }
    live->end();
    draw();
    drawn.report = live->report();
    return drawn;
}

Brush brush(double radius)
{
    Brush brush;
    brush.radius = radius;
    return brush;
}

std::vector<std::pair<const char *, Tool>> everyTool()
{
    Imprint imprint;
    imprint.radius = 0.05;
    imprint.depth = 0.03;
    Imprint plough = imprint;
    plough.outline = Outline::wedge();
    plough.doesFollowDirection = true;
    plough.mask.highestSlope = 40;
    plough.mask.lowestHeight = 0.9;
    Rake rake;
    rake.width = 0.1;
    rake.depth = 0.01;
    Restore restore{brush(0.06), 0.5, {[](Point2 p) { return p.x; }, nullptr}};
    Noise noise;
    noise.brush = brush(0.05);
    noise.amplitude = 0.01;
    Brush masked = brush(0.06);
    masked.mask.highestHeight = 1.05;
    masked.doesPressureScaleRadius = true;
    return {{"imprint", imprint},
            {"plough", plough},
            {"rake", rake},
            {"raise", Raise{brush(0.06), 0.02}},
            {"lower", Lower{masked, 0.02}},
            {"flatten", Flatten{brush(0.06), 0.5, {}}},
            {"smooth", Smooth{brush(0.06), 0.7}},
            {"noise", noise},
            {"ramp", Ramp{brush(0.06), {}, {}}},
            {"restore", restore},
            {"pour", Pour{brush(0.06), 1e-4}},
            {"scoop", Scoop{brush(0.06), 0.02}},
            {"breakline", Breakline{0.02, {}, Crossing::Split}}};
}

} // namespace

class TestLiveStroke final : public QObject
{
    Q_OBJECT

private slots:
    void wettingMovesNothingButHumidity()
    {
        Tin tin = tests::ground(800);
        {
            TinEdit edit(tin);
            edit.addLayer(0, 0);
            for (VertexId v = 0; v < tin.vertexCount(); ++v)
                if (tin.arrays().points[v].x < 0.6)
                    edit.setLayer(v, 0, {0.1, 0.25f});
            edit.commit();
        }
        const std::vector<double> heights(tin.arrays().heights.values().begin(), tin.arrays().heights.values().end());
        Moisten tool{brush(0.2), 1, 1};
        tool.brush.detail = 0;
        tool.brush.falloff = Falloff::Constant;
        const auto drawn = draw(tin, {tool, {{{0.5, 0.5}, 1, 0}}, {}});
        QVERIFY(drawn);
        QCOMPARE(drawn->report.moved, 0.0);
        QCOMPARE(drawn->report.added, 0.0);
        int wet = 0;
        for (VertexId v = 0; v < tin.vertexCount(); ++v) {
            const Point2 p = tin.arrays().points[v];
            const bool isUnder = std::hypot(p.x - 0.5, p.y - 0.5) <= 0.2, hasSand = p.x < 0.6;
            QCOMPARE(tin.arrays().heights[v], heights[v]);
            QCOMPARE(tin.arrays().sample(v, 0).humidity, !hasSand ? 0.f : isUnder ? 1.f : 0.25f);
            wet += isUnder && hasSand;
        }
        QVERIFY(wet > 20);
    }
    void anyInputRateDrawsTheSameBytes_data()
    {
        QTest::addColumn<int>("tool");
        QTest::addColumn<int>("symmetry");
        for (std::size_t i = 0; i < everyTool().size(); ++i) {
            QTest::addRow("%s", everyTool()[i].first) << int(i) << int(Symmetry::Kind::Off);
            QTest::addRow("%s radial", everyTool()[i].first) << int(i) << int(Symmetry::Kind::Radial);
        }
    }
    void anyInputRateDrawsTheSameBytes()
    {
        QFETCH(int, tool);
        QFETCH(int, symmetry);
        Stroke stroke{everyTool()[std::size_t(tool)].second, Bent, {Symmetry::Kind(symmetry), {0.5, 0.5}, 3}};
        const Tin start = tests::ground(2000);
        Tin whole = start;
        const auto drawn = draw(whole, stroke, 1);
        QVERIFY(drawn);
        const std::uint64_t wanted = whole.fingerprint();
        QCOMPARE(wanted != start.fingerprint(), !std::holds_alternative<Moisten>(stroke.tool));
        for (const int count : {0, 60})
            for (const std::size_t most : {std::size_t(1), std::size_t(7)}) {
                Tin tin = start;
                stroke.path = tests::oversampled(Bent, count, unsigned(count));
                Drawn live = drawLive(tin, stroke, most);
                QCOMPARE(tin.fingerprint(), wanted);
                QCOMPARE(live.report.stamps, drawn->report.stamps);
                QCOMPARE(live.report.nextOwner, drawn->report.nextOwner);
                QVERIFY(std::abs(live.report.added - drawn->report.added) < 1e-12);
                QVERIFY(std::abs(live.report.moved - drawn->report.moved) < 1e-12);
                QVERIFY(findDefects(tin).empty());
                for (std::size_t i = live.edits.size(); i-- > 0;)
                    tin.swap(live.edits[i]);
                QCOMPARE(tin.fingerprint(), start.fingerprint());
                for (Edit &edit : live.edits)
                    tin.swap(edit);
                QCOMPARE(tin.fingerprint(), wanted);
            }
    }
    void theFirstStampOfABrushDoesNotWait()
    {
        Tin tin = tests::ground(500);
        auto brush = LiveStroke::begin(tin, Raise{{}, 0.1}, {}, 1);
        QVERIFY(brush && brush->add({{0.5, 0.5}, 1, 0}));
        QVERIFY(brush->isDue());
        // An imprint heaps its rim where it is going.
        auto imprint = LiveStroke::begin(tin, Imprint(), {}, 1);
        QVERIFY(imprint && imprint->add({{0.5, 0.5}, 1, 0}));
        QVERIFY(!imprint->isDue());
        imprint->end();
        QVERIFY(imprint->isDue());
    }
    void depthGoesByTheGroundBeforeTheStroke()
    {
        // Back and forth over one place: each passing would dig deeper if it went by the ground that it finds.
        Tin tin = tests::ground(3000, 0);
        Imprint tool;
        tool.radius = 0.06;
        tool.depth = 0.05;
        std::vector<PathPoint> path;
        for (int i = 0; i < 6; ++i)
            path.push_back({{i % 2 ? 0.7 : 0.3, 0.5}, 1, 0});
        drawLive(tin, {tool, path, {}}, 1);
        double lowest = 1;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            if (tin.arrays().isVertex(v))
                lowest = std::min(lowest, tin.arrays().heights[v]);
        QVERIFY2(std::abs(lowest - 0.95) < 1e-9, qPrintable(QString::number(lowest)));
    }
    void badPointsAreRefusedAndTheStrokeGoesOn()
    {
        Tin tin = tests::ground(200);
        auto live = LiveStroke::begin(tin, Raise{{}, 0.1}, {}, 1);
        QVERIFY(live);
        QVERIFY(live->add({{0.1, 0.5}, 1, 0}));
        QCOMPARE(live->add({{std::nan(""), 0.5}, 1, 0}).error().code, ErrorCode::NonFinite);
        QCOMPARE(live->add({{0.2, 0.5}, 2, 0}).error().code, ErrorCode::BadSetting);
        QCOMPARE(live->add({{1e9, 0.5}, 1, 0}).error().code, ErrorCode::LimitExceeded);
        QVERIFY(live->add({{0.6, 0.5}, 1, 0}));
        live->end();
        ToolMemory memory;
        TinEdit edit(tin, VolumeRule::Keep);
        QVERIFY(live->draw(edit, memory));
        edit.commit();
        QCOMPARE(live->report().stamps, 3u);
        QCOMPARE(LiveStroke::begin(tin, Raise{{}, std::nan("")}, {}, 1).error().code, ErrorCode::BadSetting);
        QCOMPARE(LiveStroke::begin(tin, Imprint(), {}, VoidOwner).error().code, ErrorCode::LimitExceeded);
    }
};

SANDREEL_TEST(TestLiveStroke)
#include "tst_livestroke.moc"
