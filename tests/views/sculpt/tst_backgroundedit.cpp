// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/layers.h"
#include "model/terrain/erosion/erosion.h"
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "views/sculpt/backgroundedit.h"

#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

using namespace model::terrain;
using views::BackgroundEdit;

namespace {

BackgroundEdit::Work fill(double thickness)
{
    return [thickness](TinEdit &edit, const model::Progress &) -> model::Result<void> {
        commands::fillLayer(0, {thickness, 0.5f})(edit);
        return {};
    };
}

} // namespace

class TestBackgroundEdit final : public QObject
{
    Q_OBJECT

private slots:
    void theResultIsOneStepAsIfDoneHere()
    {
        model::TerrainDocument document(tests::sandbox()), other(tests::sandbox());
        commands::TerrainContext context(document), otherContext(other);
        BackgroundEdit work(context);
        const tests::State before(document);
        QSignalSpy finished(&work, &BackgroundEdit::finished);
        work.start(QStringLiteral("Fill"), fill(0.25));
        QVERIFY(tests::State(document) == before); // on a copy
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(context.undoStack().count(), 1);
        otherContext.push<commands::EditSurface>(QStringLiteral("Fill"), commands::fillLayer(0, {0.25, 0.5f}));
        QVERIFY(tests::State(document) == tests::State(other));
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
        context.undoStack().redo();
        QVERIFY(tests::State(document) == tests::State(other));
    }
    void whatChangesNothingLeavesNoStep()
    {
        model::TerrainDocument document(tests::sandbox());
        commands::TerrainContext context(document);
        BackgroundEdit work(context);
        QSignalSpy finished(&work, &BackgroundEdit::finished);
        work.start(QStringLiteral("Nothing"),
                   [](TinEdit &, const model::Progress &) -> model::Result<void> { return {}; });
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(context.undoStack().count(), 0);
    }
    void aChangeMeanwhileCallsItOff()
    {
        model::TerrainDocument document(tests::sandbox());
        commands::TerrainContext context(document);
        BackgroundEdit work(context);
        QSignalSpy finished(&work, &BackgroundEdit::finished), failed(&work, &BackgroundEdit::failed);
        work.start(QStringLiteral("Fill"), fill(0.25));
        context.push<commands::EditSurface>(QStringLiteral("Raise"), [](TinEdit &edit) { edit.setHeight(5, 2); });
        const tests::State raised(document);
        QTRY_VERIFY(!work.job().isRunning());
        QTest::qWait(10);
        QVERIFY(tests::State(document) == raised);
        QCOMPARE(finished.count() + failed.count(), 0);
        QCOMPARE(context.undoStack().count(), 1);
    }
    void failuresAreSaid()
    {
        model::TerrainDocument document(tests::sandbox());
        commands::TerrainContext context(document);
        BackgroundEdit work(context);
        QSignalSpy failed(&work, &BackgroundEdit::failed);
        work.start(QStringLiteral("Fill"), [](TinEdit &, const model::Progress &) -> model::Result<void> {
            return model::fail(model::ErrorCode::OutOfMemory);
        });
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(!failed[0][0].toString().isEmpty());
        QCOMPARE(context.undoStack().count(), 0);
    }
};

SANDREEL_TEST(TestBackgroundEdit)
#include "tst_backgroundedit.moc"
