// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/samples.h"
#include "model/io/terrain/newterrain.h"
#include "tests/app/editor/raiseground.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/busyjobs.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"
#include "views/dialogs/exportterraindialog.h"
#include "views/dialogs/importterraindialog.h"
#include "views/dialogs/numberfield.h"
#include "views/docks/compressiondock.h"
#include "views/docks/historydock.h"
#include "views/docks/timelinedock.h"
#include "views/terrain/terrainviewport.h"

#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>

using editor::ActionId;

/// Terrains as documents of the editor: made, opened, imported, saved, and exported.
class TestTerrain final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    QString makeFile(const QString &name = QStringLiteral("hills.terrain")) const
    {
        model::io::NewTerrain description;
        description.width = description.depth = 20;
        description.spacing = 1;
        description.relief = {model::io::ReliefShape::Noise, 3, 8, 5};
        description.layers = {{model::terrain::material(model::terrain::MaterialPreset::DrySand), 0.5}};
        const auto terrain = model::io::makeTerrain(description);
        const QString path = mFolder->filePath(name);
        if (!terrain || !model::io::saveTerrain(path, *terrain, {}))
            QTest::qFail("the test file cannot be made", __FILE__, __LINE__);
        return path;
    }
    static QByteArray contentsOf(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    void madeEditedSavedAndOpenedAgainIsTheSame()
    {
        const QString path = mFolder->filePath("made.terrain");
        std::uint64_t fingerprint = 0;
        {
            tests::WindowDriver driver;
            tests::withNextDialog([](QDialog &dialog) {
                dialog.findChild<views::NumberField *>("width")->setValue(30);
                dialog.findChild<views::NumberField *>("depth")->setValue(20);
                dialog.findChild<views::NumberField *>("spacing")->setValue(1);
                QTest::mouseClick(dialog.findChild<QPushButton *>("create"), Qt::LeftButton);
            });
            driver.action(ActionId::NewTerrain).trigger();
            QTRY_VERIFY(driver.window.workspace().currentTerrain());
            QVERIFY(driver.settle());
            editor::OpenTerrain &document = driver.terrain();
            QCOMPARE(document.terrain().tin().vertexCount(), 31u * 21u);
            QCOMPARE(document.terrain().tin().arrays().layerCount(), 1u);
            QCOMPARE(document.title(), QString("Dunes"));
            QVERIFY(document.path().isEmpty() && !document.isModified() && !document.canReload());
            document.context()->push<tests::RaiseGround>(0.25);
            QVERIFY(driver.window.isWindowModified());
            QVERIFY(driver.action(ActionId::Undo).text().contains("Raise Ground"));
            fingerprint = document.terrain().fingerprint();
            document.save(path);
            QVERIFY(document.isSaving());
            QVERIFY(driver.settle());
            QVERIFY(!document.isModified());
            QVERIFY(document.context()->undoStack().isClean());
            driver.action(ActionId::Undo).trigger();
            QVERIFY(document.isModified());
            driver.action(ActionId::Redo).trigger();
            QVERIFY(!document.isModified());
        }
        tests::WindowDriver driver;
        driver.window.open({path});
        QVERIFY(driver.settle());
        QCOMPARE(driver.terrain().terrain().fingerprint(), fingerprint);
        QCOMPARE(driver.terrain().title(), QString("made"));
        QVERIFY(!driver.terrain().extras().thumbnail.empty());
    }

    void sampleOpensAndIsDrawn()
    {
        tests::WindowDriver driver;
        driver.window.open({QStringLiteral(":/samples/dunes.terrain")});
        QVERIFY(driver.settle());
        QCOMPARE(driver.terrain().title(), editor::sampleName("dunes.terrain"));
        QVERIFY(driver.terrain().path().isEmpty());
        const views::TerrainViewport *viewport = driver.window.workspace().currentTerrain()->viewport();
        QVERIFY(viewport && viewport->isVisible());
        const auto *numbers = driver.window.statusBar()->findChild<QLabel *>("statusNumbers");
        QVERIFY2(numbers->text().contains("120 × 90 m"), qPrintable(numbers->text()));
    }

    void eachKindShowsItsOwnDocksAndActions()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.window.open({makeFile()});
        QVERIFY(driver.settle());
        auto *timeline = driver.window.findChild<views::TimelineDock *>();
        auto *compression = driver.window.findChild<views::CompressionDock *>();
        auto *history = driver.window.findChild<views::HistoryDock *>();
        QVERIFY(!timeline->isVisible() && !compression->isVisible() && history->isVisible());
        QVERIFY(!timeline->toggleViewAction()->isVisible());
        QVERIFY(!driver.action(ActionId::Trim).isVisible() && driver.action(ActionId::ExportTerrain).isEnabled());
        // What the user hides for one kind stays with the other.
        history->hide();
        driver.action(ActionId::PreviousTab).trigger();
        QVERIFY(timeline->isVisible() && compression->isVisible() && history->isVisible());
        QVERIFY(driver.action(ActionId::Trim).isVisible() && !driver.action(ActionId::ExportTerrain).isVisible());
        driver.action(ActionId::NextTab).trigger();
        QVERIFY(!history->isVisible());
    }

    void droppedElevationModelIsImported()
    {
        const QString path = mFolder->filePath("points.xyz");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x)
                file.write(QStringLiteral("%1 %2 %3\n").arg(1000 + x).arg(2000 + y).arg(x * y * 0.25).toUtf8());
        file.close();
        tests::WindowDriver driver;
        driver.window.open({path});
        auto *dialog = driver.window.findChild<views::ImportTerrainDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(!dialog->findChild<QComboBox *>("type")->isVisible()); // of raw files
        dialog->findChild<views::NumberField *>("maxError")->setValue(0);
        QTest::mouseClick(dialog->findChild<QPushButton *>("addLayer"), Qt::LeftButton);
        QTest::mouseClick(dialog->findChild<QPushButton *>("import"), Qt::LeftButton);
        QTRY_VERIFY(driver.window.workspace().currentTerrain());
        QVERIFY(driver.settle());
        const model::terrain::Terrain &terrain = driver.terrain().terrain().terrain();
        QCOMPARE(terrain.geoReference.originX, 1000.0);
        QCOMPARE(terrain.tin.heightAt({4, 4}), 4.0);
        QCOMPARE(terrain.tin.arrays().layerCount(), 1u);
        QCOMPARE(driver.terrain().title(), QString("points"));
    }

    void exportedMeshHasAllOfIt()
    {
        tests::WindowDriver driver;
        driver.window.open({makeFile()});
        QVERIFY(driver.settle());
        driver.action(ActionId::ExportTerrain).trigger();
        views::ExportTerrainDialog *dialog = nullptr;
        QTRY_VERIFY((dialog = driver.window.findChild<views::ExportTerrainDialog *>()) && dialog->isVisible());
        tests::clickButton(*dialog, "Export");
        const QString written = mFolder->filePath("hills.obj");
        QTRY_VERIFY(QFile::exists(written) && !dialog->isExporting());
        QCOMPARE(contentsOf(written).count("\nv "), 21 * 21);
        dialog->close();
    }

    void changedOnDiskIsAskedAbout()
    {
        tests::WindowDriver driver;
        const QString path = makeFile();
        driver.window.open({path});
        QVERIFY(driver.settle());
        driver.terrain().context()->push<tests::RaiseGround>(1);
        QFile file(path);
        QVERIFY(file.open(QIODevice::Append));
        file.write("x");
        file.close();
        QVERIFY(driver.terrain().isChangedOnDisk());
        QString question;
        tests::withNextDialog([&question](QDialog &box) {
            question = qobject_cast<QMessageBox *>(&box)->text();
            tests::clickButton(box, "Cancel");
        });
        driver.action(ActionId::Save).trigger();
        QVERIFY(question.contains("hills.terrain"));
        QVERIFY(driver.terrain().isModified());
        QVERIFY(contentsOf(path).endsWith('x'));
        tests::withNextDialog([](QDialog &box) { tests::clickButton(box, "Replace"); });
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        QVERIFY(!driver.terrain().isModified() && !driver.terrain().isChangedOnDisk());
    }

    void fileThatAnotherHasOpenIsWarnedAbout()
    {
        const QString path = makeFile();
        tests::WindowDriver driver;
        {
            editor::FileLock other;
            other.hold(path);
            QVERIFY(other.holder().isEmpty());
            driver.window.open({path});
            QVERIFY(driver.settle());
            QVERIFY(driver.terrain().holder().contains(QString::number(QCoreApplication::applicationPid())));
            QCOMPARE(driver.window.workspace().messages().texts().size(), 1);
            QVERIFY(driver.window.workspace().messages().texts().constFirst().contains("open elsewhere"));
        }
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QVERIFY(driver.terrain().holder().isEmpty());
        driver.action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(!driver.window.findChild<editor::TerrainTab *>());
        QCOMPARE(QDir(mFolder->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"hills.terrain"});
    }

    void savingThatFailsLeavesDocumentAndFile_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("no folder") << false;
        QTest::newRow("full disk") << true;
    }
    void savingThatFailsLeavesDocumentAndFile()
    {
        QFETCH(bool, isFull);
        const QString path = makeFile();
        const QByteArray before = contentsOf(path);
        tests::WindowDriver driver;
        driver.window.open({path});
        QVERIFY(driver.settle());
        editor::OpenTerrain &document = driver.terrain();
        document.context()->push<tests::RaiseGround>(1);
        document.record().waitUntilWritten();
        const std::uint64_t fingerprint = document.terrain().fingerprint();
        {
            const tests::FileSizeLimit full(isFull ? 1000 : 1'000'000'000);
            document.save(isFull ? path : mFolder->filePath("no/such/folder/x.terrain"));
            QVERIFY(driver.settle());
        }
        QCOMPARE(driver.window.workspace().messages().texts().size(), 1);
        QVERIFY(document.isModified());
        QCOMPARE(document.path(), path);
        QCOMPARE(document.terrain().fingerprint(), fingerprint);
        QCOMPARE(contentsOf(path), before);
        driver.action(ActionId::Save).trigger(); // there is room again
        QVERIFY(driver.settle());
        QVERIFY(!document.isModified());
        QVERIFY(contentsOf(path) != before);
    }

    void editsWhileSavingStayUnsaved()
    {
        tests::WindowDriver driver;
        driver.window.open({makeFile()});
        QVERIFY(driver.settle());
        editor::OpenTerrain &document = driver.terrain();
        document.context()->push<tests::RaiseGround>(1);
        {
            const tests::BusyJobs busy;
            driver.action(ActionId::Save).trigger();
            QTRY_VERIFY(document.savingJob().isRunning());
            document.context()->push<tests::RaiseGround>(2);
        }
        QVERIFY(driver.settle());
        QVERIFY(document.isModified());
        const std::uint64_t fingerprint = document.terrain().fingerprint();
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        QVERIFY(!document.isModified());
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QCOMPARE(document.terrain().fingerprint(), fingerprint);
    }

    void reloadingKeepsTheCamera()
    {
        tests::WindowDriver driver;
        driver.window.open({makeFile()});
        QVERIFY(driver.settle());
        editor::TerrainTab &tab = *driver.window.workspace().currentTerrain();
        model::OrbitCamera camera = tab.viewport()->camera();
        camera.orbit(0.2f, 0.1f);
        tab.viewport()->setCamera(camera);
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QCOMPARE(tab.viewport()->camera().yaw, camera.yaw);
        QVERIFY(tab.viewport()->isVisible());
    }

    void everyFocusableWidgetHasAName()
    {
        tests::WindowDriver driver;
        driver.window.open({makeFile()});
        QVERIFY(driver.settle());
        driver.action(ActionId::NewTerrain).trigger();
        driver.window.findChild<QDialog *>("newTerrainDialog");
        QStringList nameless;
        for (QWidget *widget : driver.window.findChildren<QWidget *>()) {
            if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy())
                continue;
            QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(widget);
            if (!interface || interface->text(QAccessible::Name).isEmpty())
                nameless << QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join('\n')));
        driver.window.findChild<QDialog *>("newTerrainDialog")->reject();
    }
};

SANDREEL_TEST(TestTerrain)
#include "tst_terrain.moc"
