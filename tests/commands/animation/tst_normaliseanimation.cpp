// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/normaliseanimation.h"
#include "commands/animation/reverseanimation.h"
#include "commands/animation/trimanimation.h"
#include "model/animation/normalisation.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace commands;
using model::AnimationDocument;
using model::Normalisation;

class TestNormaliseAnimation final : public QObject
{
    Q_OBJECT

    static void normalise(AnimationContext &context, Normalisation mode)
    {
        context.push<NormaliseAnimation>(*model::normalisingPlacement(*context.document().frames(), mode));
    }

private slots:
    void fillsTheCube()
    {
        AnimationDocument document(tests::noise(tests::twoParts(), 9));
        AnimationContext context(document);
        normalise(context, Normalisation::AllFrames);
        const model::Box3f box = *model::boundingBoxOfAll(*document.frames());
        QVERIFY(length(box.center()) < 1e-6f && std::abs(box.longestSide() - 2) < 1e-6f);
        QCOMPARE(context.undoStack().undoText(), QString("Normalise Animation"));
    }

    void againChangesNothing()
    {
        AnimationDocument document(tests::noise(tests::twoParts(), 9));
        AnimationContext context(document);
        for (int i = 0; i < 3; ++i)
            normalise(context, Normalisation::AllFrames);
        QCOMPARE(context.undoStack().count(), 1);
    }

    void modesDoNotDependOnTheOneBefore()
    {
        AnimationDocument document(tests::noise(tests::twoParts(), 9));
        AnimationContext context(document);
        normalise(context, Normalisation::FirstFrame);
        const model::Similarity byFirst = document.placement();
        normalise(context, Normalisation::AllFrames);
        QVERIFY(document.placement() != byFirst);
        normalise(context, Normalisation::FirstFrame);
        QVERIFY(document.placement() == byFirst);
    }

    void noneTakesItBack()
    {
        const auto source = tests::noise(tests::twoParts(), 9);
        AnimationDocument document(source);
        AnimationContext context(document);
        normalise(context, Normalisation::None);
        QCOMPARE(context.undoStack().count(), 0);
        normalise(context, Normalisation::FirstFrame);
        normalise(context, Normalisation::None);
        QCOMPARE(context.undoStack().undoText(), QString("Remove Normalisation"));
        QVERIFY(document.frames()->frame(4) == source->frame(4));
    }

    /// "First frame" is the first one as edited.
    void followsTheEditedFrames()
    {
        const auto source = tests::noise(tests::twoParts(), 9);
        AnimationDocument document(source);
        AnimationContext context(document);
        context.push<ReverseAnimation>();
        context.push<TrimAnimation>(2u, 5u);
        normalise(context, Normalisation::FirstFrame);
        const model::Box3f box = model::boundingBoxOf(*source, 6);
        QVERIFY(std::abs(document.placement().scale - 2 / box.longestSide()) < 1e-6);
    }
};

SANDREEL_TEST(TestNormaliseAnimation)
#include "tst_normaliseanimation.moc"
