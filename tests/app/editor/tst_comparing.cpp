// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"
#include "views/docks/timelinedock.h"
#include "views/viewport/animationviewport.h"
#include "views/widgets/errorplot.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QUndoStack>

using editor::ActionId;

/// Comparing with an original, as a person does it in the window.
class TestComparing final : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir mFolder;
    std::unique_ptr<tests::WindowDriver> mDriver;

    views::Comparison &comparison() { return mDriver->document().comparison(); }
    views::ErrorPlot &plot() { return *mDriver->window.findChild<views::ErrorPlot *>(); }
    QDialog *dialog() { return mDriver->window.findChild<QDialog *>("compareDialog"); }

    /// Opens the dialog through the menu's action.
    bool ask()
    {
        mDriver->action(ActionId::Compare).trigger();
        return QTest::qWaitFor([this] { return dialog() && dialog()->isVisible(); });
    }
    void choosePath(const QString &path)
    {
        auto *choice = dialog()->findChild<QComboBox *>("original");
        choice->setCurrentIndex(choice->count() - 1);
        auto *line = dialog()->findChild<QWidget *>("originalPath")->findChild<QLineEdit *>();
        line->setFocus();
        line->clear();
        QTest::keyClicks(line, path);
    }
    QPushButton *compareButton() { return dialog()->findChild<QPushButton *>("compare"); }
    bool waitForResult()
    {
        return QTest::qWaitFor([this] { return comparison().result().has_value(); }, 20000);
    }

private slots:
    /// Two tabs of the same animation, the second turned round.
    void init()
    {
        mDriver = std::make_unique<tests::WindowDriver>();
        QVERIFY(mDriver->open(tests::makeAnim(mFolder, "original.anim")));
        QVERIFY(mDriver->open(tests::makeAnim(mFolder, "decoded.anim")));
        mDriver->action(ActionId::Reverse).trigger();
    }
    void cleanup() { mDriver.reset(); }

    void withAnOpenAnimation()
    {
        QVERIFY(!mDriver->action(ActionId::StopComparing).isEnabled());
        QVERIFY(!mDriver->action(ActionId::ErrorColors).isEnabled());
        QVERIFY(ask());
        auto *choice = dialog()->findChild<QComboBox *>("original");
        QCOMPARE(choice->count(), 2);
        QCOMPARE(choice->currentText(), "original");
        QTest::mouseClick(compareButton(), Qt::LeftButton);
        QVERIFY(waitForResult());
        QVERIFY(comparison().result()->kgErrorPercent > 1);
        QVERIFY(plot().isVisible());
        QVERIFY(mDriver->document().isModified()); // by the turning round alone: one step
        QCOMPARE(mDriver->document().context()->undoStack().count(), 1);

        auto *viewport = mDriver->window.workspace().currentAnimation()->viewport();
        QVERIFY(viewport);
        QTRY_VERIFY(viewport->errorRange() > 0); // coloured at once
        mDriver->action(ActionId::ErrorRange).trigger();
        QVERIFY(viewport->isErrorRangeOfFrame());
        mDriver->action(ActionId::ErrorColors).trigger();
        QCOMPARE(viewport->errorRange(), 0.0f);
        QVERIFY(!mDriver->action(ActionId::ErrorRange).isEnabled());
        mDriver->action(ActionId::ErrorColors).trigger();

        QTest::mouseClick(&plot(), Qt::LeftButton, {}, QPoint(int(plot().placeOf(5).x()), 20));
        QCOMPARE(mDriver->document().player().playback().frame(), 4u);
        mDriver->action(ActionId::StopComparing).trigger();
        QVERIFY(!comparison().isActive() && !plot().isVisible());
        QCOMPARE(viewport->errorRange(), 0.0f);
    }

    void undoIsMeasuredAnew()
    {
        QVERIFY(ask());
        QTest::mouseClick(compareButton(), Qt::LeftButton);
        QVERIFY(waitForResult());
        mDriver->action(ActionId::Undo).trigger();
        QVERIFY(waitForResult());
        QCOMPARE(comparison().result()->maxVertexError, 0.0); // the same file twice
        auto *viewport = mDriver->window.workspace().currentAnimation()->viewport();
        QTRY_VERIFY(viewport->errorRange() > 0); // the first colour everywhere
    }

    void withAFile()
    {
        QVERIFY(ask());
        choosePath(mFolder.filePath("nothing-here"));
        QVERIFY(!compareButton()->isEnabled());
        choosePath(mFolder.filePath("original.anim"));
        QVERIFY(compareButton()->isEnabled());
        QTest::mouseClick(compareButton(), Qt::LeftButton);
        QVERIFY(waitForResult());
        QCOMPARE(comparison().originalName(), "original.anim");
    }

    void whatDoesNotMatchIsSaid()
    {
        QFile mesh(mFolder.filePath("triangle.obj"));
        QVERIFY(mesh.open(QIODevice::WriteOnly));
        mesh.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        mesh.close();
        QVERIFY(ask());
        choosePath(mesh.fileName());
        QTest::mouseClick(compareButton(), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([this] { return !comparison().isActive(); }, 20000));
        QVERIFY(!plot().isVisible());
        const views::LogModel &log = mDriver->window.log();
        const QString last = log.index(log.rowCount() - 1, log.columnCount() - 1).data().toString();
        QVERIFY2(last.contains("triangle.obj"), qPrintable(last));
    }

    /// Each tab has its own comparison; the dock shows that of the present one.
    void belongsToItsTab()
    {
        QVERIFY(ask());
        QTest::mouseClick(compareButton(), Qt::LeftButton);
        QVERIFY(waitForResult());
        mDriver->action(ActionId::NextTab).trigger();
        QVERIFY(!plot().isVisible() && !comparison().isActive());
        QVERIFY(!mDriver->action(ActionId::StopComparing).isEnabled());
        mDriver->action(ActionId::NextTab).trigger();
        QVERIFY(plot().isVisible() && mDriver->action(ActionId::StopComparing).isEnabled());
    }

    void closingTheTabClosesTheQuestion()
    {
        mDriver->action(ActionId::Undo).trigger(); // nothing to ask about when it closes
        QVERIFY(ask());
        mDriver->window.workspace().remove(*mDriver->window.workspace().current());
        QTRY_VERIFY(!dialog() || !dialog()->isVisible());
    }
};

SANDREEL_TEST(TestComparing)
#include "tst_comparing.moc"
