// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationwriter.h"
#include "model/io/animfile.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/busyjobs.h"
#include "tests/support/testmain.h"
#include "views/dialogs/editdialog.h"
#include "views/dialogs/preparedialog.h"

#include <QMessageBox>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>

using editor::ActionId;

/// What happens to work that is not done yet, and to dialogs, when somebody cancels, closes or quits.
class TestClosing final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    static int errorCount(tests::WindowDriver &driver)
    {
        int errors = 0;
        for (int row = 0; row < driver.window.log().rowCount(); ++row)
            errors += driver.window.log().level(row) == views::LogLevel::Error;
        return errors;
    }

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    void openingIsCancelledFromItsIndicator()
    {
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        {
            const tests::BusyJobs busy; // it does not open before it is cancelled
            driver.window.open({path});
            QVERIFY(driver.document().isOpening());
            auto *cancel = driver.window.findChild<QPushButton *>("cancelOpening");
            QTRY_VERIFY(cancel && cancel->isVisible());
            QVERIFY(driver.window.workspace().current()->findChild<QProgressBar *>()->isVisible());
            QTest::mouseClick(cancel, Qt::LeftButton);
            QVERIFY(!driver.action(ActionId::Trim).isEnabled());
        }
        QTRY_VERIFY(driver.window.workspace().tabs().empty());
        // Nothing went wrong, and nothing was opened.
        QVERIFY(driver.window.workspace().messages().texts().isEmpty());
        QCOMPARE(errorCount(driver), 0);
        QVERIFY(editor::Settings().recentFiles().isEmpty());
        QVERIFY(driver.open(path));
    }

    void editDialogClosesWithItsDocument_data()
    {
        QTest::addColumn<int>("action");
        QTest::newRow("trim") << int(ActionId::Trim);
        QTest::newRow("resample") << int(ActionId::Resample);
        QTest::newRow("frame rate") << int(ActionId::FrameRate);
        QTest::newRow("normalise") << int(ActionId::Normalise);
        QTest::newRow("rename") << int(ActionId::Rename);
    }
    void editDialogClosesWithItsDocument()
    {
        QFETCH(int, action);
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        QVERIFY(driver.open(path));
        driver.action(ActionId::Reverse).trigger();
        QPointer<views::EditDialog> dialog;
        {
            const tests::BusyJobs busy;
            driver.action(ActionId::Save).trigger();
            driver.action(ActionId::CloseTab).trigger(); // when it is saved
            QCOMPARE(driver.window.workspace().tabs().size(), std::size_t(1));
            driver.action(ActionId(action)).trigger();
            dialog = driver.window.findChild<views::EditDialog *>();
            QVERIFY(dialog && dialog->isVisible());
        }
        QTRY_VERIFY(driver.window.workspace().tabs().empty());
        QTRY_VERIFY(!dialog);
        QVERIFY(model::io::openAnim(path).has_value());
        QVERIFY(driver.open(path)); // the window takes orders again
    }

    void editDialogClosesWhenItsDocumentIsReloaded()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        QPointer<views::EditDialog> dialog;
        {
            const tests::BusyJobs busy;
            driver.action(ActionId::Reload).trigger();
            driver.action(ActionId::Rename).trigger();
            dialog = driver.window.findChild<views::EditDialog *>();
            QVERIFY(dialog && dialog->isVisible());
        }
        QVERIFY(driver.settle());
        QTRY_VERIFY(!dialog);
        QVERIFY(!driver.document().isModified());
    }

    void quittingWhileEncodingAsks()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        const QString frames = mFolder->filePath("frames");
        QVERIFY(model::io::writeFrames(frames, *driver.document().context()->document().frames(),
                                       model::io::MeshFormat::Obj));
        driver.window.open({frames}); // a folder: to be prepared
        const QPointer<views::PrepareDialog> dialog = driver.window.findChild<views::PrepareDialog *>();
        QVERIFY(dialog);
        auto *encode = dialog->findChild<QPushButton *>("encode");
        QTRY_VERIFY(encode->isEnabled());
        {
            const tests::BusyJobs busy;
            QTest::mouseClick(encode, Qt::LeftButton);
            QVERIFY(dialog->isEncoding());
            QString question;
            tests::withNextDialog([&question](QDialog &box) {
                question = qobject_cast<QMessageBox *>(&box)->text();
                tests::clickButton(box, "Keep Encoding");
            });
            QVERIFY(!driver.window.close());
            QCOMPARE(question, QString("The animation is still being encoded."));
            QVERIFY(driver.window.isVisible());
            QVERIFY(dialog && dialog->isVisible() && dialog->isEncoding());
            tests::withNextDialog([](QDialog &box) { tests::clickButton(box, "Stop Encoding"); });
            QVERIFY(driver.window.close());
            QVERIFY(!driver.window.isVisible());
        }
        QTest::qWait(100); // what was queued runs now, and finds itself cancelled
        QVERIFY(!QFile::exists(mFolder->filePath("frames.anim")));
    }

    void quittingWhileOpeningJustQuits()
    {
        tests::WindowDriver driver;
        const tests::BusyJobs busy;
        driver.window.open({tests::makeAnim(*mFolder)});
        QVERIFY(driver.document().isOpening());
        QVERIFY(driver.window.close());
    }
};

SANDREEL_TEST(TestClosing)
#include "tst_closing.moc"
