// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery/recoverydialog.h"
#include "commands/terrain/setmask.h"
#include "model/io/terrain/newterrain.h"
#include "tests/app/editor/raiseground.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <QApplication>
#include <QDirIterator>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <cstdio>

using editor::ActionId;
using editor::RecoveryEntry;

namespace {

constexpr auto ChildVariable = "SANDREEL_TEST_CHILD";

} // namespace

/// What is left of a terrain when the program ends without closing it, and how it comes back.
class TestRecovery final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    static QString makeFile(const QString &folder)
    {
        model::io::NewTerrain description;
        description.width = description.depth = 20;
        description.spacing = 1;
        const auto terrain = model::io::makeTerrain(description);
        const QString path = folder + QStringLiteral("/ground.terrain");
        if (!terrain || !model::io::saveTerrain(path, *terrain, {}))
            QTest::qFail("the test file cannot be made", __FILE__, __LINE__);
        return path;
    }

private slots:
    void init()
    {
        QSettings().clear();
        if (!qEnvironmentVariableIsSet(ChildVariable))
            QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    /// Not a test but the program that is killed: edits a terrain until then, and says what it is after each edit.
    void child()
    {
        if (!qEnvironmentVariableIsSet(ChildVariable))
            return;
        tests::WindowDriver driver;
        driver.window.open({qEnvironmentVariable(ChildVariable)});
        QVERIFY(driver.settle());
        editor::OpenTerrain &document = driver.terrain();
        for (int step = 1;; ++step) {
            document.context()->push<tests::RaiseGround>(0.125 * step);
            std::printf("after %llu\n", static_cast<unsigned long long>(document.terrain().fingerprint()));
            if (step == 5) {
                document.record().waitUntilWritten();
                std::printf("written\n");
            }
            std::fflush(stdout);
            QTest::qWait(step < 5 ? 1 : 20);
        }
    }

    void killedMidEditItComesBack()
    {
        const QString path = makeFile(mFolder->path());
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(ChildVariable, path);
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {"tst_recovery", "child"});
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT((said += process.readAllStandardOutput()).contains("written\n"), 60000);
        QTest::qWait(300);                           // in the midst of further edits
        QVERIFY(RecoveryEntry::leftovers().empty()); // it is still running
        process.kill();
        QVERIFY(process.waitForFinished());
        said += process.readAllStandardOutput();
        QStringList states;
        qsizetype written = 0;
        for (const QByteArray &line : said.split('\n')) {
            if (line.startsWith("after "))
                states << QString::fromLatin1(line.mid(6));
            else if (line == "written")
                written = states.size() - 1;
        }

        tests::WindowDriver driver;
        driver.window.offerRecovery();
        auto *dialog = driver.window.findChild<editor::RecoveryDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        auto *list = dialog->findChild<QListWidget *>("leftovers");
        QCOMPARE(list->count(), 1);
        QVERIFY(list->item(0)->text().contains("ground") && list->item(0)->text().contains(path));
        QTest::mouseClick(dialog->findChild<QPushButton *>("recover"), Qt::LeftButton);
        QTRY_VERIFY(driver.window.workspace().currentTerrain());
        QVERIFY(driver.settle());
        const QString state = QString::number(driver.terrain().terrain().fingerprint());
        QVERIFY2(states.indexOf(state) >= written, qPrintable(said));
        QCOMPARE(driver.terrain().path(), path);
        QVERIFY(driver.terrain().isModified());
        // It stays on the disk until it is saved, and not longer.
        driver.terrain().record().waitUntilWritten();
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        QVERIFY(!driver.terrain().isModified());
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QCOMPARE(QString::number(driver.terrain().terrain().fingerprint()), state);
        driver.action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(!driver.window.findChild<editor::TerrainTab *>());
        QVERIFY(RecoveryEntry::leftovers().empty());
    }

    void paintedMaskComesBack_data()
    {
        QTest::addColumn<bool>("isSaved");
        QTest::newRow("of a file") << true;
        QTest::newRow("never saved") << false;
    }
    void paintedMaskComesBack()
    {
        QFETCH(bool, isSaved);
        const auto rectangle = [](const editor::OpenTerrain &document) { return document.terrain().tin().domain(); };
        model::GroundMask::Value painted;
        {
            tests::WindowDriver driver; // ends without closing its document, as after a crash
            driver.window.open({isSaved ? makeFile(mFolder->path()) : QStringLiteral(":/samples/dunes.terrain")});
            QVERIFY(driver.settle());
            editor::OpenTerrain &document = driver.terrain();
            model::terrain::PaintMask mask(rectangle(document));
            mask.paint(rectangle(document).low, rectangle(document).high, 3, 1, false);
            painted = std::make_shared<const model::terrain::PaintMask>(mask);
            document.context()->pushCommand(
                std::make_unique<commands::SetMask>(document.mask(), QStringLiteral("Paint"), painted));
            document.record().waitUntilWritten();
            const auto hasJournal = [] { // if there is no file, a snapshot is taken first
                const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
                return QDirIterator(data, {"*.journal"}, QDir::Files, QDirIterator::Subdirectories).hasNext();
            };
            QTRY_VERIFY(hasJournal());
            document.record().waitUntilWritten();
        }
        tests::WindowDriver driver;
        driver.window.offerRecovery();
        auto *dialog = driver.window.findChild<editor::RecoveryDialog *>();
        QVERIFY(dialog);
        QTest::mouseClick(dialog->findChild<QPushButton *>("recover"), Qt::LeftButton);
        QTRY_VERIFY(driver.window.workspace().currentTerrain());
        QVERIFY(driver.settle());
        QVERIFY(driver.terrain().mask()->value());
        QVERIFY(*driver.terrain().mask()->value() == *painted);
        QVERIFY(driver.terrain().isModified());
    }

    void nothingIsLeftOfWhatWasClosed_data()
    {
        QTest::addColumn<bool>("isSaved");
        QTest::newRow("saved") << true;
        QTest::newRow("discarded") << false;
    }
    void nothingIsLeftOfWhatWasClosed()
    {
        QFETCH(bool, isSaved);
        {
            tests::WindowDriver driver;
            driver.window.open({makeFile(mFolder->path())});
            QVERIFY(driver.settle());
            driver.terrain().context()->push<tests::RaiseGround>(1);
            driver.terrain().record().waitUntilWritten();
            if (isSaved) {
                driver.action(ActionId::Save).trigger();
                QVERIFY(driver.settle());
            } else {
                tests::withNextDialog([](QDialog &box) { tests::clickButton(box, "Discard"); });
            }
            driver.action(ActionId::CloseTab).trigger();
        }
        QVERIFY(RecoveryEntry::leftovers().empty());
    }

    void laterLeavesItAndDiscardRemovesIt()
    {
        {
            tests::WindowDriver driver; // ends without closing its document, as after a crash
            driver.window.open({makeFile(mFolder->path())});
            QVERIFY(driver.settle());
            driver.terrain().context()->push<tests::RaiseGround>(1);
            driver.terrain().record().waitUntilWritten();
        }
        tests::WindowDriver driver;
        driver.window.offerRecovery();
        auto *dialog = driver.window.findChild<editor::RecoveryDialog *>();
        QVERIFY(dialog);
        auto *list = dialog->findChild<QListWidget *>("leftovers");
        const qint64 empty = list->item(0)->icon().cacheKey();
        QTRY_VERIFY(list->item(0)->icon().cacheKey() != empty); // there is a picture
        QTest::mouseClick(dialog->findChild<QPushButton *>("later"), Qt::LeftButton);
        QTRY_VERIFY(!driver.window.findChild<editor::RecoveryDialog *>());
        QCOMPARE(RecoveryEntry::leftovers().size(), std::size_t(1));

        driver.window.offerRecovery();
        dialog = driver.window.findChild<editor::RecoveryDialog *>();
        tests::withNextDialog([](QDialog &recovery) {
            QTimer::singleShot(100, &recovery, [] { // the question lies over the dialog
                tests::clickButton(*QApplication::activeModalWidget(), "Discard");
            });
            recovery.findChild<QPushButton *>("discard")->click();
        });
        QTRY_VERIFY(RecoveryEntry::leftovers().empty());
    }

    void fileThatChangedSinceIsNotRecoveredWrongly()
    {
        const QString path = makeFile(mFolder->path());
        {
            tests::WindowDriver driver;
            driver.window.open({path});
            QVERIFY(driver.settle());
            driver.terrain().context()->push<tests::RaiseGround>(1);
            driver.terrain().record().waitUntilWritten();
        }
        QFile file(path);
        QVERIFY(file.open(QIODevice::Append));
        file.write("x");
        file.close();
        tests::WindowDriver driver;
        driver.window.offerRecovery();
        auto *dialog = driver.window.findChild<editor::RecoveryDialog *>();
        QTest::mouseClick(dialog->findChild<QPushButton *>("recover"), Qt::LeftButton);
        QTRY_COMPARE(driver.window.workspace().messages().texts().size(), 1);
        QVERIFY(driver.window.workspace().tabs().empty());
        QTRY_COMPARE(RecoveryEntry::leftovers().size(), std::size_t(1)); // nothing was thrown away
    }

    void diskThatIsFullIsSaidOnce()
    {
        tests::WindowDriver driver;
        driver.window.open({makeFile(mFolder->path())});
        QVERIFY(driver.settle());
        const tests::FileSizeLimit full(64);
        for (int i = 0; i < 3; ++i) {
            driver.terrain().context()->push<tests::RaiseGround>(1);
            driver.terrain().record().waitUntilWritten();
            QTest::qWait(10);
        }
        QCOMPARE(driver.window.workspace().messages().texts().size(), 1);
        QVERIFY(driver.window.workspace().messages().texts().constFirst().contains("ground"));
    }
};

SANDREEL_TEST(TestRecovery)
#include "tst_recovery.moc"
