// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/changematerials.h"
#include "commands/terrain/terraincontext.h"
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"

#include <QSignalSpy>
#include <QUndoStack>

using namespace commands;
using namespace model::terrain;
using model::TerrainDocument;

class TestGesture final : public QObject
{
    Q_OBJECT

    static const Edit *raise(TerrainContext &context, VertexId v)
    {
        return context.edit([v](TinEdit &edit) { edit.setHeight(v, edit.tin().arrays().heights[v] + 0.01); });
    }
    /// A vertex more, so that edits do not commute.
    static void insert(TerrainContext &context, Point2 p)
    {
        context.edit([p](TinEdit &edit) { edit.insert(p, 1.5); });
    }

private slots:
    void manyEditsAreOneStep()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Imprint"));
        for (VertexId v = 4; v < 20; ++v) {
            QVERIFY(raise(context, v));
            insert(context, {0.01 * v, 0.511});
        }
        const tests::State after(document);
        context.endGesture();
        QVERIFY(!context.hasGesture());
        QCOMPARE(context.undoStack().count(), 1);
        QCOMPARE(context.undoStack().text(0), QStringLiteral("Imprint"));
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
        context.undoStack().redo();
        QVERIFY(tests::State(document) == after);
        context.beginGesture(QStringLiteral("Nothing"));
        QVERIFY(!context.edit([](TinEdit &) {}));
        context.endGesture();
        QCOMPARE(context.undoStack().count(), 1);
    }
    /// A slide of many frames keeps what it wrote over once, and its one step is undone and redone to the byte.
    void aLongGestureKeepsWhatItWroteOnce()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Let Sand Slide"));
        std::size_t once = 0;
        for (int frame = 0; frame < 500; ++frame) {
            const Edit *const edit = context.edit([frame](TinEdit &open) {
                for (VertexId v = 4; v < 30; ++v)
                    open.setHeight(v, 1 + 0.01 * ((frame + int(v)) % 7));
            });
            QVERIFY(edit && edit->dirtyRanges(TinPart::Heights).front().first == 4); // of this frame alone
            once = std::max(once, edit->byteSize());
        }
        context.endGesture();
        QCOMPARE(context.undoStack().count(), 1);
        QVERIFY2(context.history().used() <= 6 * once, qPrintable(QString::number(context.history().used())));
        const tests::State after(document);
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
        context.undoStack().redo();
        QVERIFY(tests::State(document) == after);
    }
    void undoInTheMidstEndsTheGestureAndIsExact()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        QSignalSpy ended(&context, &TerrainContext::gestureEnded);
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Rake"));
        insert(context, {0.3, 0.3});
        raise(context, 7);
        context.undoStack().undo(); // as the menu does, which knows nothing of gestures
        QVERIFY(tests::State(document) == before);
        QVERIFY(!context.hasGesture());
        QCOMPARE(ended.count(), 1);
        QVERIFY(context.undoStack().canRedo());
        context.undoStack().redo();
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
    }
    void cancelLeavesNoTrace()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        context.push<AddMaterial>(material(MaterialPreset::Mud));
        context.undoStack().setClean();
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Rake"));
        insert(context, {0.3, 0.3});
        insert(context, {0.31, 0.3});
        QVERIFY(!context.undoStack().isClean());
        context.cancelGesture();
        QVERIFY(tests::State(document) == before);
        QCOMPARE(context.undoStack().count(), 1);
        QVERIFY(context.undoStack().isClean());
        QVERIFY(!context.undoStack().canRedo());
    }
    void anotherCommandEndsTheGesture()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        QSignalSpy ended(&context, &TerrainContext::gestureEnded);
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Rake"));
        insert(context, {0.3, 0.3});
        context.push<AddMaterial>(material(MaterialPreset::Mud));
        QVERIFY(!context.hasGesture());
        QCOMPARE(ended.count(), 1);
        QCOMPARE(context.undoStack().count(), 2);
        context.undoStack().setIndex(0);
        QVERIFY(tests::State(document) == before);
    }
    void aSaveInTheMidstPartsTheStep()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        const tests::State before(document);
        context.beginGesture(QStringLiteral("Imprint"));
        insert(context, {0.3, 0.3});
        context.undoStack().setClean();
        const tests::State saved(document);
        insert(context, {0.4, 0.3});
        QVERIFY(!context.undoStack().isClean()); // or what slides after a save would be lost on closing
        context.endGesture();
        QCOMPARE(context.undoStack().count(), 2);
        context.undoStack().undo();
        QVERIFY(context.undoStack().isClean());
        QVERIFY(tests::State(document) == saved);
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
    }
};

SANDREEL_TEST(TestGesture)
#include "tst_gesture.moc"
