// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/resampleanimation.h"
#include "commands/animation/reverseanimation.h"
#include "commands/animation/setframerate.h"
#include "commands/animation/trimanimation.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/support/undocheck.h"

#include <algorithm>

using namespace commands;
using model::AnimationDocument;
using model::Vec3f;

/// What the commands that change the timing do to the frames themselves.
class TestTiming final : public QObject
{
    Q_OBJECT

    using Frames = std::vector<std::vector<Vec3f>>;

    const tests::SequencePtr mSource = tests::noise(tests::cube(), 10);
    const Frames mOriginal = tests::allFramesOf(*mSource);

private slots:
    void trimKeepsFirstToLast()
    {
        AnimationDocument document(mSource);
        AnimationContext context(document);
        context.push<TrimAnimation>(2u, 7u);
        QVERIFY(tests::allFramesOf(*document.frames()) == Frames(mOriginal.begin() + 2, mOriginal.begin() + 8));
        context.push<TrimAnimation>(1u, 3u); // counted in what is left
        QVERIFY(tests::allFramesOf(*document.frames()) == Frames(mOriginal.begin() + 3, mOriginal.begin() + 6));
        QCOMPARE(document.timing().frameRate, 25.0);
        context.undoStack().undo();
        QCOMPARE(document.frameCount(), 6u);
    }

    void reverseTurnsRound()
    {
        AnimationDocument document(mSource);
        AnimationContext context(document);
        context.push<ReverseAnimation>();
        QVERIFY(tests::allFramesOf(*document.frames()) == Frames(mOriginal.rbegin(), mOriginal.rend()));
        context.push<ReverseAnimation>();
        QVERIFY(document.frames()->keepsFrames());
        QCOMPARE(context.undoStack().count(), 2);
    }

    void resampleKeepsSpeedAndFramesThatStay()
    {
        AnimationDocument document(mSource);
        AnimationContext context(document);
        context.push<ResampleAnimation>(75.0);
        QCOMPARE(document.frameCount(), 28u);
        QCOMPARE(document.frames()->frameRate(), 75.0);
        for (std::uint32_t frame = 0; frame < 10; ++frame)
            QVERIFY(document.frames()->frame(3 * frame) == mOriginal[frame]);
        const Vec3f a = mOriginal[4][5], b = mOriginal[5][5], between = document.frames()->frame(13)[5];
        QVERIFY(length(between - (2.0f / 3 * a + 1.0f / 3 * b)) < 1e-6f);
        context.push<ResampleAnimation>(25.0);
        QVERIFY(document.frames()->keepsFrames());
        QCOMPARE(document.timing().frameRate, 25.0);
    }

    void setFrameRateKeepsFrames()
    {
        AnimationDocument document(mSource);
        AnimationContext context(document);
        context.push<SetFrameRate>(60.0);
        QCOMPARE(document.frames()->frameRate(), 60.0);
        QVERIFY(document.frames()->keepsFrames());
        // Resampling starts from the new rate.
        context.push<ResampleAnimation>(20.0);
        QCOMPARE(document.frameCount(), 4u);
        QVERIFY(document.frames()->frame(1) == mOriginal[3]);
    }

    void rateGesturesMerge()
    {
        AnimationDocument document(mSource);
        AnimationContext context(document);
        const GestureId gesture = context.newGesture();
        for (const double rate : {26.0, 27.0, 40.0})
            context.push<SetFrameRate>(rate, gesture);
        QCOMPARE(context.undoStack().count(), 1);
        QCOMPARE(context.undoStack().undoText(), QString("Play at 40 fps"));
        context.undoStack().undo();
        QCOMPARE(document.timing().frameRate, 25.0);
        context.undoStack().redo();
        QCOMPARE(document.timing().frameRate, 40.0);
    }
};

SANDREEL_TEST(TestTiming)
#include "tst_timing.moc"
