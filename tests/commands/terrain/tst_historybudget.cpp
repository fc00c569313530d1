// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/historybudget.h"
#include "tests/support/testmain.h"

#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

using namespace commands;

namespace {

/// Adds to a sum, and weighs what it is told.
class Add final : public WeightedCommand
{
public:
    Add(int &sum, int term, std::size_t bytes, int mergeId = -1)
        : WeightedCommand(QStringLiteral("Add %1").arg(term))
        , mSum(sum)
        , mTerm(term)
        , mBytes(bytes)
        , mMergeId(mergeId)
    {}
    void redo() override { mSum += mTerm; }
    void undo() override { mSum -= mTerm; }
    std::size_t byteSize() const override { return mBytes; }
    int id() const override { return mMergeId; }
    bool mergeWith(const QUndoCommand *newer) override
    {
        mTerm += static_cast<const Add *>(newer)->mTerm;
        setObsolete(mTerm == 0);
        return true;
    }

private:
    int &mSum;
    int mTerm;
    std::size_t mBytes;
    int mMergeId;
};

} // namespace

class TestHistoryBudget final : public QObject
{
    Q_OBJECT

    int mSum = 0;

    std::shared_ptr<Add> add(int term, std::size_t bytes, int mergeId = -1)
    {
        return std::make_shared<Add>(mSum, term, bytes, mergeId);
    }

private slots:
    void init() { mSum = 0; }
    void theOldestStepsGo()
    {
        QUndoStack stack;
        HistoryBudget budget(stack);
        budget.setLimit(350);
        for (int i = 1; i <= 5; ++i)
            budget.push(add(i, 100));
        QCOMPARE(mSum, 15);
        QCOMPARE(stack.count(), 3);
        QCOMPARE(stack.text(0), QStringLiteral("Add 3"));
        QCOMPARE(budget.droppedCount(), 2);
        QCOMPARE(budget.used(), std::size_t(300));
        stack.setIndex(0);
        QCOMPARE(mSum, 3); // what was dropped cannot be undone
        QVERIFY(!stack.canUndo());
        stack.setIndex(3);
        QCOMPARE(mSum, 15);
    }
    void theNewestStepStaysHoweverLarge()
    {
        QUndoStack stack;
        HistoryBudget budget(stack);
        budget.setLimit(100);
        budget.push(add(1, 50));
        budget.push(add(2, 5000));
        QCOMPARE(stack.count(), 1);
        stack.undo();
        QCOMPARE(mSum, 1);
    }
    void whatCanBeRedoneCountsToo()
    {
        QUndoStack stack;
        HistoryBudget budget(stack);
        for (int i = 1; i <= 6; ++i)
            budget.push(add(i, 100));
        stack.setIndex(3);
        QCOMPARE(mSum, 6);
        QSignalSpy index(&stack, &QUndoStack::indexChanged);
        budget.setLimit(400);
        QCOMPARE(stack.count(), 4); // 3 to undo, of which the newest is left, and 3 to redo
        QCOMPARE(stack.index(), 1);
        QCOMPARE(mSum, 6);
        QVERIFY(index.count() >= 1); // views of the stack read it anew
        budget.setLimit(200);
        QCOMPARE(stack.count(), 2);
        QCOMPARE(stack.index(), 1);
        stack.redo();
        QCOMPARE(mSum, 10);
        stack.setIndex(0);
        QCOMPARE(mSum, 3);
    }
    void whatIsSavedStaysMarked()
    {
        QUndoStack stack;
        HistoryBudget budget(stack);
        for (int i = 1; i <= 4; ++i) {
            budget.push(add(i, 100));
            if (i == 3)
                stack.setClean();
        }
        budget.setLimit(200);
        QCOMPARE(stack.count(), 2);
        QVERIFY(!stack.isClean());
        stack.undo();
        QVERIFY(stack.isClean());
        QCOMPARE(mSum, 6);
        stack.redo();
        budget.push(add(5, 100));
        budget.push(add(6, 100));
        // The saved state is behind what can be undone.
        stack.setIndex(0);
        QVERIFY(!stack.isClean());
        QCOMPARE(stack.cleanIndex(), -1);
    }
    void stepsMergeAsTheyWould()
    {
        QUndoStack stack;
        HistoryBudget budget(stack);
        budget.push(add(1, 100));
        budget.push(add(2, 100, 7));
        budget.push(add(3, 100, 7));
        QCOMPARE(stack.count(), 2);
        QCOMPARE(mSum, 6);
        budget.push(add(-5, 100, 7)); // back where it began
        QCOMPARE(stack.count(), 1);
        // Two that would merge stay two when the stack is filled again.
        budget.push(add(1, 100, 7));
        stack.setClean();
        budget.push(add(1, 100, 7));
        QCOMPARE(stack.count(), 3);
        budget.setLimit(250);
        QCOMPARE(stack.count(), 2);
        stack.setIndex(0);
        QCOMPARE(mSum, 1);
    }
};

SANDREEL_TEST(TestHistoryBudget)
#include "tst_historybudget.moc"
