// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/newterrain.h"
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "views/sculpt/strokecontroller.h"

#include <QTest>

using namespace model::terrain;
using namespace views;

/// Sand that slides because of a stroke, until it rests.
class TestSandFlow final : public QObject
{
    Q_OBJECT

private slots:
    /// A finger's width of trench over triangles of a metre.
    void sandComesToRestOnCoarseGround_data()
    {
        QTest::addColumn<double>("y");
        QTest::newRow("along edges") << 10.0;
        QTest::newRow("beside them") << 10.3;
    }
    void sandComesToRestOnCoarseGround()
    {
        QFETCH(double, y);
        model::io::NewTerrain description;
        description.width = description.depth = 20;
        description.spacing = 1;
        description.layers = {{material(MaterialPreset::DrySand), 2}};
        auto made = model::io::makeTerrain(description);
        QVERIFY(made);
        model::TerrainDocument document(std::move(*made));
        const double volume = document.tin().volume();
        commands::TerrainContext context(document);
        ToolSettings settings;
        StrokeController controller(context, settings, nullptr);
        controller.setActive(true);
        const auto at = [&](double x) {
            GroundEvent event;
            event.point = {x, y, 0};
            event.time = std::uint64_t(8 * (x - 5));
            event.isOnTerrain = true;
            return event;
        };
        controller.press(at(6));
        for (double x = 7; x <= 14; x += 1)
            controller.move(at(x));
        controller.release(at(14));
        QTRY_VERIFY_WITH_TIMEOUT(!context.hasGesture(), 60'000);
        QCOMPARE(context.undoStack().count(), 1);
        QVERIFY(tests::isValid(document));

        const TinArrays &tin = document.tin().arrays();
        const double depth = std::get<Imprint>(settings.tool()).depth;
        const double flat = document.tin().heightAt({1, 1});
        double steepest = 0;
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
            if (!tin.isTriangle(t))
                continue;
            double longest = 0, doubleArea = 0;
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Point2 p = tin.pointAt(cornerOf(t, i)), q = tin.pointAt(cornerOf(t, (i + 1) % 3));
                longest = std::max(longest, std::hypot(p.x - q.x, p.y - q.y));
                doubleArea += p.x * q.y - p.y * q.x;
                const double height = tin.heights[tin.vertex(cornerOf(t, i))] - flat;
                QVERIFY2(std::abs(height) < 4 * depth, qPrintable(QString::number(height)));
            }
            if (doubleArea > 1e-5 * longest * longest) // no sliver
                steepest = std::max(steepest, slopeOf(tin, t) * 180 / M_PI);
        }
        const double critical = criticalAngleAt(document.terrain().materials[0], 0);
        const FlowFigures &figures = controller.flow().figures();
        QVERIFY2(steepest < critical + settings.flow().erosion.startAngle + 0.1, qPrintable(QString::number(steepest)));
        QVERIFY(figures.steepest.has_value());
        QVERIFY2(std::abs(*figures.steepest - steepest) < 0.5, qPrintable(QString::number(*figures.steepest)));
        QCOMPARE(figures.activeTriangles, std::size_t(0));
        QVERIFY(std::abs(figures.drift) < 1e-12);
        const Ledger &ledger = document.tin().ledger();
        const double explained = volume + ledger.added.value() - ledger.removed.value() - ledger.pressed.value();
        QVERIFY(std::abs(document.tin().volume() - explained) < 1e-12 * 800); // that of the sand
    }
};

SANDREEL_TEST(TestSandFlow)
#include "tst_sandflow.moc"
