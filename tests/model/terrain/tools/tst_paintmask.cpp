// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/stroke.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model::terrain;

namespace {

Tin waves()
{
    std::mt19937_64 random(4);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(2000);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = 0.1 * std::sin(9 * p.x) * std::cos(7 * p.y);
    }
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

/// The right half is protected.
std::shared_ptr<const PaintMask> rightHalf()
{
    PaintMask mask(Rectangle{{0, 0}, {1, 1}});
    mask.paint({1, 0}, {1, 1}, 0.5, 1, false);
    mask.paint({0.8, 0}, {0.8, 1}, 0.3, 1, false);
    return std::make_shared<const PaintMask>(mask);
}

} // namespace

class TestPaintMask final : public QObject
{
    Q_OBJECT

private slots:
    void paintingProtectsAndOpens()
    {
        PaintMask mask(Rectangle{{-2, 10}, {6, 14}});
        QCOMPARE(mask.columns(), PaintMask::UsualCells);
        QCOMPARE(mask.rows(), PaintMask::UsualCells / 2); // square cells
        QVERIFY(mask.isEmpty());
        QCOMPARE(mask.at({0, 12}), 0.0);
        mask.paint({0, 12}, {4, 12}, 0.5, 1, false);
        QVERIFY(!mask.isEmpty());
        for (const double x : {0.0, 1.3, 4.0})
            QCOMPARE(mask.at({x, 12}), 1.0);
        QCOMPARE(mask.at({2, 12.25}), 1.0); // the core is hard
        const double rim = mask.at({2, 12.4});
        QVERIFY2(std::abs(rim - 0.5) < 0.05, qPrintable(QString::number(rim))); // its rim is soft: (1 - 0.8) / 0.4
        QCOMPARE(mask.at({2, 12.6}), 0.0);
        QCOMPARE(mask.at({-0.6, 12}), 0.0);
        mask.paint({2, 12}, {2, 12}, 0.5, 1, true);
        QCOMPARE(mask.at({2, 12}), 0.0);
        QCOMPARE(mask.at({1, 12}), 1.0);
        mask.paint({0, 13}, {0, 13}, 0.5, 0.25, false); // a soft pen
        QVERIFY(std::abs(mask.at({0, 13}) - 0.25) < 0.01);
        // Beyond the domain as at its border, and what lies beyond is nowhere painted.
        mask.paint({-5, 10}, {-5, 14}, 2, 1, false);
        QCOMPARE(mask.at({-2, 11}), 0.0);
        mask.paint({6, 11}, {6, 11}, 0.5, 1, false);
        QCOMPARE(mask.at({60, 11}), 1.0);
        PaintMask inverted = mask;
        inverted.invert();
        QCOMPARE(inverted.at({2, 12}), 1.0);
        QCOMPARE(inverted.at({1, 12}), 0.0);
        inverted.invert();
        QCOMPARE(inverted, mask);
    }
    void aStrokeOfManyPiecesIsAsOne()
    {
        PaintMask whole(Rectangle{{0, 0}, {1, 1}}), pieces = whole;
        whole.paint({0.25, 0.5}, {0.75, 0.5}, 0.1, 1, false);
        for (int i = 0; i < 8; ++i)
            pieces.paint({0.25 + i / 16.0, 0.5}, {0.25 + (i + 1) / 16.0, 0.5}, 0.1, 1, false);
        QCOMPARE(pieces, whole);
    }
    void restoreChecksItsNumbers()
    {
        const Rectangle domain{{0, 0}, {1, 1}};
        const auto code = [&](std::uint32_t columns, std::uint32_t rows, std::size_t values) {
            const auto made = PaintMask::restore(domain, columns, rows, std::vector<std::uint8_t>(values));
            return made ? std::optional<model::ErrorCode>() : made.error().code;
        };
        QVERIFY(!code(3, 2, 6));
        QCOMPARE(code(0, 2, 0), std::optional(model::ErrorCode::BadValue));
        QCOMPARE(code(3, 2, 5), std::optional(model::ErrorCode::BadValue));
        QCOMPARE(code(PaintMask::MostCells + 1, 1, PaintMask::MostCells + 1),
                 std::optional(model::ErrorCode::BadValue));
    }
    void everyToolLeavesAloneWhatIsProtected_data()
    {
        QTest::addColumn<int>("kind");
        for (int kind = 0; kind < int(std::variant_size_v<Tool>); ++kind)
            QTest::addRow("%d", kind) << kind;
    }
    void everyToolLeavesAloneWhatIsProtected()
    {
        QFETCH(int, kind);
        Mask mask;
        mask.paint = rightHalf();
        Brush brush;
        brush.radius = 0.1;
        brush.mask = mask;
        Imprint imprint;
        imprint.radius = 0.03;
        imprint.depth = 0.01;
        imprint.mask = mask;
        Rake rake;
        rake.width = 0.15;
        rake.depth = 0.02;
        rake.mask = mask;
        const std::vector<Tool> tools{imprint,
                                      rake,
                                      Raise{brush, 0.02},
                                      Lower{brush, 0.02},
                                      Flatten{brush, 0.5, {}},
                                      Smooth{brush, 0.5},
                                      Noise{brush, 0.02, 0.1, 2, 1},
                                      Ramp{brush, {}, {}},
                                      Restore{brush, 0.5, {[](Point2) { return 1.0; }, nullptr}},
                                      Pour{brush, 1e-4},
                                      Scoop{brush, 0.02},
                                      Breakline{0.05, {}, Crossing::Split},
                                      Moisten{brush, 1, 0.5}};
        const Tool &tool = tools[std::size_t(kind)];
        if (std::holds_alternative<Breakline>(tool))
            return; // draws edges, and moves nothing
        Tin tin = waves();
        if (std::holds_alternative<Moisten>(tool)) {
            TinEdit edit(tin);
            edit.addLayer(0, 0);
            for (VertexId v = 0; v < tin.vertexCount(); ++v)
                edit.setLayer(v, 0, {0.05, 0});
            edit.commit();
        }
        const Tin before = tin;
        QVERIFY(draw(tin, {tool, {{{0.1, 0.5}, 1, 0}, {{0.9, 0.5}, 1, 0}}, {}}));
        double left = 0, right = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            if (!tin.arrays().isVertex(v))
                continue;
            const Point2 p = tin.arrays().points[v];
            double change = std::abs(tin.arrays().heights[v] - before.heightAt(p));
            if (tin.arrays().layerCount() > 0)
                change += double(tin.arrays().humidities[tin.arrays().layerSlot(v, 0)]);
            // Vertices that come in on open ground may turn edges near it, not as far away as this.
            (p.x > 0.8 ? right : left) = std::max(p.x > 0.8 ? right : left, change);
        }
        QVERIFY2(left > 1e-4, qPrintable(QString::number(left)));
        QVERIFY2(right < 1e-9, qPrintable(QString::number(right)));
    }
};

SANDREEL_TEST(TestPaintMask)
#include "tst_paintmask.moc"
