// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "views/terrain/noglterrainview.h"

#include <QMouseEvent>

#include <cmath>

using namespace model::terrain;
using namespace views;

namespace {

class Presses final : public GroundInteraction
{
public:
    bool isActive() const override { return true; }
    bool press(const GroundEvent &event) override
    {
        events.push_back(event);
        return true;
    }
    void move(const GroundEvent &event) override { events.push_back(event); }
    void release(const GroundEvent &event) override { events.push_back(event); }
    void cancel() override { ++cancelled; }

    std::vector<GroundEvent> events;
    int cancelled = 0;
};

} // namespace

class TestNoGlTerrainView final : public QObject
{
    Q_OBJECT

private:
    /// Shown, with all rows drawn.
    static void wait(NoGlTerrainView &view)
    {
        view.show();
        QTest::qWait(50);
        QImage last;
        QTRY_VERIFY([&] {
            QTest::qWait(60);
            return view.picture() == std::exchange(last, view.picture().copy());
        }());
    }

private slots:
    void planesHaveTheShadeOfTheirSlope_data()
    {
        QTest::addColumn<double>("rise");
        for (const double rise : {0.0, 0.1, -0.4, 0.8})
            QTest::addRow("%g", rise) << rise;
    }
    void planesHaveTheShadeOfTheirSlope()
    {
        QFETCH(double, rise);
        const auto document =
            tests::groundDocument(tests::UnitSquare, 8, [rise](double, double y) { return rise * y; });
        NoGlTerrainView view(*document);
        view.resize(240, 240);
        wait(view);
        // The light comes from 305 degrees, 30 above the horizon.
        const double north = std::cos(305 * M_PI / 180) * std::cos(M_PI / 6);
        const double cosine = std::max((0.5 - rise * north) / std::sqrt(1 + rise * rise), 0.0);
        const double shade = 0.86 * (0.25 + 0.75 * cosine / 0.5);
        const QColor color = view.picture().pixelColor(view.picture().width() / 2, view.picture().height() / 3);
        QVERIFY(std::abs(color.red() - std::min(222 * shade, 255.0)) <= 1);
        QVERIFY(std::abs(color.blue() - std::min(140 * shade, 255.0)) <= 1);
    }

    void editIsDrawnAndUndone()
    {
        const auto document = tests::groundDocument(tests::UnitSquare, 20, tests::dunes);
        NoGlTerrainView view(*document);
        view.resize(240, 240);
        wait(view);
        const QImage before = view.picture().copy();
        Edit edit = document->edit([](TinEdit &open) {
            const VertexId v = open.tin().arrays().vertex(cornerOf(open.tin().triangleAt({0.5, 0.3}), 0));
            open.setHeight(v, 0.4);
            open.insert({0.52, 0.71}, 0.3);
        });
        QTRY_VERIFY(view.picture() != before);
        wait(view);
        {
            NoGlTerrainView other(*document);
            other.resize(240, 240);
            wait(other);
            QCOMPARE(view.picture(), other.picture());
        }
        document->swap(edit);
        QTRY_COMPARE(view.picture(), before);
    }

    void toolsHearWhereTheyAre()
    {
        const auto document = tests::groundDocument({{10, 20}, {14, 22}}, 8, [](double x, double) { return x; });
        NoGlTerrainView view(*document);
        view.resize(400, 300);
        wait(view);
        Presses presses;
        view.setInteraction(&presses);
        const QPoint middle = QPoint(200, 0) + QPoint(0, (12 + 288 - view.fontMetrics().height()) / 2);
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(398, middle.y()));
        QCOMPARE(presses.events.size(), std::size_t(2));
        QVERIFY(std::abs(presses.events[0].point.x - 12) < 0.03 && std::abs(presses.events[0].point.y - 21) < 0.03);
        QVERIFY(std::abs(presses.events[0].point.z - presses.events[0].point.x) < 1e-9);
        QVERIFY(presses.events[0].isOnTerrain && !presses.events[1].isOnTerrain);
        QVERIFY(std::abs(presses.events[1].point.z - 14) < 1e-9); // the height of the border
        QVERIFY(view.pick(middle) && !view.pick({1, 1}));
        view.setInteraction(nullptr);
        QCOMPARE(presses.cancelled, 0);
    }
};

SANDREEL_TEST(TestNoGlTerrainView)
#include "tst_noglterrainview.moc"
