// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/setcompression.h"
#include "commands/animation/setframerate.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

using namespace commands;
using model::AnimationDocument;
using model::CompressionSettings;

/// Merging, for every command that merges: they share it.
class TestSetCompression final : public QObject
{
    Q_OBJECT

    AnimationDocument mDocument{tests::wave(tests::cube())};
    std::unique_ptr<AnimationContext> mContext;

    static CompressionSettings withBasis(std::uint32_t size) { return {model::PcaSettings{size, 10000}}; }
    QUndoStack &stack() { return mContext->undoStack(); }
    std::uint32_t basisSize() const { return std::get<model::PcaSettings>(mDocument.compression().method).basisSize; }

private slots:
    void init()
    {
        mDocument.setCompression(withBasis(20));
        mContext = std::make_unique<AnimationContext>(mDocument);
    }

    void oneDragIsOneStep()
    {
        const GestureId drag = mContext->newGesture();
        for (const std::uint32_t size : {21u, 25u, 24u, 30u})
            mContext->push<SetCompression>(withBasis(size), drag);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QString("Set Basis Size to 30"));
        QCOMPARE(basisSize(), 30u);
        stack().undo();
        QCOMPARE(basisSize(), 20u);
        stack().redo();
        QCOMPARE(basisSize(), 30u);
        stack().undo();
        QCOMPARE(basisSize(), 20u);
    }

    void twoDragsAreTwo()
    {
        for (int i = 0; i < 2; ++i) {
            const GestureId drag = mContext->newGesture();
            mContext->push<SetCompression>(withBasis(30 + 10 * std::uint32_t(i)), drag);
            mContext->push<SetCompression>(withBasis(31 + 10 * std::uint32_t(i)), drag);
        }
        QCOMPARE(stack().count(), 2);
        stack().undo();
        QCOMPARE(basisSize(), 31u);
    }

    void aDragBackIsNone()
    {
        const std::uint64_t before = mDocument.fingerprint();
        const GestureId drag = mContext->newGesture();
        for (const std::uint32_t size : {21u, 25u, 20u})
            mContext->push<SetCompression>(withBasis(size), drag);
        QCOMPARE(stack().count(), 0);
        QVERIFY(stack().isClean());
        QCOMPARE(mDocument.fingerprint(), before);
        // The drag goes on.
        mContext->push<SetCompression>(withBasis(22), drag);
        QCOMPARE(stack().count(), 1);
        stack().undo();
        QCOMPARE(basisSize(), 20u);
    }

    void withoutAGestureNothingMerges()
    {
        mContext->push<SetCompression>(withBasis(21));
        mContext->push<SetCompression>(withBasis(22));
        QCOMPARE(stack().count(), 2);
    }

    void otherCommandsInBetweenEndTheStep()
    {
        const GestureId drag = mContext->newGesture();
        mContext->push<SetCompression>(withBasis(21), drag);
        mContext->push<SetFrameRate>(30.0, drag);
        mContext->push<SetCompression>(withBasis(22), drag);
        QCOMPARE(stack().count(), 3);
        stack().undo();
        QCOMPARE(basisSize(), 21u);
        stack().undo();
        QCOMPARE(mDocument.timing().frameRate, 25.0);
        mDocument.setTiming({mDocument.timing().map, 25});
    }

    void aSaveEndsTheStep()
    {
        const GestureId drag = mContext->newGesture();
        mContext->push<SetCompression>(withBasis(21), drag);
        stack().setClean();
        mContext->push<SetCompression>(withBasis(22), drag);
        QCOMPARE(stack().count(), 2);
        QVERIFY(!stack().isClean());
        stack().undo();
        QVERIFY(stack().isClean());
        QCOMPARE(basisSize(), 21u);
    }
};

SANDREEL_TEST(TestSetCompression)
#include "tst_setcompression.moc"
