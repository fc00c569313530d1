// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/views/dialogs/dialogdriver.h"
#include "views/dialogs/frameratedialog.h"
#include "views/dialogs/normalisedialog.h"
#include "views/dialogs/renamedialog.h"
#include "views/dialogs/resampledialog.h"
#include "views/dialogs/trimdialog.h"

#include <QLocale>
#include <QPushButton>

using tests::click;
using tests::textOf;
using tests::typeInto;

/// Each dialog changes the document by one step that undo takes back.
class TestEditDialogs final : public QObject
{
    Q_OBJECT

    std::unique_ptr<model::AnimationDocument> mDocument;
    std::unique_ptr<commands::AnimationContext> mContext;
    std::uint64_t mBefore = 0;

    static bool mayAccept(const QDialog &dialog) { return tests::find<QPushButton>(dialog, "accept")->isEnabled(); }
    void checkOneStep()
    {
        QCOMPARE(mContext->undoStack().count(), 1);
        QVERIFY(mDocument->fingerprint() != mBefore);
        mContext->undoStack().undo();
        QCOMPARE(mDocument->fingerprint(), mBefore);
    }

private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_US"));
        mDocument = std::make_unique<model::AnimationDocument>(tests::wave(tests::cube(), 50)); // 25 frames/s
        mContext = std::make_unique<commands::AnimationContext>(*mDocument);
        mBefore = mDocument->fingerprint();
    }
    void cleanup()
    {
        mContext.reset();
        mDocument.reset();
        QLocale::setDefault(QLocale::c());
    }

    void trimKeepsTheNamedFrames()
    {
        const auto third = mDocument->frames()->frame(2);
        views::TrimDialog dialog(*mContext, 1, 48);
        tests::open(dialog);
        QCOMPARE(textOf(dialog, "first"), QString("2")); // people count from 1
        QCOMPARE(textOf(dialog, "last"), QString("49"));
        typeInto(dialog, "first", "3");
        typeInto(dialog, "last", "12");
        QCOMPARE(textOf(dialog, "hint"), QString("Frames: 50 → 10"));
        click(dialog, "accept");
        QVERIFY(!dialog.isVisible());
        QCOMPARE(mDocument->frameCount(), 10u);
        QVERIFY(mDocument->frames()->frame(0) == third);
        checkOneStep();
    }

    void trimRefusesWhatIsNotThere()
    {
        views::TrimDialog dialog(*mContext, 0, 49);
        tests::open(dialog);
        typeInto(dialog, "last", "51");
        QVERIFY(!mayAccept(dialog));
        typeInto(dialog, "last", "10");
        typeInto(dialog, "first", "11");
        QVERIFY(!mayAccept(dialog));
        QCOMPARE(textOf(dialog, "hint"), QString("The first frame must not come after the last."));
        typeInto(dialog, "first", "10");
        QVERIFY(mayAccept(dialog));
    }

    void resampleSaysHowManyFramesItMakes()
    {
        views::ResampleDialog dialog(*mContext);
        tests::open(dialog);
        QCOMPARE(textOf(dialog, "rate"), QString("25"));
        typeInto(dialog, "rate", "50");
        const auto wanted = model::TimeMap::resampledFrameCount(50, 25, 50);
        QVERIFY(textOf(dialog, "hint").startsWith(QString("Frames: 50 → %1.").arg(wanted)));
        click(dialog, "accept");
        QCOMPARE(std::uint64_t(mDocument->frameCount()), wanted);
        QCOMPARE(mDocument->timing().frameRate, 50.0);
        checkOneStep();
    }

    void frameRateKeepsTheFrames()
    {
        views::FrameRateDialog dialog(*mContext);
        tests::open(dialog);
        typeInto(dialog, "rate", "1001");
        QVERIFY(!mayAccept(dialog));
        typeInto(dialog, "rate", "12.5");
        QVERIFY(textOf(dialog, "hint").startsWith("Duration: 2 s → 4 s."));
        QTest::keyClick(&dialog, Qt::Key_Return);
        QCOMPARE(mDocument->frameCount(), 50u);
        QCOMPARE(mDocument->timing().frameRate, 12.5);
        checkOneStep();
    }

    void frameRateTakesADecimalComma()
    {
        QLocale::setDefault(QLocale("cs_CZ"));
        views::FrameRateDialog dialog(*mContext);
        tests::open(dialog);
        typeInto(dialog, "rate", "29,97");
        click(dialog, "accept");
        QCOMPARE(mDocument->timing().frameRate, 29.97);
    }

    void renameChangesTheName()
    {
        views::RenameDialog dialog(*mContext);
        tests::open(dialog);
        typeInto(dialog, "name", "Žluťoučký kůň");
        click(dialog, "accept");
        QCOMPARE(QString::fromStdString(mDocument->name()), QString("Žluťoučký kůň"));
        checkOneStep();
    }

    void normaliseFillsTheCube()
    {
        mContext.reset();
        mDocument = std::make_unique<model::AnimationDocument>(tests::wave(tests::grid(), 10)); // of side 1
        mContext = std::make_unique<commands::AnimationContext>(*mDocument);
        mBefore = mDocument->fingerprint();
        views::NormaliseDialog normalise(*mContext);
        tests::open(normalise);
        click(normalise, "accept");
        QTRY_VERIFY(!normalise.isVisible());
        model::Box3f box;
        for (std::uint32_t frame = 0; frame < mDocument->frameCount(); ++frame)
            box.add(model::boundingBox(mDocument->frames()->frame(frame)));
        QVERIFY(std::abs(box.longestSide() - 2) < 1e-5);
        checkOneStep();
    }

    void cancelledDialogChangesNothing()
    {
        views::TrimDialog trim(*mContext, 0, 49);
        tests::open(trim);
        typeInto(trim, "last", "12");
        QTest::keyClick(&trim, Qt::Key_Escape);
        views::NormaliseDialog normalise(*mContext);
        tests::open(normalise);
        click(normalise, "accept");
        normalise.reject(); // while it measures
        QTest::qWait(100);
        QCOMPARE(mContext->undoStack().count(), 0);
        QCOMPARE(mDocument->fingerprint(), mBefore);
    }

    void sameValueLeavesNoStep()
    {
        views::FrameRateDialog dialog(*mContext);
        tests::open(dialog);
        click(dialog, "accept");
        QCOMPARE(mContext->undoStack().count(), 0);
    }

    void closesWithItsDocument()
    {
        views::RenameDialog dialog(*mContext);
        tests::open(dialog);
        mContext.reset();
        QVERIFY(!dialog.isVisible());
    }

    void everyControlHasAName()
    {
        const views::TrimDialog trim(*mContext, 0, 49);
        const views::ResampleDialog resample(*mContext);
        const views::FrameRateDialog frameRate(*mContext);
        const views::RenameDialog rename(*mContext);
        const views::NormaliseDialog normalise(*mContext);
        for (const QDialog *dialog :
             std::initializer_list<const QDialog *>{&trim, &resample, &frameRate, &rename, &normalise})
            QCOMPARE(tests::unnamedWidgets(*dialog), QStringList());
    }
};

SANDREEL_TEST(TestEditDialogs)
#include "tst_editdialogs.moc"
