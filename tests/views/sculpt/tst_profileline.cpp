// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "tests/views/sculpt/planview.h"
#include "views/sculpt/profileline.h"
#include "views/sculpt/sharedground.h"
#include "views/sculpt/strokecontroller.h"

#include <QSignalSpy>
#include <QUndoStack>

using namespace model::terrain;
using namespace views;
using tests::PlanView;

namespace {

struct Bench
{
    model::TerrainDocument document{tests::sandbox()};
    commands::TerrainContext context{document};
    ToolSettings settings;
    PlanView view{document};
    StrokeController strokes{context, settings, &view};
    ProfileLine line{&view};
    SharedGround shared{view, {&strokes, &line}};
    tests::State start{document};

    Bench()
    {
        settings.fitTo(document.tin().domain());
        FlowSettings flow;
        flow.isOn = false;
        settings.setFlow(flow);
        view.show();
        shared.choose(line);
    }

    void moveTo(Point2 p)
    {
        const QPointF place = PlanView::placeOf(p);
        QMouseEvent event(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
    void press(Point2 p) { QTest::mousePress(&view, Qt::LeftButton, {}, PlanView::placeOf(p).toPoint()); }
    void release(Point2 p) { QTest::mouseRelease(&view, Qt::LeftButton, {}, PlanView::placeOf(p).toPoint()); }
    void drag(Point2 from, Point2 to)
    {
        press(from);
        moveTo({(from.x + to.x) / 2, (from.y + to.y) / 2});
        moveTo(to);
        release(to);
    }
};

bool isNear(Point2 p, Point2 q)
{
    return std::hypot(p.x - q.x, p.y - q.y) < 2.0 / PlanView::Side;
}

} // namespace

class TestProfileLine final : public QObject
{
    Q_OBJECT

private slots:
    void aDragDrawsItAndItsEndsCanBeDragged()
    {
        Bench bench;
        QSignalSpy changed(&bench.line, &ProfileLine::changed);
        bench.drag({0.2, 0.3}, {0.8, 0.6});
        QVERIFY(bench.line.ends());
        QVERIFY(isNear(bench.line.ends()->a, {0.2, 0.3}) && isNear(bench.line.ends()->b, {0.8, 0.6}));
        QVERIFY(changed.count() >= 2); // it follows the pointer
        bench.drag({0.205, 0.3}, {0.1, 0.9});
        QVERIFY(isNear(bench.line.ends()->a, {0.1, 0.9}) && isNear(bench.line.ends()->b, {0.8, 0.6}));
        bench.drag({0.8, 0.605}, {0.9, 0.1});
        QVERIFY(isNear(bench.line.ends()->a, {0.1, 0.9}) && isNear(bench.line.ends()->b, {0.9, 0.1}));
        bench.drag({0.5, 0.2}, {0.6, 0.2}); // away from both: another line
        QVERIFY(isNear(bench.line.ends()->a, {0.5, 0.2}) && isNear(bench.line.ends()->b, {0.6, 0.2}));
        QVERIFY(tests::State(bench.document) == bench.start);
        QCOMPARE(bench.context.undoStack().count(), 0);
    }
    void escapeBringsTheLineBeforeBack()
    {
        Bench bench;
        bench.drag({0.2, 0.3}, {0.8, 0.6});
        const auto before = bench.line.ends();
        bench.press({0.5, 0.2});
        bench.moveTo({0.7, 0.2});
        QVERIFY(bench.line.ends() != before);
        QTest::keyClick(&bench.view, Qt::Key_Escape);
        QCOMPARE(bench.line.ends(), before);
        bench.press({0.5, 0.2}); // a click alone draws none
        bench.release({0.5, 0.2});
        QCOMPARE(bench.line.ends(), before);
    }
    void keysDrawItToo()
    {
        Bench bench;
        bench.view.setFocus();
        QTest::keyClick(&bench.view, Qt::Key_Left);
        QTest::keyClick(&bench.view, Qt::Key_Space);
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(&bench.view, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&bench.view, Qt::Key_Space);
        QVERIFY(bench.line.ends());
        QVERIFY(bench.line.ends()->b.x > bench.line.ends()->a.x + 0.1);
    }
    void itIsSeenWhileToolsDraw()
    {
        Bench bench;
        bench.drag({0.2, 0.3}, {0.8, 0.6});
        bench.shared.choose(bench.strokes);
        bench.moveTo({0.5, 0.5});
        const std::size_t both = bench.shared.lines().size();
        QVERIFY(both > bench.strokes.lines().size());
        bench.line.setVisible(false);
        QCOMPARE(bench.shared.lines().size(), bench.strokes.lines().size());
        bench.press({0.4, 0.4});
        QVERIFY(bench.strokes.isDrawing());
        bench.shared.choose(bench.line); // in the midst of a stroke
        QVERIFY(!bench.strokes.isDrawing());
        QVERIFY(tests::State(bench.document) == bench.start);
        bench.release({0.4, 0.4});
        QVERIFY(tests::State(bench.document) == bench.start);
    }
};

SANDREEL_TEST(TestProfileLine)
#include "tst_profileline.moc"
