// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "tests/views/sculpt/planview.h"
#include "views/sculpt/maskpainter.h"
#include "views/sculpt/sharedground.h"
#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolvalues.h"

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
    std::shared_ptr<model::GroundMask> mask = std::make_shared<model::GroundMask>();
    ToolSettings settings;
    PlanView view{document};
    StrokeController strokes{context, settings, &view};
    MaskPainter painter{context, mask, settings, &view};
    SharedGround shared{view, {&strokes, &painter}};

    Bench()
    {
        settings.fitTo(document.tin().domain());
        FlowSettings flow;
        flow.isOn = false;
        settings.setFlow(flow);
        strokes.setMask(mask);
        view.show();
        shared.choose(painter);
    }
    void moveTo(Point2 p)
    {
        const QPointF place = PlanView::placeOf(p);
        QMouseEvent event(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
    void press(Point2 p, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, PlanView::placeOf(p).toPoint());
    }
    void drag(Point2 from, Point2 to, Qt::KeyboardModifiers modifiers = {})
    {
        press(from, modifiers);
        moveTo(to);
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, PlanView::placeOf(to).toPoint());
        QTRY_VERIFY(!strokes.isDrawing());
    }
    double at(Point2 p) const { return mask->value() ? mask->value()->at(p) : 0; }
    QUndoStack &stack() { return context.undoStack(); }
};

} // namespace

class TestMaskPainter final : public QObject
{
    Q_OBJECT

private slots:
    void aStrokeIsOneStepThatUndoes()
    {
        Bench bench;
        const std::uint64_t ground = bench.document.fingerprint();
        QSignalSpy shown(&bench.painter, &MaskPainter::shownChanged);
        bench.press({0.3, 0.5});
        bench.moveTo({0.6, 0.5});
        QVERIFY(!bench.mask->value()); // the document does not know of it yet
        QVERIFY(bench.painter.shown() && bench.painter.shown()->at({0.5, 0.5}) == 1);
        QTest::mouseRelease(&bench.view, Qt::LeftButton, {}, PlanView::placeOf({0.6, 0.5}).toPoint());
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(!bench.stack().undoText().isEmpty());
        QCOMPARE(bench.at({0.45, 0.5}), 1.0);
        QCOMPARE(bench.at({0.45, 0.7}), 0.0);
        QVERIFY(shown.count() >= 3);
        const model::GroundMask::Value painted = bench.mask->value();
        bench.stack().undo();
        QVERIFY(!bench.mask->value());
        bench.stack().redo();
        QCOMPARE(bench.mask->value(), painted);
        QCOMPARE(bench.document.fingerprint(), ground);
        QVERIFY(bench.context.history().used() >= painted->values().size() || bench.context.history().used() > 0);

        bench.drag({0.45, 0.5}, {0.45, 0.52}, Qt::ControlModifier); // opens again
        QCOMPARE(bench.at({0.45, 0.51}), 0.0);
        QCOMPARE(bench.at({0.32, 0.5}), 1.0);
        bench.drag({0.45, 0.5}, {0.45, 0.52}, Qt::ControlModifier);
        QCOMPARE(bench.stack().count(), 2); // what changed nothing is no step
    }
    void rightClickLeavesNoTrace()
    {
        Bench bench;
        bench.press({0.3, 0.5});
        bench.moveTo({0.6, 0.5});
        QTest::mouseClick(&bench.view, Qt::RightButton, {}, PlanView::placeOf({0.6, 0.5}).toPoint());
        QVERIFY(!bench.mask->value() && !bench.painter.shown());
        QCOMPARE(bench.stack().count(), 0);
    }
    void clearAndInvert()
    {
        Bench bench;
        bench.painter.clear();
        QCOMPARE(bench.stack().count(), 0); // there was nothing
        bench.drag({0.3, 0.5}, {0.6, 0.5});
        bench.painter.invert();
        QCOMPARE(bench.at({0.45, 0.5}), 0.0);
        QCOMPARE(bench.at({0.45, 0.8}), 1.0);
        bench.painter.clear();
        QVERIFY(!bench.mask->value());
        QCOMPARE(bench.stack().count(), 3);
        bench.stack().setIndex(1);
        QCOMPARE(bench.at({0.45, 0.5}), 1.0);
        bench.stack().setIndex(0);
        QVERIFY(!bench.mask->value());
    }
    void penPressureAndSymmetryCount()
    {
        Bench bench;
        bench.settings.setSymmetry({Symmetry::Kind::MirrorX, {0.5, 0.5}, 2});
        bench.view.pen(QEvent::TabletPress, {0.2, 0.5}, 0.5);
        bench.view.pen(QEvent::TabletMove, {0.3, 0.5}, 0.5);
        bench.view.pen(QEvent::TabletRelease, {0.3, 0.5}, 0);
        QVERIFY(std::abs(bench.at({0.25, 0.5}) - 0.5) < 0.01);
        QVERIFY(std::abs(bench.at({0.75, 0.5}) - 0.5) < 0.01);
    }
    void strokesLeaveAloneWhatWasPainted()
    {
        Bench bench;
        Raise tool;
        tool.brush.radius = 0.15;
        tool.height = 0.05;
        bench.settings.setTool(tool);
        bench.drag({0.5, 0.2}, {0.5, 0.8});
        bench.shared.choose(bench.strokes);
        const double before = bench.document.tin().heightAt({0.5, 0.5}),
                     beside = bench.document.tin().heightAt({0.2, 0.5});
        bench.drag({0.15, 0.5}, {0.85, 0.5});
        // Nothing is raised there. Vertices that come in beside it may turn an edge across it.
        const double change = bench.document.tin().heightAt({0.5, 0.5}) - before;
        QVERIFY2(std::abs(change) < 1e-4, qPrintable(QString::number(change)));
        QVERIFY(bench.document.tin().heightAt({0.2, 0.5}) > beside + 1e-2);
    }
};

SANDREEL_TEST(TestMaskPainter)
#include "tst_maskpainter.moc"
