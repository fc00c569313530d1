// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/newterrain.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/docks/terrain/profiledock.h"
#include "views/docks/terrain/profileplot.h"
#include "views/docks/terrain/toolsdock.h"
#include "views/terrain/terrainviewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>

using editor::ActionId;

/// A person at the sandbox: the tools, docks and keys of the window, on the ground of a tab.
class TestSandbox final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    QString makeFile(const QString &name) const
    {
        model::io::NewTerrain description;
        description.width = description.depth = 20;
        description.spacing = 1;
        description.layers = {{model::terrain::material(model::terrain::MaterialPreset::DrySand), 2}};
        const auto terrain = model::io::makeTerrain(description);
        const QString path = mFolder->filePath(name);
        if (!terrain || !model::io::saveTerrain(path, *terrain, {}))
            QTest::qFail("the test file cannot be made", __FILE__, __LINE__);
        return path;
    }
    static views::TerrainViewport &viewport(tests::WindowDriver &driver)
    {
        return *driver.window.workspace().currentTerrain()->viewport();
    }
    /// Where this place of the flat ground is seen.
    static QPoint seen(tests::WindowDriver &driver, double x, double y)
    {
        const double z = driver.terrain().terrain().tin().heightAt({x, y});
        return viewport(driver).placeOf({x, y, z}).value_or(QPointF()).toPoint();
    }
    static void open(tests::WindowDriver &driver, const QString &path)
    {
        driver.window.open({path});
        QVERIFY(driver.settle());
        QTRY_VERIFY(!viewport(driver).isLoading());
    }
    static void press(tests::WindowDriver &driver, double y = 10)
    {
        QTest::mouseMove(&viewport(driver), seen(driver, 6, y));
        QTest::mousePress(&viewport(driver), Qt::LeftButton, {}, seen(driver, 6, y));
        for (double x = 7; x <= 14; x += 1)
            QTest::mouseMove(&viewport(driver), seen(driver, x, y));
    }
    static void draw(tests::WindowDriver &driver, double y = 10)
    {
        press(driver, y);
        QTest::mouseRelease(&viewport(driver), Qt::LeftButton, {}, seen(driver, 14, y));
        // What it set in motion comes to rest, in a time that depends on the machine.
        QTRY_VERIFY_WITH_TIMEOUT(!driver.terrain().context()->hasGesture(), 120'000);
    }

    /// As the shortcut editor finds it.
    static QAction *named(tests::WindowDriver &driver, const QString &name)
    {
        for (const auto &entry : driver.window.actions().entries())
            if (entry.key() == name)
                return entry.action;
        return nullptr;
    }
    /// Pixels that are red: cut.
    static int redOf(const QImage &picture)
    {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                // The deepest place alone is fully red, and how deep that is depends on how the sand slid.
                count += color.red() > 1.1 * color.green() && color.red() > 1.1 * color.blue();
            }
        return count;
    }

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    void strokeIsOneStepUndoneExactlyAndSaved()
    {
        const QString path = makeFile("flat.terrain");
        tests::WindowDriver driver;
        open(driver, path);
        editor::OpenTerrain &document = driver.terrain();
        const std::uint64_t before = document.terrain().tin().fingerprint();
        const double flat = document.terrain().tin().heightAt({10, 10});
        draw(driver);
        // A trace from 6 to 14, and nothing where nobody drew.
        QVERIFY(document.terrain().tin().heightAt({10, 10}) < flat - 1e-3);
        QCOMPARE(document.terrain().tin().heightAt({10, 2}), flat);
        QCOMPARE(document.context()->undoStack().count(), 1);
        QVERIFY(document.terrain().tin().arrays().totals.vertices > 21 * 21);
        const std::uint64_t after = document.terrain().tin().fingerprint();
        driver.action(ActionId::Undo).trigger();
        QCOMPARE(document.terrain().tin().fingerprint(), before);
        driver.action(ActionId::Redo).trigger();
        QCOMPARE(document.terrain().tin().fingerprint(), after);

        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        const std::uint64_t saved = document.terrain().fingerprint();
        tests::WindowDriver again;
        open(again, path);
        QCOMPARE(again.terrain().terrain().fingerprint(), saved);
    }

    void rightClickTakesTheStrokeBack()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        const std::uint64_t before = driver.terrain().terrain().tin().fingerprint();
        press(driver);
        QVERIFY(driver.terrain().terrain().tin().fingerprint() != before);
        QTest::mousePress(&viewport(driver), Qt::RightButton, {}, seen(driver, 14, 10));
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), before);
        QCOMPARE(driver.terrain().context()->undoStack().count(), 0);
        QVERIFY(!driver.terrain().isModified());
    }

    void undoInTheMidstOfAStrokeTakesAllOfIt()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        const std::uint64_t before = driver.terrain().terrain().tin().fingerprint();
        press(driver);
        QTest::qWait(100); // sand slides
        driver.action(ActionId::Undo).trigger();
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), before);
        QTest::mouseMove(&viewport(driver), seen(driver, 5, 5));
        QTest::mouseRelease(&viewport(driver), Qt::LeftButton, {}, seen(driver, 5, 5));
        QTest::qWait(50);
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), before);
    }

    void withoutSculptTheMouseTurnsThePicture()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        const std::uint64_t before = driver.terrain().terrain().tin().fingerprint();
        const float yaw = viewport(driver).camera().yaw;
        driver.action(ActionId::Sculpt).trigger();
        press(driver);
        QTest::mouseRelease(&viewport(driver), Qt::LeftButton, {}, {10, 10});
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), before);
        QVERIFY(viewport(driver).camera().yaw != yaw);
    }

    void tabsComeAndGoInTheMidstOfStrokes()
    {
        const QString path = makeFile("flat.terrain");
        tests::WindowDriver driver;
        open(driver, path);
        press(driver);
        driver.window.open({makeFile("other.terrain")}); // hiding the tab cancels the stroke
        QVERIFY(driver.settle());
        driver.action(ActionId::PreviousTab).trigger();
        QVERIFY(!driver.terrain().isModified());
        press(driver);
        driver.terrain().reload();
        QVERIFY(driver.settle());
        QVERIFY(!driver.terrain().isModified());
        draw(driver); // the new ground takes strokes again
        QCOMPARE(driver.terrain().context()->undoStack().count(), 1);
        driver.action(ActionId::NextTab).trigger();
        driver.action(ActionId::CloseTab).trigger();
        QTRY_COMPARE(driver.window.findChildren<editor::TerrainTab *>().size(), 1);
        auto *erosion = driver.window.findChild<views::ErosionDock *>();
        QVERIFY(erosion && erosion->isVisible());
    }

    void statusBarReadsTheGround()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        QTest::mouseMove(&viewport(driver), seen(driver, 5, 5));
        const auto texts = [&driver] {
            QStringList all;
            for (const QLabel *label : driver.window.statusBar()->findChildren<QLabel *>())
                all << label->text();
            return all.join('\n');
        };
        QTRY_VERIFY2(texts().contains("slope"), qPrintable(texts()));
        QVERIFY2(texts().contains(QLocale().toString(0.0, 'f', 1)), qPrintable(texts()));
        QVERIFY2(texts().contains("Dry sand", Qt::CaseInsensitive), qPrintable(texts()));
    }

    void groundIsDrawnAsTheMenuSays()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        auto *height = driver.window.findChild<QAction *>("ground.height");
        auto *contours = driver.window.findChild<QAction *>("ground.contours");
        QVERIFY(height && contours && height->isEnabled() && !height->isChecked() && !contours->isChecked());
        QVERIFY(driver.window.findChild<QAction *>("ground.material")->isChecked());
        height->trigger();
        contours->trigger();
        QVERIFY(viewport(driver).style().overlay == views::GroundOverlay::Height);
        QVERIFY(viewport(driver).style().hasContours);
        driver.window.open({makeFile("other.terrain")});
        QVERIFY(driver.settle());
        QVERIFY(viewport(driver).style().overlay == views::GroundOverlay::Height);
        driver.window.findChild<QAction *>("ground.material")->trigger();
        contours->trigger();
        QVERIFY(viewport(driver).style().overlay == views::GroundOverlay::None);
        QVERIFY(!viewport(driver).style().hasContours);
    }

    void everyToolIsAnAction()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        auto *dock = driver.window.findChild<views::ToolsDock *>();
        const views::ToolSettings fresh;
        for (const model::terrain::Tool &tool : fresh.tools()) {
            const QString name = QStringLiteral("tool.") + nameOf(tool);
            auto *action = named(driver, name);
            QVERIFY2(action && action->isEnabled() && !action->icon().isNull(), qPrintable(name));
            action->trigger();
            QVERIFY(action->isChecked());
            QVERIFY(dock->findChild<QToolButton *>(name)->isChecked());
            const auto &entries = driver.window.actions().entries();
            QVERIFY(
                std::any_of(entries.begin(), entries.end(), [&](const auto &entry) { return entry.key() == name; }));
        }
        // And the other way round.
        dock->findChild<QToolButton *>("tool.rake")->click();
        QVERIFY(named(driver, "tool.rake")->isChecked());
        QCOMPARE(named(driver, "tool.noise")->shortcut(), QKeySequence(Qt::Key_7));
    }

    void menuDoesWhatTheDocksDo()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        const auto radius = [&] {
            for (const QLineEdit *line : driver.window.findChild<views::ToolsDock *>()->findChildren<QLineEdit *>())
                if (line->accessibleName() == "Radius")
                    return QLocale().toDouble(line->text());
            return 0.0;
        };
        const double before = radius();
        QVERIFY(before > 0);
        named(driver, "terrain.bigger")->trigger();
        QVERIFY(std::abs(radius() / before - 1.1) < 1e-3);
        named(driver, "terrain.smaller")->trigger();
        QVERIFY(std::abs(radius() / before - 1) < 1e-3);
        named(driver, "symmetry.both")->trigger();
        auto *symmetry = driver.window.findChild<QComboBox *>("symmetry");
        QCOMPARE(symmetry->currentIndex(), 3);
        named(driver, "symmetry.off")->trigger();
        QCOMPARE(symmetry->currentIndex(), 0);
        named(driver, "terrain.slide")->trigger();
        QVERIFY(!driver.window.findChild<QCheckBox *>("whileDrawing")->isChecked());

        // A heap that does not stand.
        auto &context = *driver.terrain().context();
        context.push<commands::EditSurface>("Raise", [](model::terrain::TinEdit &edit) {
            edit.setHeight(edit.tin().arrays().vertex(model::terrain::cornerOf(edit.tin().triangleAt({10, 10}), 0)), 9);
        });
        const std::uint64_t steep = driver.terrain().terrain().tin().fingerprint();
        QAction *run = named(driver, "terrain.run");
        run->trigger();
        QVERIFY(run->text().contains("Pause") && !named(driver, "terrain.step")->isEnabled());
        QTRY_VERIFY(driver.terrain().terrain().tin().fingerprint() != steep);
        if (run->text().contains("Pause")) // it may have come to rest
            run->trigger();
        QVERIFY(run->text().contains("Run"));
        named(driver, "terrain.settle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!driver.window.findChild<views::ErosionDock *>()->isSettling(), 60'000);
        context.undoStack().setIndex(1);
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), steep);
    }

    void keysDrawOnTheGroundAndSayWhereTheyAre()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        editor::OpenTerrain &document = driver.terrain();
        const std::uint64_t before = document.terrain().tin().fingerprint();
        viewport(driver).setFocus();
        const float yaw = viewport(driver).camera().yaw;
        QTest::keyClick(&viewport(driver), Qt::Key_Left);
        const QString first = viewport(driver).accessibleDescription();
        QVERIFY2(first.contains("height"), qPrintable(first));
        QTest::keyClick(&viewport(driver), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(viewport(driver).accessibleDescription() != first);
        QCOMPARE(viewport(driver).camera().yaw, yaw);
        QTest::keyClick(&viewport(driver), Qt::Key_Left, Qt::ControlModifier); // with Ctrl they are the camera's
        QVERIFY(viewport(driver).camera().yaw != yaw);
        QTest::keyClick(&viewport(driver), Qt::Key_Space);
        QTest::keyClick(&viewport(driver), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&viewport(driver), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&viewport(driver), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!document.context()->hasGesture(), 120'000);
        QCOMPARE(document.context()->undoStack().count(), 1);
        QVERIFY(document.terrain().tin().fingerprint() != before);
        driver.action(ActionId::Undo).trigger();
        QCOMPARE(document.terrain().tin().fingerprint(), before);
        QTest::keyClick(&viewport(driver), Qt::Key_Return);
        QTest::keyClick(&viewport(driver), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&viewport(driver), Qt::Key_Escape);
        QCOMPARE(document.terrain().tin().fingerprint(), before);
    }

    void cutAndFillAndRestoreGoByTheLastSave()
    {
        const QString path = makeFile("flat.terrain");
        tests::WindowDriver driver;
        open(driver, path);
        named(driver, "ground.cutAndFill")->trigger();
        QVERIFY(viewport(driver).style().overlay == views::GroundOverlay::CutAndFill);
        const QImage flat = viewport(driver).renderPicture({320, 240});
        draw(driver);
        const QImage cut = viewport(driver).renderPicture({320, 240});
        QVERIFY(cut != flat);
        QVERIFY2(redOf(flat) == 0 && redOf(cut) > 20, qPrintable(QString::number(redOf(cut))));
        // What is saved is what it compares with from then on: one colour again.
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        QTRY_VERIFY(redOf(viewport(driver).renderPicture({320, 240})) < redOf(cut) / 4);
        draw(driver, 5); // where nothing slides into an older trace
        QTRY_VERIFY(redOf(viewport(driver).renderPicture({320, 240})) > redOf(cut) / 4);
        named(driver, "terrain.reference")->trigger();
        QTRY_VERIFY(redOf(viewport(driver).renderPicture({320, 240})) < redOf(cut) / 4);
    }

    void crossSectionIsPickedOnTheGround()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        auto *dock = driver.window.findChild<views::ProfileDock *>();
        QVERIFY(dock->isHidden());
        QAction *pick = named(driver, "terrain.pickProfile");
        pick->trigger();
        QVERIFY(dock->isVisible());
        QTest::qWait(300); // the picture has become smaller
        const std::uint64_t before = driver.terrain().terrain().tin().fingerprint();
        press(driver);
        QTest::mouseRelease(&viewport(driver), Qt::LeftButton, {}, seen(driver, 14, 10));
        QCOMPARE(driver.terrain().terrain().tin().fingerprint(), before);
        const auto &now = dock->plot().now();
        QVERIFY(now.size() > 8 && std::abs(now.back().distance - 8) < 0.3);
        // A tool takes the button back; the line stays, and the curve follows.
        named(driver, "tool.imprint")->trigger();
        QVERIFY(!pick->isChecked());
        draw(driver);
        QVERIFY(driver.terrain().terrain().tin().fingerprint() != before);
        QTRY_VERIFY(*heightAt(dock->plot().now(), 4) < *heightAt(dock->plot().before(), 4) - 1e-3);
        dock->close();
        QVERIFY(!pick->isChecked());
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Discard"); });
        driver.action(ActionId::CloseTab).trigger();
    }

    void scoopSaysHowMuch()
    {
        tests::WindowDriver driver;
        open(driver, makeFile("flat.terrain"));
        named(driver, "tool.scoop")->trigger();
        draw(driver);
        const QString text = driver.window.statusBar()->currentMessage();
        QVERIFY2(text.contains("m³") || text.contains(" l"), qPrintable(text));
    }
};

SANDREEL_TEST(TestSandbox)
#include "tst_sandbox.moc"
