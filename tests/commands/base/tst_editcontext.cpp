// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/renameanimation.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <set>

using namespace commands;

class TestEditContext final : public QObject
{
    Q_OBJECT

private slots:
    void pushCarriesOutOnce()
    {
        model::AnimationDocument document(tests::wave(tests::cube()));
        AnimationContext context(document);
        QVERIFY(&context.document() == &document);
        int notices = 0;
        connect(&document, &model::AnimationDocument::changed, this, [&] { ++notices; });
        context.push<RenameAnimation>("other");
        QCOMPARE(notices, 1);
        QVERIFY(document.name() == "other");
        QCOMPARE(context.undoStack().count(), 1);
        QVERIFY(!context.undoStack().isClean());
    }

    void everyGestureHasItsNumber()
    {
        model::AnimationDocument document(tests::wave(tests::cube()));
        AnimationContext context(document);
        std::set<GestureId> gestures{NoGesture};
        for (int i = 0; i < 100; ++i)
            gestures.insert(context.newGesture());
        QCOMPARE(gestures.size(), std::size_t(101));
    }
};

SANDREEL_TEST(TestEditContext)
#include "tst_editcontext.moc"
