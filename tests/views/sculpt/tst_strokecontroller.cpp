// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "tests/views/sculpt/planview.h"
#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolvalues.h"

#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

using namespace model::terrain;
using namespace views;
using tests::PlanView;

namespace {

/// A terrain with a view of it and a hand over it.
struct Bench
{
    model::TerrainDocument document{tests::sandbox(1500)};
    commands::TerrainContext context{document};
    ToolSettings settings;
    PlanView view{document};
    StrokeController controller{context, settings, &view};
    tests::State start{document};

    explicit Bench(bool slides = false)
    {
        settings.fitTo(document.tin().domain());
        FlowSettings flow;
        flow.isOn = slides;
        settings.setFlow(flow);
        view.setInteraction(&controller);
        view.show();
    }
    ~Bench() { view.setInteraction(nullptr); }

    void press(Point2 p, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, PlanView::placeOf(p).toPoint());
    }
    /// At once: QTest::mouseMove() moves the cursor, and the event comes when the display sends it.
    void moveTo(Point2 p)
    {
        const QPointF place = PlanView::placeOf(p);
        QMouseEvent event(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
    void release(Point2 p) { QTest::mouseRelease(&view, Qt::LeftButton, {}, PlanView::placeOf(p).toPoint()); }
    void drag(Point2 from, Point2 to, Qt::KeyboardModifiers modifiers = {})
    {
        press(from, modifiers);
        for (int i = 1; i <= 8; ++i)
            moveTo({from.x + i * (to.x - from.x) / 8, from.y + i * (to.y - from.y) / 8});
        release(to);
        QTRY_VERIFY(!controller.isDrawing());
    }
    double added() const { return document.tin().ledger().added.value(); }
    double removed() const { return document.tin().ledger().removed.value(); }
    QUndoStack &stack() { return context.undoStack(); }
};

template <class T>
std::size_t kindOf()
{
    return Tool(T()).index();
}

} // namespace

class TestStrokeController final : public QObject
{
    Q_OBJECT

private slots:
    void aDragIsOneStepNamedAfterItsTool_data()
    {
        QTest::addColumn<int>("kind");
        const ToolSettings fresh;
        for (const Tool &tool : fresh.tools())
            QTest::newRow(nameOf(tool)) << int(tool.index());
    }
    void aDragIsOneStepNamedAfterItsTool()
    {
        QFETCH(int, kind);
        Bench bench;
        QTRY_VERIFY(bench.controller.reference().terrain());
        bench.settings.choose(kindOf<Raise>());
        bench.drag({0.2, 0.6}, {0.8, 0.6}); // something to smooth, flatten and restore
        const tests::State before(bench.document);
        bench.settings.choose(std::size_t(kind));
        bench.drag({0.3, 0.5}, {0.7, 0.65});
        QCOMPARE(bench.stack().count(), 2);
        QCOMPARE(bench.stack().undoText(), titleOf(bench.settings.tool()));
        QVERIFY(!(tests::State(bench.document) == before));
        QVERIFY(tests::isValid(bench.document));
        const tests::State after(bench.document);
        bench.stack().undo();
        QVERIFY(tests::State(bench.document) == before);
        bench.stack().redo();
        QVERIFY(tests::State(bench.document) == after);
        bench.stack().setIndex(0);
        QVERIFY(tests::State(bench.document) == bench.start);
    }
    void rightClickAndEscapeCallAStrokeOff_data()
    {
        QTest::addColumn<bool>("isEscape");
        QTest::newRow("right click") << false;
        QTest::newRow("Escape") << true;
    }
    void rightClickAndEscapeCallAStrokeOff()
    {
        QFETCH(bool, isEscape);
        Bench bench(true);
        bench.press({0.3, 0.5});
        bench.moveTo({0.4, 0.5});
        bench.moveTo({0.6, 0.5});
        QVERIFY(!(tests::State(bench.document) == bench.start));
        if (isEscape)
            QTest::keyClick(&bench.view, Qt::Key_Escape);
        else
            QTest::mouseClick(&bench.view, Qt::RightButton, {}, PlanView::placeOf({0.6, 0.5}).toPoint());
        QVERIFY(tests::State(bench.document) == bench.start);
        QCOMPARE(bench.stack().count(), 0);
        bench.moveTo({0.8, 0.5});
        bench.release({0.8, 0.5});
        QVERIFY(tests::State(bench.document) == bench.start);
        QVERIFY(!bench.controller.flow().isRunning());
    }
    void undoInTheMidstTakesAllOfItBack()
    {
        Bench bench(true);
        bench.press({0.3, 0.5});
        bench.moveTo({0.6, 0.5});
        bench.stack().undo();
        QVERIFY(tests::State(bench.document) == bench.start);
        QVERIFY(!bench.controller.isDrawing());
        bench.moveTo({0.8, 0.5});
        bench.release({0.8, 0.5});
        QVERIFY(tests::State(bench.document) == bench.start);
        QVERIFY(bench.stack().canRedo());
    }
    void whatSlidesBelongsToTheStroke()
    {
        Bench bench(true);
        Imprint tool = std::get<Imprint>(bench.settings.tool());
        tool.radius = 0.08;
        tool.depth = 0.08; // walls that do not stand
        bench.settings.setTool(tool);
        bench.drag({0.4, 0.5}, {0.6, 0.5});
        const tests::State drawn(bench.document);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.controller.flow().isRunning(), 60000);
        QVERIFY(!(tests::State(bench.document) == drawn));
        QVERIFY(!bench.context.hasGesture());
        QCOMPARE(bench.stack().count(), 1);
        QVERIFY(tests::isValid(bench.document));
        QVERIFY(std::abs(bench.controller.flow().figures().drift) < 1e-12);
        bench.stack().undo();
        QVERIFY(tests::State(bench.document) == bench.start);
    }
    void undoWhileSandSlidesIsExact()
    {
        Bench bench(true);
        Imprint tool = std::get<Imprint>(bench.settings.tool());
        tool.radius = 0.1;
        tool.depth = 0.1;
        bench.settings.setTool(tool);
        bench.drag({0.4, 0.5}, {0.6, 0.5});
        QTest::qWait(60);
        bench.stack().undo();
        QVERIFY(tests::State(bench.document) == bench.start);
        QVERIFY(!bench.controller.flow().isRunning());
        QTest::qWait(60);
        QVERIFY(tests::State(bench.document) == bench.start);
    }
    void modifiersChangeTheTool()
    {
        Bench bench;
        bench.settings.choose(kindOf<Lower>());
        bench.drag({0.3, 0.5}, {0.6, 0.5});
        QVERIFY(bench.removed() > 0 && bench.added() == 0);
        bench.stack().undo();
        bench.drag({0.3, 0.5}, {0.6, 0.5}, Qt::ControlModifier);
        QVERIFY(bench.added() > 0 && bench.removed() == 0);
        QCOMPARE(bench.stack().undoText(), titleOf(Raise()));
        bench.stack().undo();
        bench.drag({0.3, 0.5}, {0.6, 0.5}, Qt::ShiftModifier);
        QVERIFY(bench.added() == 0 && bench.removed() == 0);
        QCOMPARE(bench.stack().undoText(), titleOf(Smooth()));
        bench.stack().undo();
        bench.settings.choose(kindOf<Imprint>());
        bench.drag({0.3, 0.5}, {0.6, 0.5}, Qt::AltModifier);
        QVERIFY(bench.added() > 0);
        QCOMPARE(bench.settings.tool().index(), kindOf<Imprint>()); // only as long as the key is held
    }
    void aPenPressesAsHardAsItIsHeld()
    {
        const auto drawn = [](double pressure, float tilt) {
            Bench bench;
            bench.settings.choose(kindOf<Raise>());
            bench.view.pen(QEvent::TabletPress, {0.3, 0.5}, pressure, tilt);
            for (int i = 1; i <= 10; ++i)
                bench.view.pen(QEvent::TabletMove, {0.3 + 0.03 * i, 0.5}, pressure, tilt);
            bench.view.pen(QEvent::TabletRelease, {0.6, 0.5}, 0, tilt);
            [&] { QTRY_VERIFY(!bench.controller.isDrawing()); }();
            [&] { QCOMPARE(bench.stack().count(), 1); }();
            const double added = bench.added();
            bench.stack().undo();
            [&] { QVERIFY(tests::State(bench.document) == bench.start); }();
            return added;
        };
        const double hard = drawn(1, 0), soft = drawn(0.25, 0), flat = drawn(1, 60);
        QVERIFY2(std::abs(soft / hard - 0.25) < 0.01, qPrintable(QString::number(soft / hard)));
        // Twice as wide: stamps half as often, each of four times the volume.
        QVERIFY2(flat / hard > 1.6 && flat / hard < 2.6, qPrintable(QString::number(flat / hard)));
    }
    void theKeyboardDraws()
    {
        Bench bench;
        bench.settings.choose(kindOf<Raise>());
        bench.view.setFocus();
        const auto middle = [&] { // of the tool's outline
            Point2 sum;
            const std::vector<GroundLine> lines = bench.controller.lines();
            if (lines.empty())
                return Point2{-1, -1};
            for (const Point2 p : lines[0].points)
                sum = {sum.x + p.x / double(lines[0].points.size()), sum.y + p.y / double(lines[0].points.size())};
            return sum;
        };
        std::optional<GroundReading> reading;
        connect(&bench.controller, &StrokeController::readingChanged, &bench.view,
                [&](const std::optional<GroundReading> &now) { reading = now; });
        QTest::keyClick(&bench.view, Qt::Key_Left);
        const Point2 first = middle();
        QVERIFY(std::abs(first.x - 0.5) < 0.03 && std::abs(first.y - 0.5) < 0.01);
        QVERIFY(reading && reading->isByKeys);
        QTest::keyClick(&bench.view, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(middle().y > first.y + 0.05); // coarser
        QVERIFY(std::abs(middle().x - first.x) < 1e-9);
        QTest::keyClick(&bench.view, Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(tests::State(bench.document) == bench.start);

        QTest::keyClick(&bench.view, Qt::Key_Space);
        QVERIFY(bench.controller.isDrawing());
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&bench.view, Qt::Key_Right, Qt::ShiftModifier);
        bench.moveTo({0.1, 0.1}); // a mouse that is nudged meanwhile draws nothing
        QTest::keyClick(&bench.view, Qt::Key_Space);
        QTRY_VERIFY(!bench.controller.isDrawing());
        QCOMPARE(bench.stack().count(), 1);
        const auto rise = [&](Point2 p) { return bench.document.tin().heightAt(p) - tests::sandboxHeight(p); };
        QVERIFY(rise({first.x + 0.1, first.y}) > 1e-3);
        QVERIFY(std::abs(rise({first.x + 0.1, first.y + 0.2})) < 1e-3);
        bench.stack().undo();
        QVERIFY(tests::State(bench.document) == bench.start);

        QTest::keyClick(&bench.view, Qt::Key_Return);
        QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(!(tests::State(bench.document) == bench.start));
        QTest::keyClick(&bench.view, Qt::Key_Escape);
        QVERIFY(tests::State(bench.document) == bench.start);
        QVERIFY(!bench.controller.isDrawing());
        QCOMPARE(bench.stack().count(), 0);
        QTest::keyClick(&bench.view, Qt::Key_Space, Qt::ControlModifier); // inverted, as with the mouse
        QTest::keyClick(&bench.view, Qt::Key_Space);
        QTRY_VERIFY(!bench.controller.isDrawing());
        QCOMPARE(bench.stack().undoText(), titleOf(Lower()));
        bench.controller.setActive(false); // then they are the camera's
        QVERIFY(bench.controller.lines().empty());
        QTest::keyClick(&bench.view, Qt::Key_Space);
        QVERIFY(!bench.controller.isDrawing());
    }
    void theCursorOfTheKeysStaysInTheView()
    {
        Bench bench;
        bench.view.setFocus();
        for (int i = 0; i < 40; ++i)
            QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ShiftModifier);
        QTest::keyClick(&bench.view, Qt::Key_Right, Qt::ShiftModifier);
        const std::vector<GroundLine> lines = bench.controller.lines();
        QVERIFY(!lines.empty());
        QVERIFY(lines[0].points[0].x > -double(PlanView::Margin) / PlanView::Side);
    }
    void thePensOtherEndInverts()
    {
        Bench bench;
        bench.settings.choose(kindOf<Raise>());
        bench.view.pen(QEvent::TabletPress, {0.3, 0.5}, 1, 0, true);
        bench.view.pen(QEvent::TabletMove, {0.5, 0.5}, 1, 0, true);
        bench.view.pen(QEvent::TabletRelease, {0.5, 0.5}, 0, 0, true);
        QTRY_VERIFY(!bench.controller.isDrawing());
        QVERIFY(bench.removed() > 0 && bench.added() == 0);
    }
    void restoreBringsBackWhatWasOpenedUntilAnotherMomentIsTaken()
    {
        Bench bench;
        GroundReference &reference = bench.controller.reference();
        QTRY_VERIFY(reference.terrain());
        QVERIFY(!reference.isTaken());
        const Point2 place{0.5, 0.5};
        const double opened = bench.document.tin().heightAt(place);
        const auto restore = [&] {
            Restore tool;
            tool.brush.radius = 0.2;
            tool.strength = 1;
            tool.brush.falloff = Falloff::Constant;
            bench.settings.setTool(tool);
            bench.drag({0.45, 0.5}, {0.55, 0.5});
        };
        const auto raise = [&] {
            bench.settings.choose(kindOf<Raise>());
            bench.drag({0.4, 0.5}, {0.6, 0.5});
        };
        raise();
        QVERIFY(bench.document.tin().heightAt(place) > opened + 1e-3);
        restore();
        QVERIFY(std::abs(bench.document.tin().heightAt(place) - opened) < 1e-9);

        raise();
        const double taken = bench.document.tin().heightAt(place);
        QSignalSpy changed(&reference, &GroundReference::changed);
        reference.take();
        QTRY_COMPARE(changed.count(), 1);
        raise();
        restore();
        QVERIFY(std::abs(bench.document.tin().heightAt(place) - taken) < 1e-9);
        // What the user has taken stays through a save.
        const GroundReference::TerrainPtr before = reference.terrain();
        reference.noteSaved(bench.document.snapshot());
        QCOMPARE(reference.terrain(), before);
    }
    void aSaveIsTheReferenceUntilOneIsTaken()
    {
        Bench bench;
        GroundReference &reference = bench.controller.reference();
        QTRY_VERIFY(reference.terrain());
        const GroundReference::TerrainPtr saved = bench.document.snapshot();
        reference.noteSaved(saved);
        QCOMPARE(reference.terrain(), saved);
    }
    void spokesReachTheBorder()
    {
        Bench bench;
        bench.settings.setSymmetry({Symmetry::Kind::Radial, {0.25, 0.5}, 7});
        const std::vector<GroundLine> lines = bench.controller.lines();
        QCOMPARE(lines.size(), std::size_t(7));
        for (const GroundLine &line : lines) {
            QVERIFY((line.points[0] == Point2{0.25, 0.5}));
            const Point2 end = line.points[1];
            QVERIFY(std::min({end.x, 1 - end.x, end.y, 1 - end.y}) < 1e-12);
            QVERIFY(bench.document.tin().domain().contains(end));
        }
    }
    void strokesGoOverTheEdge()
    {
        Bench bench;
        bench.settings.choose(kindOf<Raise>());
        bench.drag({0.9, 0.5}, {1.1, 0.5});
        QVERIFY(bench.document.tin().heightAt({1, 0.5}) > 0);
        QVERIFY(bench.added() > 0);
        QVERIFY(tests::isValid(bench.document));
    }
    void keysAndDragsSetRadiusAndStrength()
    {
        Bench bench;
        bench.moveTo({0.5, 0.5});
        const double radius = radiusOf(bench.settings.tool()), depth = amountOf(bench.settings.tool());
        bench.settings.scaleRadius(1.1);
        QVERIFY(std::abs(radiusOf(bench.settings.tool()) - 1.1 * radius) < 1e-12);
        bench.settings.scaleRadius(1 / 1.1);
        bench.settings.scaleAmount(2);
        QVERIFY(std::abs(amountOf(bench.settings.tool()) - 2 * depth) < 1e-12);
        bench.settings.scaleAmount(0.5);
        QVERIFY(std::abs(radiusOf(bench.settings.tool()) - radius) < 1e-12);
        QTest::keyClick(&bench.view, Qt::Key_F);
        bench.moveTo({0.6, 0.5});
        QVERIFY(std::abs(radiusOf(bench.settings.tool()) - radius - 0.1) < 1e-9);
        QTest::keyClick(&bench.view, Qt::Key_Escape);
        QCOMPARE(radiusOf(bench.settings.tool()), radius);
        bench.moveTo({0.5, 0.5});
        QTest::keyClick(&bench.view, Qt::Key_F, Qt::ShiftModifier);
        bench.moveTo({0.75, 0.5}); // 100 pixels
        QVERIFY(std::abs(amountOf(bench.settings.tool()) - 2 * depth) < 1e-9);
        bench.press({0.75, 0.5});
        bench.release({0.75, 0.5});
        bench.moveTo({0.3, 0.5});
        QVERIFY(std::abs(amountOf(bench.settings.tool()) - 2 * depth) < 1e-9);
        QCOMPARE(bench.stack().count(), 0); // the click ended the drag, and drew nothing
    }
    void theOutlineFollowsThePointerAndItsCopies()
    {
        Bench bench;
        QVERIFY(bench.controller.lines().empty());
        bench.moveTo({0.25, 0.5});
        std::vector<GroundLine> lines = bench.controller.lines();
        QCOMPARE(lines.size(), std::size_t(2));
        for (const Point2 p : lines[0].points)
            QVERIFY(std::abs(std::hypot(p.x - 0.25, p.y - 0.5) - radiusOf(bench.settings.tool())) < 1e-9);
        // The second one lies as far inside as the tool goes deep.
        QVERIFY(std::abs(std::hypot(lines[1].points[0].x - 0.25, lines[1].points[0].y - 0.5) -
                         (radiusOf(bench.settings.tool()) - amountOf(bench.settings.tool()))) < 1e-9);
        bench.settings.setSymmetry({Symmetry::Kind::MirrorX, {0.5, 0.5}, 2});
        lines = bench.controller.lines();
        QCOMPARE(lines.size(), std::size_t(5));
        // First the mirror, then the tool, then its image.
        for (const Point2 p : lines[0].points)
            QCOMPARE(p.x, 0.5);
        lines.erase(lines.begin());
        double middle = 0;
        for (const Point2 p : lines[2].points)
            middle += p.x / double(lines[2].points.size());
        QVERIFY(std::abs(middle - 0.75) < 1e-9);
        bench.controller.setActive(false);
        QVERIFY(bench.controller.lines().empty());
    }
    void theReadingSaysWhatLiesThere()
    {
        Bench bench;
        std::optional<GroundReading> reading;
        connect(&bench.controller, &StrokeController::readingChanged, &bench.view,
                [&](const std::optional<GroundReading> &now) { reading = now; });
        bench.moveTo({0.5, 0.5});
        QVERIFY(reading);
        QCOMPARE(reading->point.z, bench.document.tin().heightAt({reading->point.x, reading->point.y}));
        QCOMPARE(reading->humidity, std::optional(0.1f));
        QCOMPARE(reading->material, QStringLiteral("Dry Sand"));
        QVERIFY(reading->slope >= 0 && reading->slope < 90);
        bench.moveTo({1.1, 0.5});
        QVERIFY(!reading);
    }
    void symmetryDrawsOnBothSides()
    {
        Bench bench;
        bench.settings.choose(kindOf<Raise>());
        bench.settings.setSymmetry({Symmetry::Kind::MirrorX, {0.5, 0.5}, 2});
        const double left = bench.document.tin().heightAt({0.25, 0.5}),
                     right = bench.document.tin().heightAt({0.75, 0.5});
        bench.drag({0.2, 0.5}, {0.3, 0.5});
        QVERIFY(bench.document.tin().heightAt({0.25, 0.5}) > left + 1e-4);
        QVERIFY(bench.document.tin().heightAt({0.75, 0.5}) > right + 1e-4);
    }
    void runStepAndPauseAreSteps()
    {
        Bench bench(true);
        Raise tool;
        tool.brush.radius = 0.2;
        tool.height = 0.2;
        FlowSettings flow = bench.settings.flow();
        flow.isOn = false;
        bench.settings.setFlow(flow);
        bench.settings.setTool(tool);
        bench.drag({0.5, 0.5}, {0.5, 0.52});
        SandFlow &sand = bench.controller.flow();
        sand.step();
        QCOMPARE(bench.stack().count(), 2);
        QVERIFY(!bench.context.hasGesture());
        sand.run();
        QTRY_VERIFY_WITH_TIMEOUT(sand.figures().movedVolume > 0, 20000);
        QVERIFY(sand.isRunning());
        sand.pause();
        QCOMPARE(bench.stack().count(), 3);
        bench.stack().setIndex(0);
        QVERIFY(tests::State(bench.document) == bench.start);
    }
};

SANDREEL_TEST(TestStrokeController)
#include "tst_strokecontroller.moc"
