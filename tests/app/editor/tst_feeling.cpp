// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/shortcutdialog.h"
#include "app/editor/sandbox/feeling.h"
#include "model/io/terrain/newterrain.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"
#include "views/haptics/forcearrow.h"
#include "views/haptics/hapticsdock.h"
#include "views/terrain/terrainviewport.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSettings>
#include <QUndoStack>
#include <QWheelEvent>

/// A person with a haptic device at the window: the simulated one, moved by the mouse.
class TestFeeling final : public QObject
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

    /// A window with a flat terrain, and its sand at rest.
    struct Driver : tests::WindowDriver
    {
        explicit Driver(const QString &path)
        {
            views::FlowSettings flow = window.sandbox().settings().flow();
            flow.isOn = false;
            window.sandbox().settings().setFlow(flow);
            window.open({path});
            QVERIFY(settle());
            QTRY_VERIFY(!viewport().isLoading());
        }
        editor::Feeling &feeling() { return window.sandbox().feeling(); }
        views::HapticsSession &session() { return feeling().session(); }
        views::TerrainViewport &viewport() { return *window.workspace().currentTerrain()->viewport(); }
        QPoint seen(double x, double y)
        {
            const double z = terrain().terrain().tin().heightAt({x, y});
            return viewport().placeOf({x, y, z}).value_or(QPointF()).toPoint();
        }
        void moveTo(double x, double y)
        {
            const QPointF place = seen(x, y);
            QMouseEvent event(QEvent::MouseMove, place, viewport().mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                              Qt::NoModifier);
            QCoreApplication::sendEvent(&viewport(), &event);
        }
        void turnWheel(int notches)
        {
            const QPointF place = seen(10, 10);
            QWheelEvent wheel(place, viewport().mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&viewport(), &wheel);
        }
        bool isToolAt(double x, double y)
        {
            const model::terrain::Point3 tool = session().toolPlace();
            return std::hypot(tool.x - x, tool.y - y) < 0.2; // pixels
        }
        /// The mouse feels, forces are wanted.
        void begin()
        {
            feeling().modeAction().trigger();
            QVERIFY(session().service().simulated());
            feeling().forcesAction().trigger();
            QVERIFY(session().wantsForces());
        }
    };

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    void startsWithoutDeviceAndForces()
    {
        Driver driver(makeFile("flat.terrain"));
        QVERIFY(!driver.session().service().isOpen());
        QVERIFY(!driver.session().wantsForces());
        QVERIFY(!driver.feeling().forcesAction().isEnabled());
        QVERIFY(driver.feeling().dock().isHidden());
        driver.feeling().modeAction().trigger();
        QVERIFY(driver.feeling().dock().isVisible());
        QVERIFY(driver.session().service().isOpen());
        QVERIFY(!driver.session().wantsForces()); // not with the device: they are asked for
    }

    void mouseMovesPressesAndDraws()
    {
        Driver driver(makeFile("flat.terrain"));
        const double flat = driver.terrain().terrain().tin().heightAt({10, 10});
        driver.begin();
        driver.moveTo(6, 10);
        QTRY_VERIFY(driver.isToolAt(6, 10));
        QTRY_VERIFY(driver.session().now().depth < 0); // once the ground there has come
        driver.turnWheel(-15);
        QTRY_VERIFY(driver.session().now().depth > 0);
        auto *arrow = driver.viewport().findChild<views::ForceArrow *>();
        QVERIFY(arrow);
        QTRY_VERIFY(arrow->isVisible() && arrow->shape());
        QVERIFY((arrow->shape()->ground - QPointF(driver.seen(6, 10))).manhattanLength() < 5);
        QVERIFY(arrow->shape()->tool.y() > arrow->shape()->ground.y()); // below the ground

        QTest::mousePress(&driver.viewport(), Qt::LeftButton, {}, driver.seen(6, 10));
        QTRY_VERIFY(driver.session().isStroking());
        for (double x = 7; x <= 14; x += 1) {
            driver.moveTo(x, 10);
            QTRY_VERIFY(driver.isToolAt(x, 10));
        }
        QTest::mouseRelease(&driver.viewport(), Qt::LeftButton, {}, driver.seen(14, 10));
        QTRY_VERIFY(!driver.session().isStroking() && !driver.terrain().context()->hasGesture());
        QVERIFY(driver.terrain().terrain().tin().heightAt({10, 10}) < flat - 1e-3);
        QCOMPARE(driver.terrain().context()->undoStack().count(), 1);
        driver.action(editor::ActionId::Undo).trigger();
        QCOMPARE(driver.terrain().terrain().tin().heightAt({10, 10}), flat);
    }

    void everyWayToStopStops()
    {
        Driver driver(makeFile("flat.terrain"));
        driver.begin();
        auto *inStatusBar = driver.window.findChild<QPushButton *>(QStringLiteral("stopForces"));
        auto *inDock = driver.feeling().dock().findChild<QPushButton *>(QStringLiteral("stop"));
        QVERIFY(inStatusBar && inStatusBar->isVisible() && inDock && inDock->isVisible());
        QTest::mouseClick(inStatusBar, Qt::LeftButton);
        QVERIFY(!driver.session().wantsForces());
        QVERIFY(!inStatusBar->isVisible());
        QVERIFY(!driver.feeling().forcesAction().isChecked());

        driver.session().setForces(true);
        QTest::mouseClick(inDock, Qt::LeftButton);
        QVERIFY(!driver.session().wantsForces());

        driver.session().setForces(true);
        driver.feeling().stopAction().trigger();
        QVERIFY(!driver.session().wantsForces());

        driver.session().setForces(true);
        driver.viewport().setFocus();
        QTest::keyClick(&driver.viewport(), Qt::Key_Escape);
        QVERIFY(!driver.session().wantsForces());

        driver.session().setForces(true);
        tests::withNextDialog([&](QDialog &dialog) {
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QVERIFY(!driver.session().wantsForces());
        });
        driver.action(editor::ActionId::ConfigureShortcuts).trigger();
        QTRY_VERIFY(!driver.session().wantsForces());

        driver.session().setForces(true);
        driver.feeling().dock().close();
        QVERIFY(!driver.session().wantsForces());
        QTRY_COMPARE(driver.session().now().state, model::haptics::SafetyState::Stopped);
        QCOMPARE(driver.session().service().simulated()->lastForce(), model::Vec3d());
    }

    void unplugInTheMidstOfAStrokeEndsIt()
    {
        Driver driver(makeFile("flat.terrain"));
        driver.begin();
        driver.turnWheel(-15);
        driver.moveTo(6, 10);
        QTRY_VERIFY(driver.isToolAt(6, 10)); // a button that is down before anybody has looked has to be let go
        QTest::mousePress(&driver.viewport(), Qt::LeftButton, {}, driver.seen(6, 10));
        driver.moveTo(8, 10);
        QTRY_VERIFY(driver.session().isStroking() && driver.isToolAt(8, 10));
        driver.session().service().simulated()->setConnected(false);
        QTRY_VERIFY(!driver.session().isStroking());
        QVERIFY(!driver.session().wantsForces());
        QTRY_COMPARE(driver.session().service().simulated()->lastForce(), model::Vec3d());
        QTRY_VERIFY(!driver.terrain().context()->hasGesture());
        QCOMPARE(driver.terrain().context()->undoStack().count(), 1);
    }

    void anotherTabOrNoneStopsTheForces()
    {
        Driver driver(makeFile("flat.terrain"));
        driver.begin();
        driver.window.open({makeFile("other.terrain")});
        QVERIFY(driver.settle());
        QTRY_VERIFY(!driver.session().wantsForces());
        QVERIFY(driver.session().hasTerrain());
        driver.session().setForces(true);
        driver.action(editor::ActionId::CloseTab).trigger();
        QTRY_VERIFY(!driver.session().wantsForces());
        driver.session().setForces(true);
        driver.action(editor::ActionId::CloseTab).trigger();
        QTRY_VERIFY(!driver.session().hasTerrain());
        QVERIFY(!driver.session().wantsForces());
        QVERIFY(!driver.feeling().modeAction().isEnabled());
    }

    void reloadInTheMidstOfAStroke()
    {
        Driver driver(makeFile("flat.terrain"));
        driver.begin();
        driver.turnWheel(-15);
        driver.moveTo(6, 10);
        QTRY_VERIFY(driver.isToolAt(6, 10)); // a button that is down before anybody has looked has to be let go
        QTest::mousePress(&driver.viewport(), Qt::LeftButton, {}, driver.seen(6, 10));
        QTRY_VERIFY(driver.session().isStroking());
        driver.terrain().reload();
        QVERIFY(driver.settle());
        QVERIFY(!driver.session().isStroking());
        QVERIFY(!driver.session().wantsForces());
        driver.moveTo(12, 10); // the hand is at the new ground
        QTRY_VERIFY(driver.isToolAt(12, 10));
    }

    void modesTakeTurns()
    {
        Driver driver(makeFile("flat.terrain"));
        driver.feeling().modeAction().trigger();
        driver.window.sandbox().maskAction().trigger();
        QVERIFY(!driver.feeling().modeAction().isChecked());
        driver.feeling().modeAction().trigger();
        QVERIFY(!driver.window.sandbox().maskAction().isChecked());
        driver.feeling().modeAction().trigger(); // off: the mouse draws by itself, the device stays
        const double flat = driver.terrain().terrain().tin().heightAt({10, 10});
        QTest::mouseClick(&driver.viewport(), Qt::LeftButton, {}, driver.seen(10, 10));
        QVERIFY(driver.terrain().terrain().tin().heightAt({10, 10}) < flat);
        QVERIFY(driver.session().service().isOpen());
    }
};

SANDREEL_TEST(TestFeeling)
#include "tst_feeling.moc"
